"""The options of `kinlint check` as a configuration on top of all others."""

from __future__ import annotations

import os
from argparse import Namespace
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

from kinlint.configuration.config_file import (
    Config,
    Configs,
    XacroArgument,
    load_config,
    parse_config,
)
from kinlint.configuration.keys import KEYS, SEVERITIES
from kinlint.configuration.per_file_ignores import PerFile, per_file
from kinlint.configuration.project_trust import ProjectTrust
from kinlint.configuration.settings import Choice
from kinlint.errors import ConfigError, UsageError
from kinlint.files.pathglob import Glob, absolute
from kinlint.files.pathname import NOTHING, missing
from kinlint.light_dataclasses import replace
from kinlint.rule import Severity

ORIGIN = "command line"


def overrides(options: Namespace) -> Config:
    """The keys of `--config`, and on top of them the other options."""
    here = Path.cwd()
    texts = [text for text in options.config or () if _is_key(text)]
    keys = _keys(texts)
    if "extend" in keys:
        raise UsageError("--config: extend is for configuration files; here, --config PATH")
    inline = parse_config(keys, "--config", here) if keys else Config(ORIGIN)
    above = inline.extended_by(
        Config(
            origin=ORIGIN,
            choices=_choices(options),
            exclude=_globs(options.exclude),
            extend_exclude=_globs(options.extend_exclude) or (),
            respect_gitignore=options.respect_gitignore,
            per_file_ignores=_per_file(options.per_file_ignores),
            extend_per_file_ignores=_per_file(options.extend_per_file_ignores) or (),
            target=None if options.target is None else tuple(options.target),
            per_file_target=None if options.target is None else (),
            unsafe_fixes=options.unsafe_fixes,
            fail_on=options.fail_on,
            show=options.show,
            contexts=options.contexts,
            partial=options.partial,
            file_timeout=options.file_timeout,
            engine=options.engine,
            packages=tuple(_packages(options.package or ())),
            xacro_args=tuple(_xacro_args(options.xacro_arg or ())),
        )
    )
    return replace(above, origin=ORIGIN)


def configs(options: Namespace) -> Configs:
    """Return where configuration comes from: `--config PATH`, nowhere, or the nearest file."""
    paths = [text for text in options.config or () if not _is_key(text)]
    if len(paths) > 1:
        raise UsageError(f"--config: two files, '{paths[0]}' and '{paths[1]}'; one may be given")
    if paths and options.isolated:
        raise UsageError(f"--config '{paths[0]}' and --isolated exclude each other")
    if paths:
        path = absolute(paths[0])
        if not path.is_file():
            near = "" if path.exists() else missing(path).removeprefix(NOTHING)
            raise UsageError(f"--config: '{paths[0]}' is neither a file nor KEY=VALUE{near}")
        return Configs(fixed=load_config(path))
    trust = ProjectTrust.from_user(os.environ, everything=options.trust)
    fixed = Config("defaults") if options.isolated else None
    return Configs(fixed, trust.restricted, trust.may_extend)


def _is_key(text: str) -> bool:
    return "=" in text and not Path(text).exists()


def _keys(texts: Iterable[str]) -> Mapping[str, Any]:
    """The keys that `--config KEY=VALUE` sets, later ones on top."""
    said: dict[str, Any] = {}
    for text in texts:
        import tomllib  # noqa: PLC0415  rarely used

        key, _, bare = (part.strip() for part in text.partition("="))
        try:
            new = tomllib.loads(text)
        except tomllib.TOMLDecodeError as error:
            if (value := _unquoted(key, bare)) is None:
                raise ConfigError(f"--config '{text}': not TOML: {error}") from None
            new = {key: value}
        for key, value in new.items():
            old = said.get(key)
            said[key] = {**old, **value} if isinstance(old, dict) and KEYS.get(key) else value
    return said


def _unquoted(key: str, value: str) -> str | list[str] | None:
    """Return the *value* of *key* where its kind tells that it is a string, or several.

    That of an unknown key, too, which is refused by its name.
    """
    if not value or not value.isprintable() or value[0] in "\"'[{":
        return None
    if key not in KEYS:
        return None if "." in key else value
    kind, several = KEYS[key].kind, [part.strip() for part in value.split(",")]
    if "enum" in kind.schema:
        return value
    return next((each for each in (value, several) if not kind.problem(each)), None)


def _packages(pairs: Iterable[str]) -> Iterator[tuple[str, Path]]:
    """Packages `NAME=DIR` or `NAME:=DIR`."""
    for text in pairs:
        name, directory = _name_and_value(text) or ("", "")
        if not directory:
            raise UsageError(f"--package: expected NAME=DIR, got '{text}'")
        path = absolute(os.path.expanduser(directory))  # noqa: PTH111  never fails
        if not path.is_dir():
            cause = "not a directory" if path.exists() else missing(path)
            raise UsageError(f"--package '{text}': {cause}")
        yield name, path


def _xacro_args(pairs: Iterable[str]) -> Iterator[XacroArgument]:
    """Arguments `NAME:=VALUE` or `NAME=VALUE`."""
    for text in pairs:
        found = _name_and_value(text)
        if found is None:
            raise UsageError(f"--xacro-arg: expected NAME:=VALUE, got '{text}'")
        yield XacroArgument(*found)


def _name_and_value(text: str) -> tuple[str, str] | None:
    from kinlint.cli.xacro_arguments import name_and_value  # noqa: PLC0415  few runs give any

    return name_and_value(text)


def _choices(options: Namespace) -> tuple[Choice, ...]:
    severity = tuple(
        (selector, Severity[word.upper()])
        for word in SEVERITIES
        for selector in getattr(options, word) or ()
    )
    choice = Choice(
        origin=ORIGIN,
        select=None if options.select is None else tuple(options.select),
        preview=options.preview,
        extend_select=tuple(options.extend_select or ()),
        ignore=tuple(options.ignore or ()),
        severity=severity,
        fixable=None if options.fixable is None else tuple(options.fixable),
        unfixable=tuple(options.unfixable or ()),
    )
    return () if choice == Choice(origin=ORIGIN) else (choice,)


def _globs(patterns: list[str] | None) -> tuple[Glob, ...] | None:
    return None if patterns is None else tuple(Glob(Path.cwd(), text) for text in patterns)


def _per_file(pairs: list[str] | None) -> tuple[PerFile, ...] | None:
    """Entries `GLOB:R`; the same GLOB may come again."""
    if pairs is None:
        return None
    entries = []
    for pair in pairs:
        key, colon, selector = pair.rpartition(":")
        if not colon or not key or not selector:
            raise UsageError(f"--per-file-ignores: expected GLOB:R, got '{pair}'")
        entries.append(per_file(key.strip(), (selector.strip(),), ORIGIN, Path.cwd()))
    return tuple(entries)
