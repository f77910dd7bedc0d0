"""Configuration: settings, the files that hold them, and the rules they select."""
