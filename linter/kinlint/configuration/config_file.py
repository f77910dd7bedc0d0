"""Configuration files: where they are, what they say, and what they extend.

`.kinlint.toml`, `kinlint.toml` or `pyproject.toml` with `[tool.kinlint]`: the first of these in
the nearest directory upwards governs a file. Others are not merged in, unless it says `extend`.
Relative paths and patterns start at the directory of the file that says them.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping
from functools import partial
from pathlib import Path
from typing import Any

from kinlint.configuration.config_text import ConfigText, read
from kinlint.configuration.keys import check
from kinlint.configuration.per_file_ignores import (
    FileTargets,
    PerFile,
    per_file_ignores,
    per_file_targets,
)
from kinlint.configuration.settings import Choice
from kinlint.configuration.value_kinds import ALIASES
from kinlint.errors import ConfigError
from kinlint.files.pathglob import Glob, absolute
from kinlint.files.pathname import missing, shown
from kinlint.light_dataclasses import dataclass, field, fields, replace
from kinlint.rule import Severity
from kinlint.text import SourceText

NAMES = (".kinlint.toml", "kinlint.toml", "pyproject.toml")


@dataclass(frozen=True, slots=True)
class XacroArgument:
    """The value of an argument of xacro files."""

    name: str
    """The argument."""
    value: str
    """Its value."""
    glob: Glob | None = None
    """The files that it holds for; None for all."""


ADDING = ("choices", "packages", "untrusted", "xacro_args")
"""Keys whose values add up along `extend`, as lists do."""


@dataclass(frozen=True)
class Config:
    """A configuration with all that it extends; None for keys that it does not set."""

    origin: str
    """The file, or "command line", for messages."""
    choices: tuple[Choice, ...] = ()
    """Layers of rule selection, the lowest first."""
    exclude: tuple[Glob, ...] | None = None
    """Patterns of files and directories that searches pass over, in place of the default ones."""
    extend_exclude: tuple[Glob, ...] = ()
    """Further patterns of this kind."""
    respect_gitignore: bool | None = None
    """True if searches pass over what git ignores."""
    per_file_ignores: tuple[PerFile, ...] | None = None
    """Ignores for files that match a pattern."""
    extend_per_file_ignores: tuple[PerFile, ...] = ()
    """Further ignores of this kind."""
    require_reason: bool | None = None
    """True if suppressions have to give a reason."""
    target: tuple[str, ...] | None = None
    """Consumers that the robots are for."""
    per_file_target: FileTargets | None = None
    """Further consumers of files, by globs."""
    srdf: tuple[tuple[Glob, Path], ...] | None = None
    """The URDF that each SRDF matching a pattern belongs to."""
    unsafe_fixes: bool | None = None
    """True if `--fix` applies unsafe fixes."""
    fail_on: str | None = None
    """The least severity that makes the exit code 1."""
    show: str | None = None
    """The least severity that is shown."""
    output_format: str | None = None
    """The name of the output format."""
    contexts: str | None = None
    """The release of the composable-model contexts."""
    extra_contexts: Mapping[str, Path] | None = None
    """Files of further contexts, by IRI."""
    context_directories: tuple[Path, ...] | None = None
    """Directories in which contexts are searched."""
    rules: tuple[Path, ...] | None = None
    """Rule files, and directories of them."""
    code_prefix: str | None = None
    """Beginning of the codes of the project's own rules."""
    shapes: tuple[Path, ...] | None = None
    """SHACL files without rule metadata."""
    partial: bool | None = None
    """True if the files are part of a larger model."""
    file_timeout: float | None = None
    """The time in seconds that a file may take."""
    engine: str | None = None
    """The name of the engine that checks."""
    baseline: Path | None = None
    """The file with the known findings."""
    home: Path | None = None
    """The directory of the configuration file."""
    packages: tuple[tuple[str, Path], ...] = ()
    """Directories of ROS packages by name; of equal names, the later counts."""
    xacro_args: tuple[XacroArgument, ...] = ()
    """Arguments of xacro files; of equal names, the later counts."""
    xacro_env: tuple[str, ...] | None = None
    """Environment variables that xacro files may ask for, besides those of ROS."""
    untrusted: tuple[str, ...] = ()
    """Fields that do not count, since the user does not trust the project."""

    def extended_by(self, above: Config) -> Config:
        """The two as one, *above* on top: lists that extend add up, the rest replaces.

        `origin` stays, since it names the file.
        """
        changes: dict[str, Any] = {}
        for one in fields(self):
            mine, theirs = getattr(self, one.name), getattr(above, one.name)
            if one.name in ADDING or one.name.startswith("extend_"):
                changes[one.name] = (*mine, *theirs)
            elif theirs is not None and one.name != "origin":
                changes[one.name] = theirs
        return replace(self, **changes)


