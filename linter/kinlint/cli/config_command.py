"""`kinlint config`: tells what may stand in a configuration."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator, Sequence

from kinlint.cli.argument_parser import Parser
from kinlint.configuration.json_schema import schema
from kinlint.configuration.keys import KEYS
from kinlint.errors import UsageError
from kinlint.suggestion import did_you_mean


def parser() -> Parser:
    """The parser of `kinlint config`."""
    made = Parser(
        prog="kinlint config",
        description="List the keys of kinlint.toml and of [tool.kinlint] in pyproject.toml, or"
        " describe some of them.",
        usage="kinlint config [KEY...] [--schema]",
    )
    made.add_positionals("keys", "KEY", "keys to describe")
    made.add_argument("--schema", action="store_true", help="print the JSON schema")
    return made


def run(arguments: Sequence[str]) -> int:
    """Print what *arguments* ask for; the exit code."""
    options = parser().read(arguments)
    if options.schema and options.keys:
        raise UsageError(f"--schema is about all keys, '{options.keys[0]}' among them")
    if options.schema:
        sys.stdout.write(f"{json.dumps(schema(), indent=2)}\n")
        return 0
    for key in options.keys:
        if key not in KEYS:
            raise UsageError(f"unknown key '{key}'{did_you_mean(key, KEYS)}")
    if options.keys:
        sys.stdout.write("\n".join("".join(_page(key)) for key in dict.fromkeys(options.keys)))
    else:
        width = max(map(len, KEYS))
        sys.stdout.writelines(f"{name:<{width}}  {key.meaning}\n" for name, key in KEYS.items())
    return 0


def _page(name: str) -> Iterator[str]:
    key = KEYS[name]
    yield f"{name}\n\n{key.meaning}\n\n"
    yield f"type:    {key.kind.name}\n"
    yield f"default: {key.default}\n"
    yield f"example: {key.example}\n"
