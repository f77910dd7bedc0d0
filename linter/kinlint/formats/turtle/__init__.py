"""Reads Turtle, with the place of every term."""
