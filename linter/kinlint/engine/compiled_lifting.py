"""Lifting queries that a catalogue brings compiled, for those who lift."""

RECALLED: dict[str, str] = {}
"""The queries of each format, as JSON; they must belong to the files of this installation."""
