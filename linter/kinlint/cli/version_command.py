"""`kinlint version`, when it is given arguments."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from pathlib import Path

from kinlint import __version__
from kinlint.cli.argument_parser import Parser

LIBRARIES = (
    "pyoxigraph", "rdflib", "pyshacl", "owlrl", "pyld", "rich", "pygls", "lsprotocol", "xacro",
)  # fmt: skip
"""The distributions that decide what kinlint does."""


def parser() -> Parser:
    """The parser of `kinlint version`."""
    made = Parser(
        prog="kinlint version",
        description="Print the version; with -v everything that a bug report needs.",
    )
    made.add_argument(
        "-v", "--verbose", action="store_true", help="also of Python, libraries and the system"
    )
    return made


def run(arguments: list[str]) -> int:
    """Print the version, and if asked what it runs on; the exit code."""
    options = parser().read(arguments)
    sys.stdout.write(f"kinlint {__version__}\n")
    if options.verbose:
        facts = list(_facts())
        width = max(len(name) for name, _ in facts) + 1
        sys.stdout.writelines(f"{name + ':':<{width}} {what}\n" for name, what in facts)
    return 0


def _facts() -> Iterator[tuple[str, str]]:
    """Yield names and versions of what kinlint runs on, without importing any of it."""
    import platform  # noqa: PLC0415  slow, rare

    from kinlint import resources  # noqa: PLC0415
    from kinlint.catalogue.rulebook import built_in  # noqa: PLC0415
    from kinlint.project.layers import cache_directory  # noqa: PLC0415

    python = f"{platform.python_version()} ({platform.python_implementation()})"
    yield "python", f"{python} at {_shown(Path(sys.executable))}"
    yield "platform", platform.platform()
    yield from ((name, _version(name)) for name in LIBRARIES)
    digest, number = built_in()
    yield "rules", f"{number} at {_shown(resources.data('rules'))}, hash {digest}"
    yield "shapes", _shown(resources.data("shapes"))
    yield "cache", _shown(cache_directory(os.environ))
    yield "configuration", _configuration()
    told = sorted(name for name in os.environ if name.startswith("KINLINT_"))
    yield "environment", ", ".join(told) or "no KINLINT_ variable"


def _configuration() -> str:
    """Return the name of the configuration that governs the working directory."""
    from kinlint.cli.project_rules import found_config  # noqa: PLC0415
    from kinlint.errors import ConfigError  # noqa: PLC0415
    from kinlint.files.pathglob import absolute  # noqa: PLC0415

    try:
        config = found_config(trust=False)
    except ConfigError as error:
        return str(error)
    return "none here" if config is None else _shown(absolute(config.origin))


def _shown(path: Path) -> str:
    """Return *path* with the home directory abbreviated to `~`."""
    try:
        return str(Path("~") / path.relative_to(Path.home()))
    except (RuntimeError, ValueError):
        return str(path)


def _version(distribution: str) -> str:
    from importlib.metadata import PackageNotFoundError, version  # noqa: PLC0415

    try:
        return version(distribution)
    except PackageNotFoundError:
        return "not installed"
