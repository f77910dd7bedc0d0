"""Reasons why something cannot be renamed."""

from __future__ import annotations


class NotRenamable(Exception):
    """Error: something cannot be renamed; the message says why, for the user."""
