"""Runs the stages of an analysis: read, load, lift, close, compute facts, check and conclude."""
