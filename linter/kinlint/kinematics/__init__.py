"""Kinematic structure of robots, as the store of an analysis has it."""
