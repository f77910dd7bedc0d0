"""Suppressions: which findings they silence, and which of them are faulty."""
