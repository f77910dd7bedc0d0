"""Known findings: those of a baseline, or of an earlier revision."""