def parse_config(
    values: Mapping[str, Any], origin: str, root: Path, source: SourceText | None = None
) -> Config:
    """The configuration that *values* state, read from *origin*; paths start at *root*.

    *source* is the text of a file that states them. Raises `ConfigError` for unknown keys and
    values of the wrong kind.
    """
    said = check(values, origin)
    contexts = said.get("extra-contexts")
    ignores, more = (
        per_file_ignores(said.get(key), origin, root, source)
        for key in ("per-file-ignores", "extend-per-file-ignores")
    )
    return Config(
        origin=origin,
        choices=_choices(said, origin),
        exclude=_globs(said.get("exclude"), root),
        extend_exclude=_globs(said.get("extend-exclude"), root) or (),
        respect_gitignore=said.get("respect-gitignore"),
        per_file_ignores=ignores,
        extend_per_file_ignores=more or (),
        require_reason=said.get("require-reason"),
        target=tuple(said["target"]) if "target" in said else None,
        per_file_target=per_file_targets(said.get("per-file-target"), root),
        srdf=_partners(said.get("srdf"), root),
        unsafe_fixes=said.get("unsafe-fixes"),
        fail_on=ALIASES.get(said.get("fail-on", ""), said.get("fail-on")),
        show=ALIASES.get(said.get("show", ""), said.get("show")),
        output_format=said.get("output-format"),
        contexts=said.get("contexts"),
        extra_contexts=_table(contexts, root) if isinstance(contexts, dict) else None,
        context_directories=None if isinstance(contexts, dict) else _paths(contexts, root),
        rules=_paths(said.get("rules"), root),
        code_prefix=said.get("code-prefix"),
        shapes=_paths(said.get("shapes"), root),
        partial=said.get("partial"),
        file_timeout=said.get("file-timeout"),
        engine=said.get("engine"),
        baseline=_path(said["baseline"], root) if said.get("baseline") else None,
        home=None if source is None else root,
        packages=tuple(_table(said.get("packages", {}), root).items()),
        xacro_args=tuple(_arguments(said.get("xacro-args", {}), root)),
        xacro_env=tuple(said["xacro-env"]) if "xacro-env" in said else None,
    )


def _choices(said: Mapping[str, Any], origin: str) -> tuple[Choice, ...]:
    choice = Choice(
        origin=origin,
        select=tuple(said["select"]) if "select" in said else None,
        preview=said.get("preview"),
        extend_select=tuple(said.get("extend-select", ())),
        ignore=tuple(said.get("ignore", ())),
        fixable=tuple(said["fixable"]) if "fixable" in said else None,
        unfixable=tuple(said.get("unfixable", ())),
        extend_safe_fixes=tuple(said.get("extend-safe-fixes", ())),
        extend_unsafe_fixes=tuple(said.get("extend-unsafe-fixes", ())),
        severity=tuple(
            (selector, Severity[ALIASES.get(word, word).upper()])
            for selector, word in said.get("severity", {}).items()
        ),
    )
    return () if choice == Choice(origin=origin) else (choice,)


