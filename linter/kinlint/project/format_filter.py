"""Keeps those of the found files that are of some formats, by their content."""

from __future__ import annotations

from collections.abc import Collection, Iterable

from kinlint.configuration.value_kinds import unknown_message
from kinlint.errors import SourceError, UsageError
from kinlint.file_format import Format
from kinlint.formats.records import BY_NAME, by_suffix
from kinlint.light_dataclasses import replace
from kinlint.project.discovery import Found, Input
from kinlint.project.reading import read_source


def of_formats(found: Found, names: Iterable[str]) -> Found:
    """Return *found* with those files alone that are of a format called one of *names*.

    A name also holds for macros that expand to the format. What cannot be read stays, to be told.
    Raises `UsageError` for a name that no format has.
    """
    wanted = frozenset(names)
    for name in sorted(wanted):
        if problem := unknown_message(name, tuple(BY_NAME)):
            raise UsageError(f"--only-format: {problem}")
    return replace(found, inputs=[one for one in found.inputs if _is_of(one, wanted)])


def _is_of(one: Input, names: Collection[str]) -> bool:
    try:
        form = _format(one)
    except SourceError:
        return True
    return form is not None and not {form.name, form.lifted_as}.isdisjoint(names)


def _format(one: Input) -> Format | None:
    """Return the format of *one*; what can be read only once, or far away, goes by its name."""
    return by_suffix(one.name) if one.path is None else read_source(one).format
