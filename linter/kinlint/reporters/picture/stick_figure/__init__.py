"""Stick figures: robots in three dimensions with all joints at zero, and the findings on them."""
