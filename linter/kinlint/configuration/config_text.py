"""The text of a configuration file, and what it says, unchecked."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from kinlint.errors import ConfigError
from kinlint.files.pathname import shown
from kinlint.light_dataclasses import dataclass
from kinlint.text import SourceText, Span

BOM = "\ufeff"
PROJECT = "pyproject.toml"
NAME = b"kinlint"
"""Word that is somewhere in every `pyproject.toml` that configures kinlint."""


@dataclass(frozen=True, slots=True)
class ConfigText:
    """The table of kinlint in a configuration file, and the whole text of the file."""

    values: Mapping[str, Any]
    """Contents of the table of kinlint."""
    source: SourceText
    """Whole text of the file."""


def read(path: Path) -> ConfigText | None:
    """Parse the file at *path*; None for a `pyproject.toml` that does not configure kinlint.

    Raises `ConfigError` if it is no TOML, with the line and column.
    """
    name = shown(path)
    try:
        raw = path.read_bytes()
        if path.name == PROJECT and NAME not in raw:
            return None
        text = raw.decode("utf-8")
    except OSError as error:
        raise ConfigError(f"{name}: {error.strerror or error}") from None
    except UnicodeDecodeError:
        raise ConfigError(f"{name}: not UTF-8") from None
    import tomllib  # noqa: PLC0415  most runs have no configuration

    source = SourceText(name, text.removeprefix(BOM), bom=text.startswith(BOM))
    try:
        said: dict[str, Any] = tomllib.loads(source.text)
    except tomllib.TOMLDecodeError as error:
        place, cause = _placed(str(error), source)
        raise ConfigError(f"{name}:{place}: not TOML: {cause}") from None
    except RecursionError:
        raise ConfigError(f"{name}: not TOML: nested too deeply") from None
    if path.name != PROJECT:
        return ConfigText(said, source)
    tool = said.get("tool", {})
    own = tool.get("kinlint") if isinstance(tool, dict) else None
    if own is not None and not isinstance(own, dict):
        raise ConfigError(f"{name}: tool.kinlint: expected a table")
    return None if own is None else ConfigText(own, source)


def quoted_key_span(source: SourceText, key: str) -> Span:
    """Return the span of the first *key* in *source*, quotes included.

    An empty span if there is none.
    """
    for written in (f'"{key}"', f"'{key}'", key):
        at = source.text.find(written)
        if at >= 0:
            return Span(at, at + len(written))
    return Span(0, 0)


def _placed(message: str, source: SourceText) -> tuple[str, str]:
    """The line and column that end the *message* of tomllib, and what it says before."""
    cause, _, place = message.rpartition(" (at ")
    numbers = re.findall(r"\d+", place) or source.position(len(source.text.rstrip()))
    return ":".join(map(str, numbers)), cause or message
