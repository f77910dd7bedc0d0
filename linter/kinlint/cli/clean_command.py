"""`kinlint clean`: removes what earlier runs kept."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence

from kinlint.cache.removal import clear
from kinlint.cli.argument_parser import Parser, non_empty
from kinlint.errors import UsageError
from kinlint.project.layers import cache_directory
from kinlint.reporters.summary import plural

MEGA = 2**20


def parser() -> Parser:
    """The parser of `kinlint clean`."""
    made = Parser(
        prog="kinlint clean",
        description="Delete the cache: reports and compiled rules of earlier runs.",
    )
    made.add_argument("--cache-dir", type=non_empty, metavar="DIR", help="cache directory")
    return made


def run(arguments: Sequence[str]) -> int:
    """Remove the cache; the exit code. Raises `UsageError` if something cannot be removed."""
    options = parser().read(arguments)
    directory = cache_directory(os.environ, options.cache_dir)
    try:
        cleared = clear(directory)
    except OSError as error:
        raise UsageError(f"cannot remove {error.filename}: {error.strerror}") from None
    what = [
        plural(number, name)
        for number, name in ((cleared.reports, "report"), (cleared.catalogues, "catalogue"))
        if number
    ]
    said = f"Removed {' and '.join(what)} ({cleared.size / MEGA:.1f} MiB) from" if what else None
    sys.stdout.write(f"{said or 'Nothing to remove in'} {directory}\n")
    return 0
