"""Puts tests/ on the import path, so that tests find what they share (data.py)."""
