"""Holds rules to the promises of their files."""
