"""Follows a small change of a model through the stages of its analysis."""
