"""Detection of robot models among the files that a search found and nobody named."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import Any
from urllib.parse import unquote

from kinlint.contexts.context_library import known_terms
from kinlint.files.bounded_read import Unreadable, contents
from kinlint.files.pathglob import absolute
from kinlint.text import SourceText
from kinlint.vocabulary import METAMODELS

ROBOTIC = ("comp-rob2b", "metamodels", "w3id.org/kinlint")
"""Parts of the IRIs of robot vocabularies.

Every JSON-LD robot model has an IRI with one of them, or uses their terms.
"""
CONTEXT = "@context"
LARGEST, MOST_FILES = 1 << 22, 100
"""Limits of context files that are looked into: the bytes of one, and their number."""
ENOUGH = 2
"""Number of classes of robot vocabularies that make a model, if each is a common word."""
_LOCAL = re.compile(r"(?!//)[^:]*\.\w+$")
_WORDS = re.compile(r"[A-Z][a-z0-9]+")


def is_model(source: SourceText, own: Sequence[str] = ()) -> bool:
    """Tell whether *source* is a model although nobody called it one.

    Turtle, N-Quads and `.jsonld` are; so is JSON whose `@context` has an IRI of a robot vocabulary,
    or one of *own*, itself or in a file that it names, and JSON in the terms of such a vocabulary.
    A document that is nothing but a context for others is none.
    """
    form = source.format
    if form is None or form.fence != "json":
        return form is not None
    named = source.name.lower().endswith(form.suffixes)
    marks = (*ROBOTIC, *own)
    try:
        said = json.loads(source.text)
    except (ValueError, RecursionError):
        # Its reader will say what is wrong with it.
        return named or any(mark in source.text for mark in marks)
    if _is_context_document(said):
        return False
    if named:
        return True
    used = _iris(said, absolute(source.name))
    return any(mark in iri for iri in used for mark in marks) or _speaks_of_robots(said)


def doubt(source: SourceText) -> str:
    """Say why *source*, which is no model, may have been meant as one; empty if nothing says so."""
    if source.format is None or f'"{CONTEXT}"' in source.text:
        return ""
    return f"it describes nodes of JSON-LD, but has no {CONTEXT} and no term of a known metamodel"


def _is_context_document(said: Any) -> bool:
    """Tell whether *said* is a context for others, perhaps with remarks."""
    if not isinstance(said, dict) or CONTEXT not in said:
        return False
    rest = said.keys() - {CONTEXT}
    return all(":" not in key and key[:1] != "@" and isinstance(said[key], str) for key in rest)


def _iris(said: Any, path: Path) -> Iterator[str]:
    """Yield the strings of all contexts in *said*, and the keys and types that are of a metamodel.

    The strings of context files that it names are among them; *path* is where it stands.
    """
    pending: list[tuple[Any, bool, Path]] = [(said, False, path)]
    known: set[Path] = set()
    while pending:
        value, in_context, near = pending.pop()
        if isinstance(value, str):
            if in_context:
                yield value
                if _LOCAL.match(value) and len(known) < MOST_FILES:
                    beside = absolute(near.parent / unquote(value))
                    if beside not in known:
                        known.add(beside)
                        pending.append((_content(beside, path), False, beside))
        elif isinstance(value, list):
            pending += [(one, in_context, near) for one in value]
        elif isinstance(value, dict):
            for key, one in value.items():
                whole = [key, *(_strings(one) if key in {"@type", "type"} else ())]
                yield from (text for text in whole if text.startswith(METAMODELS))
                pending.append((one, in_context or key == CONTEXT, near))


def _content(path: Path, near: Path) -> Any:
    """Return the content of the JSON file at *path*, which one at *near* names; None if none."""
    try:
        return json.loads(contents(path, near, LARGEST))
    except (Unreadable, ValueError, RecursionError):
        return None


def _speaks_of_robots(said: Any) -> bool:
    """Tell whether the types and keys in *said* are terms of the metamodels, beyond chance."""
    special, common = _terms()
    found: set[str] = set()
    pending = [said]
    while pending:
        value = pending.pop()
        if isinstance(value, list):
            pending += value
        elif isinstance(value, Mapping):
            types = [one for key in ("@type", "type") for one in _strings(value.get(key))]
            if not special.isdisjoint((*value, *types)):
                return True
            found |= common.intersection(types)
            if len(found) >= ENOUGH:
                return True
            pending += [one for key, one in value.items() if key != CONTEXT]
    return False


@cache
def _terms() -> tuple[frozenset[str], frozenset[str]]:
    """Return the terms that nobody else uses, in several words, and the other classes."""
    classes, properties = known_terms()
    several = {each for each in classes if len(_WORDS.findall(each)) > 1}
    special = several | {each for each in properties if "-" in each}
    return frozenset(special), classes - special


def _strings(value: Any) -> list[str]:
    listed = value if isinstance(value, list) else [value]
    return [one for one in listed if isinstance(one, str)]
