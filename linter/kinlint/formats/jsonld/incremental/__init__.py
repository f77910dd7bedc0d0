"""Reads a JSON-LD file again of which a little has changed."""
