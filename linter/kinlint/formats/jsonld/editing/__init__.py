"""Writes changes of a graph into the JSON-LD text that it was read from."""
