"""Writes suppressions of findings into the texts that they were found in."""
