"""Finds the files that are meant."""
