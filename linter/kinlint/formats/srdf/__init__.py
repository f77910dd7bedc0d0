"""SRDF, the Semantic Robot Description Format of MoveIt."""
