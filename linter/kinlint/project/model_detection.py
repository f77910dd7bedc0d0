"""Detection of robot models among the files that a search found and nobody named."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from typing import Any

from kinlint.text import SourceText
from kinlint.vocabulary import METAMODELS

ROBOTIC = ("comp-rob2b", "metamodels", "w3id.org/kinlint")
"""Parts of the IRIs of robot vocabularies.

Every JSON-LD robot model has an IRI with one of them.
"""
CONTEXT = "@context"


def is_model(source: SourceText, own: Sequence[str] = ()) -> bool:
    """Tell whether *source* is a model although nobody called it one.

    Turtle, N-Quads and `.jsonld` are; so is JSON whose `@context` has an IRI of a robot vocabulary,
    or one of *own*. A document that is nothing but a context for others is none.
    """
    text, form = source.text, source.format
    if form is None or form.fence != "json":
        return form is not None
    named = source.name.lower().endswith(form.suffixes)
    marks = (*ROBOTIC, *own)
    guess = named or any(mark in text for mark in marks)
    if not guess or CONTEXT not in text:
        return guess
    try:
        said = json.loads(text)
    except (ValueError, RecursionError):
        return guess  # Its reader will say what is wrong with it.
    if isinstance(said, dict) and said.keys() == {CONTEXT}:
        return False
    if named:
        return True
    return any(mark in iri for iri in _iris(said) for mark in marks)


def _iris(said: Any) -> Iterator[str]:
    """The strings of all contexts in *said*, and the keys and types that are of a metamodel."""
    pending: list[tuple[Any, bool]] = [(said, False)]
    while pending:
        value, in_context = pending.pop()
        if isinstance(value, str):
            if in_context:
                yield value
        elif isinstance(value, list):
            pending += [(one, in_context) for one in value]
        elif isinstance(value, dict):
            for key, one in value.items():
                whole = [key, *(_strings(one) if key in {"@type", "type"} else ())]
                yield from (text for text in whole if text.startswith(METAMODELS))
                pending.append((one, in_context or key == CONTEXT))


def _strings(value: Any) -> list[str]:
    listed = value if isinstance(value, list) else [value]
    return [one for one in listed if isinstance(one, str)]
