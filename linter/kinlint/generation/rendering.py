"""Rendering of programs by Jinja templates."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import jinja2
from markupsafe import Markup

from kinlint.errors import UsageError
from kinlint.generation.code_spelling import (
    comment,
    cpp_string,
    identifiers,
    number,
    python_string,
)
from kinlint.resources import data

SUFFIX = ".jinja"
SHARED_TEMPLATES = "shared"
"""The directory of what templates of several libraries include."""


def render(tree: Mapping[str, Any], library: str, own: Path | None = None) -> Mapping[str, str]:
    """Return the files of the program for *library* that *tree* describes, by name.

    A template in the directory *own* takes the place of that of the same name, or adds a file.
    Raises `UsageError` for a template that Jinja refuses, or that asks for what is not there.
    """
    kind = "algorithm" if tree["schedule"] else "chain"
    home = data("shapes") / "generation"
    folders = [*([own] if own is not None else []), home / library / kind, home / SHARED_TEMPLATES]
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(folders),
        undefined=jinja2.StrictUndefined,
        finalize=_spelt,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=True,
    )
    names = identifiers(_iris(tree))
    environment.filters.update(
        cpp=cpp_string, python=python_string, comment=comment, identifier=lambda iri: names[iri]
    )
    templates = {path.name for folder in folders[:-1] for path in folder.glob(f"*{SUFFIX}")}
    try:
        return {
            name.removesuffix(SUFFIX): environment.get_template(name).render(tree, library=library)
            for name in sorted(templates)
        }
    except jinja2.TemplateError as error:
        where = getattr(error, "filename", None) or (own or home)
        line = getattr(error, "lineno", None)
        place = f"{where}:{line}" if line else str(where)
        raise UsageError(f"template {place}: {error.message}") from None
    except (TypeError, ValueError) as error:
        raise UsageError(f"template of {own or home}: {error}") from None


def _spelt(value: object) -> object:
    """Return *value* as a template may write it. Raises `TypeError` for text that is not spelt."""
    if isinstance(value, Markup):
        return value
    if hasattr(value, "_undefined_name"):
        return str(value)  # StrictUndefined says what is missing
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise TypeError(f"{value!r} is written without a filter: cpp, python, comment, identifier")
    return number(value) if isinstance(value, float) else value


def _iris(value: object) -> Iterator[str]:
    """Yield the IRIs of all nodes of a tree."""
    if isinstance(value, Mapping):
        if "@id" in value:
            yield value["@id"]
        for each in value.values():
            yield from _iris(each)
    elif isinstance(value, list):
        for each in value:
            yield from _iris(each)
