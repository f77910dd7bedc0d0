"""Runs kinlint as a linter of ament."""
