"""JSON that remembers where it was written."""
