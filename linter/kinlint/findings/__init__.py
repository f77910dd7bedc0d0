"""Findings from results of an engine: their messages, places and groups."""
