"""Compiled expansion: what nearly all models consist of, without an expanded form in between."""
