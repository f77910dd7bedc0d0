"""Reads JSON-LD 1.1 with the exact place of every triple and node."""
