"""A context as an entry of a configuration file."""

from __future__ import annotations

import json
import re
from pathlib import Path

from kinlint.configuration.config_file import NAMES, parse_config
from kinlint.configuration.config_text import PROJECT, read
from kinlint.errors import ConfigError, UsageError
from kinlint.files.packages import working_copies
from kinlint.files.pathglob import absolute
from kinlint.files.pathname import real, shown
from kinlint.light_dataclasses import dataclass
from kinlint.uri_references import split_uri

KEY = "extra-contexts"
DEFAULT, FOLDER = "kinlint.toml", "contexts"
_UNSAFE = re.compile(r"[^\w.-]+")


@dataclass(frozen=True)
class ContextEntry:
    """The place of a context in the configuration of a project."""

    config: Path
    """The configuration file."""
    path: Path
    """The file of the context."""
    text: str | None
    """The text of the configuration file with the entry; None if it has that already."""

    @classmethod
    def for_iri(cls, iri: str, here: Path) -> ContextEntry:
        """Return the entry for *iri* in the configuration nearest to the directory *here*.

        Raises `UsageError` or `ConfigError` if that cannot be written.
        """
        file = _file_above(here) or here / DEFAULT
        text = file.read_text(encoding="utf-8") if file.exists() else ""
        values = _values(text, file)
        known = values.get(KEY)
        if isinstance(known, str | list):
            directory = file.parent / (known if isinstance(known, str) else known[0])
            return cls(file, _inside(directory / _by_address(iri), file), None)
        if isinstance(known, dict) and iri in known:
            return cls(file, _inside(file.parent / known[iri], file), None)
        relative = f"{FOLDER}/{_by_address(iri)}"
        new = _with_entry(text, file, f"{json.dumps(iri)} = {json.dumps(relative)}\n")
        after = parse_config(_values(new, file), shown(file), file.parent)
        if iri not in (after.extra_contexts or {}):
            raise UsageError(f"{shown(file)}: write {KEY} as a table of its own, then add again")
        return cls(file, _inside(file.parent / relative, file), new)


def _inside(path: Path, config: Path) -> Path:
    """Return *path*, which lies in the project of the file *config*, links followed.

    Raises `UsageError` if it does not: a project of others says where to write.
    """
    roots = (config.parent, *working_copies(absolute(config.parent)))
    if not any(real(path).is_relative_to(real(root)) for root in roots):
        raise UsageError(f"{shown(config)}: {KEY}: {shown(path)} is outside of the project")
    return path


def _by_address(iri: str) -> str:
    """Return a path without special characters for *iri*: its host and path."""
    parts = split_uri(iri)
    steps = [parts.netloc, *parts.path.split("/")]
    safe = [_UNSAFE.sub("-", step) for step in steps if step.strip(".")]
    return "/".join(safe) or "context.json"


def _values(text: str, file: Path) -> dict[str, object]:
    import tomllib  # noqa: PLC0415  few runs ask

    try:
        said = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise ConfigError(f"{shown(file)}: not TOML: {error}") from None
    return dict(said.get("tool", {}).get("kinlint", {})) if file.name == PROJECT else said


def _with_entry(text: str, file: Path, line: str) -> str:
    """Return the *text* of *file* with *line* in the table of contexts."""
    name = f"tool.kinlint.{KEY}" if file.name == PROJECT else KEY
    header = re.search(rf"(?m)^[ \t]*\[[ \t]*{re.escape(name)}[ \t]*\][^\n]*(\n|$)", text)
    if header is not None:
        at = header.end()
        return f"{text[:at]}{'' if header[1] else chr(10)}{line}{text[at:]}"
    gap = "" if not text else "\n" if text.endswith("\n") else "\n\n"
    return f"{text}{gap}[{name}]\n{line}"


def _file_above(directory: Path) -> Path | None:
    """Return the configuration file that is nearest at or above *directory*."""
    for each in (directory, *directory.parents):
        for name in NAMES:
            if (path := each / name).is_file() and read(path) is not None:
                return path
    return None
