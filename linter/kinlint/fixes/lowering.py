"""Brings the change of a lifted value down to the attribute that it was made of."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from kinlint.document import Document
from kinlint.edits import Delta, NotExpressible, negated
from kinlint.engine.provenance import Provenance
from kinlint.terms import (
    NUMERIC,
    Term,
    Triple,
    is_literal,
    literal,
    literal_datatype,
    literal_value,
)
from kinlint.vocabulary import ATTRIBUTE, INHERITED


class Replacement(NamedTuple):
    """A triple of a document that gives way to another."""

    document: Document
    """Document to change."""
    old: Triple
    """Triple to remove."""
    new: Triple
    """Triple to add in its place."""


def lower_delta(provenance: Provenance, lifted: Delta) -> Iterator[Replacement]:
    """Yield what says *lifted* in the documents that it was made of.

    Raises NotExpressible unless each value that goes is replaced by one other, and is itself the
    value, or the negative of the value, of one place of the text.
    """
    added: dict[tuple[Term, Term], list[Term]] = {}
    for subject, predicate, value in lifted.added:
        added.setdefault((subject, predicate), []).append(value)
    for subject, predicate, value in lifted.removed:
        new = added.pop((subject, predicate), [])
        if len(new) != 1 or not is_literal(value) or not is_literal(new[0]):
            raise NotExpressible("the format has no word for this change")
        trace = provenance.trace((subject, predicate, value))
        if len(trace.written) != 1:
            several = (
                "several places of the text have" if trace.written else "no place of the text has"
            )
            raise NotExpressible(f"{several} the value that changes")
        ((document, said),) = trace.written
        old = _where_written(document, said)
        yield Replacement(document, old, (old[0], old[1], signed(new[0], trace.sign)))
    if added:
        raise NotExpressible("the format cannot express the new statement")


def _where_written(document: Document, said: Triple) -> Triple:
    """Return the statement of the attribute that *said* repeats, such as that of a class."""
    if not said[1].startswith(f"<{INHERITED}"):
        return said
    attribute, place = f"<{ATTRIBUTE}{said[1][len(INHERITED) + 1 :]}", document.map.triples[said]
    alike = (each for each in document.statements if each[1:] == (attribute, said[2]))
    return next((each for each in alike if document.map.triples[each] == place), said)


def signed(value: Term, sign: int) -> Term:
    """Return what is to be written for *value*, which is that times *sign*.

    Raises NotExpressible for a sign of 0, of values that are worked out.
    """
    if sign == 1:
        return value
    datatype = literal_datatype(value)
    if not sign or datatype not in NUMERIC:
        raise NotExpressible("the value that changes is worked out from what the text says")
    return literal(negated(literal_value(value)), datatype)