def _globs(patterns: list[str] | None, root: Path) -> tuple[Glob, ...] | None:
    return None if patterns is None else tuple(Glob(root, pattern) for pattern in patterns)


def _paths(said: str | list[str] | None, root: Path) -> tuple[Path, ...] | None:
    if said is None:
        return None
    listed = [said] if isinstance(said, str) else said
    return tuple(_path(path, root) for path in listed)


def _partners(said: Mapping[str, str] | None, root: Path) -> tuple[tuple[Glob, Path], ...] | None:
    """The URDF for the SRDF files that a pattern covers."""
    if said is None:
        return None
    return tuple((Glob(root, pattern), _path(path, root)) for pattern, path in said.items())


def _table(said: Mapping[str, str], root: Path) -> Mapping[str, Path]:
    return {iri: _path(path, root) for iri, path in said.items()}


def _arguments(said: Mapping[str, Any], root: Path) -> Iterator[XacroArgument]:
    """Arguments for all files, and below a pattern those for the files it matches."""
    for key, value in said.items():
        if isinstance(value, dict):
            glob = Glob(root, key)
            yield from (XacroArgument(name, xacro_text(one), glob) for name, one in value.items())
        else:
            yield XacroArgument(key, xacro_text(value))


def xacro_text(value: str | float) -> str:
    """Return *value* of a configuration as a xacro file writes it."""
    return str(value).lower() if isinstance(value, bool) else str(value)


def _path(said: str, root: Path) -> Path:
    return absolute(root / os.path.expanduser(said))  # noqa: PTH111  never fails


@dataclass
class Configs:
    """The configuration that governs a directory, each file read once."""

    fixed: Config | None = None
    """Configuration that governs every directory; None if each is governed by its own files."""
    restrict: Callable[[Config], Config] = lambda config: config
    """Returns what counts of the configuration of a project."""
    may_extend: Callable[[Path, Path], bool] = lambda directory, path: True  # noqa: ARG005
    """Tells whether the configuration of a project in a directory may extend the file at a path."""
    _nearest: dict[Path, Config | None] = field(default_factory=dict)

    def nearest(self, directory: Path) -> Config | None:
        """The nearest configuration at or above *directory*, which is absolute."""
        if self.fixed is not None:
            return self.fixed
        if directory not in self._nearest:
            found = self._in(directory)
            if found is None and (above := directory.parent) != directory:
                found = self.nearest(above)
            self._nearest[directory] = found
        return self._nearest[directory]

    def _in(self, directory: Path) -> Config | None:
        for path in (directory / name for name in NAMES):
            if path.is_file() and (said := read(path)) is not None:
                found = _extended(path, said, (), partial(self.may_extend, directory))
                return self.restrict(found)
        return None


def load_config(path: Path) -> Config:
    """The configuration in the file at *path*, which must have one."""
    if (said := read(path)) is None:
        raise ConfigError(f"{shown(path)}: no [tool.kinlint] in it")
    return _extended(path, said, (), lambda base: True)  # noqa: ARG005


def _extended(
    path: Path, said: ConfigText, seen: tuple[Path, ...], may_extend: Callable[[Path], bool]
) -> Config:
    """The configuration that *said* states on top of what it may extend; *seen* came before."""
    config = parse_config(said.values, shown(path), path.parent, said.source)
    if "extend" not in said.values:
        return config
    base = _path(said.values["extend"], path.parent)
    origin = f"{shown(path)}: extend"
    if base in (*seen, path):
        raise ConfigError(f"{origin}: '{said.values['extend']}' extends itself")
    if not may_extend(base):
        return replace(config, untrusted=("extend",))
    if not base.is_file():
        cause = "not a file" if base.exists() else missing(base)
        raise ConfigError(f"{origin}: {shown(base)}: {cause}")
    if (more := read(base)) is None:
        raise ConfigError(f"{origin}: {shown(base)} has no [tool.kinlint]")
    below = _extended(base, more, (*seen, path), may_extend)
    return replace(below.extended_by(config), origin=config.origin)
