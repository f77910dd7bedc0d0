"""Edits of files in XML: the changes of the format layer, written where they belong."""
