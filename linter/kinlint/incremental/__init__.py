"""Examines a model again after a small change, and looks only at what the change touches."""
