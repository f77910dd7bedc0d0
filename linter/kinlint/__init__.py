"""kinlint: a linter for robot descriptions, with rules written in SHACL and SPARQL."""

__version__ = "0.1.0"
