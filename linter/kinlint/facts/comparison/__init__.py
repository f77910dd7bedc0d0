"""Comparison of two descriptions of one robot: which parts correspond, and how they differ."""
