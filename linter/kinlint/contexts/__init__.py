"""The JSON-LD contexts that models may name: bundled releases, and those of the user."""
