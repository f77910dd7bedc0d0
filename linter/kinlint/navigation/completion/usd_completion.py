"""Completion in layers of USD: prims that relationships lead to, and what schemas have."""

from __future__ import annotations

import re
from collections.abc import Iterator

from kinlint.addresses import document_iri
from kinlint.document import Document
from kinlint.formats.usd.prim_paths import prim_address
from kinlint.navigation.completion import usd_schemas
from kinlint.navigation.completion.candidate import NOTHING, Candidate, Completions, Kind
from kinlint.navigation.completion.situation import Situation
from kinlint.terms import Term, iri, literal_value
from kinlint.text import Span
from kinlint.vocabulary import ATTRIBUTE, SRC, USD

_TARGET = re.compile(
    r"(?:\brel\s+(?P<relationship>[\w:]+)|\.connect|\b(?:inherits|specializes))\s*=\s*"
    r"(?:\[[^\]@]*)?<(?P<typed>[^<>\s\"@]*)\Z"
)
_REST = re.compile(r"[^<>\s\"@,\]]*")
LONGEST = 2_000
"""Most characters of a statement that are looked back for its name."""
TYPE, IS_BODY = iri(f"{ATTRIBUTE}typeName"), iri(f"{SRC}rigidBody")
BODIES = frozenset({"physics:body0", "physics:body1", "physics:simulationOwner"})
JOINT = "Joint"


def complete(situation: Situation) -> Completions:
    """Return the prims that the path at the place of *situation* can lead to."""
    text, offset = situation.source.text, situation.offset
    found = _TARGET.search(text, max(0, offset - LONGEST), offset)
    rest = _REST.match(text, offset)
    if found is None or rest is None:
        return usd_schemas.complete(situation)
    if situation.document is None:
        return NOTHING
    end = "" if text[rest.end() : rest.end() + 1] == ">" else ">"
    candidates = _prims(situation, situation.document, found["relationship"] or "", end)
    return Completions.from_candidates(candidates, Span(found.start("typed"), rest.end()))


def _prims(
    situation: Situation, document: Document, relationship: str, end: str
) -> Iterator[Candidate]:
    home = document_iri(document.source.name)
    types = {s: literal_value(o) for s, p, o in document.statements if p == TYPE}
    bodies = {s for s, p, _ in document.statements if p == IS_BODY}
    for part in situation.names.parts:
        if part.namespace != USD or part.document != home or part.tag != "prim":
            continue
        path = "/" + "/".join(part.path[1::2])
        prim = prim_address(home, path)
        type_ = types.get(prim, "")
        best = _fits(relationship, prim, type_, bodies)
        yield Candidate(path, Kind.NAME, type_, rank=0 if best else 1, text=f"{path}{end}")


def _fits(relationship: str, prim: Term, type_: str, bodies: set[Term]) -> bool:
    """Tell whether the *prim* is of the kind that *relationship* is for."""
    if relationship in BODIES:
        return prim in bodies
    return relationship.endswith(JOINT) and type_.endswith(JOINT)
