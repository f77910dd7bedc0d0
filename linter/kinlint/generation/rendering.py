"""Rendering of programs by Jinja templates."""

from __future__ import annotations

import traceback
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import jinja2
from jinja2.sandbox import SandboxedEnvironment
from markupsafe import Markup

from kinlint.errors import UsageError
from kinlint.generation.code_spelling import (
    Code,
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
    environment = SandboxedEnvironment(
        loader=jinja2.FileSystemLoader(folders),
        undefined=jinja2.StrictUndefined,
        finalize=_spelt,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=True,
    )
    names = identifiers(_iris(tree))

    def identifier(iri: str) -> Code:
        if iri not in names:
            raise ValueError(f"{iri!r} is the IRI of no node, so it has no identifier")
        return names[iri]

    environment.filters.update(
        cpp=cpp_string, python=python_string, comment=comment, identifier=identifier
    )
    found: dict[str, str] = {}
    for name in sorted({each.name for folder in folders[:-1] for each in _templates(folder)}):
        try:
            text = environment.get_template(name).render(tree, library=library)
        except Exception as error:  # noqa: BLE001  a template may do whatever it likes
            raise UsageError(f"template {_place(error, folders, name)}: {error}") from None
        found[name.removesuffix(SUFFIX)] = text
    return found


def _templates(folder: Path) -> Iterator[Path]:
    return (path for path in folder.glob(f"?*{SUFFIX}") if path.is_file())


def _place(error: Exception, folders: Sequence[Path], name: str) -> str:
    """Return the file and line of the template where *error* arose, while *name* was rendered."""
    if isinstance(error, jinja2.TemplateSyntaxError):
        return f"{error.filename}:{error.lineno}"
    lines = traceback.extract_tb(error.__traceback__)
    at = [each for each in lines if each.filename.endswith(SUFFIX)]  # Jinja puts these there
    if at:
        return f"{at[-1].filename}:{at[-1].lineno}"
    return str(next(each / name for each in folders if (each / name).is_file()))


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
