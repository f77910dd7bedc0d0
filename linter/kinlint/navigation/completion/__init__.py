"""Completion in texts that are being typed."""
