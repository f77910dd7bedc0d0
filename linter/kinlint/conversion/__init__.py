"""Writes what is lifted from a robot as a composable model."""
