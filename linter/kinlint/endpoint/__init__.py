"""Models in a triple store: loading them there, and checking them from there."""
