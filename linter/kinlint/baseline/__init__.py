"""Which findings were known before: in a baseline, or at an earlier revision."""
