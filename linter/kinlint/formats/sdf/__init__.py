"""Reads SDF: what its files say, what they include, and what the names in them stand for."""
