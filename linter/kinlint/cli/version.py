"""`kinlint version`, when it is given arguments."""

from __future__ import annotations

import sys

from kinlint import __version__
from kinlint.cli.parser import Parser


def run(arguments: list[str]) -> int:
    """Print the version."""
    Parser(prog="kinlint version", description="Show the version.").read(arguments)
    sys.stdout.write(f"kinlint {__version__}\n")
    return 0
