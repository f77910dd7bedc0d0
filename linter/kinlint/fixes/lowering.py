"""Brings the change of a lifted value down to the attribute that it was made of."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from kinlint.document import FROM, Document
from kinlint.edits import Delta, Unsayable
from kinlint.engine.store import Store
from kinlint.terms import Term, Triple, is_literal


class Replacement(NamedTuple):
    """A triple of a document that gives way to another."""

    document: Document
    old: Triple
    new: Triple


def lowered(store: Store, lifted: Delta) -> Iterator[Replacement]:
    """What says *lifted* in the documents that it was made of.

    Raises Unsayable unless each value that goes is replaced by one other, and one place of the
    text is what it was made of.
    """
    added: dict[tuple[Term, Term], list[Term]] = {}
    for subject, predicate, value in lifted.added:
        added.setdefault((subject, predicate), []).append(value)
    for subject, predicate, value in lifted.removed:
        new = added.pop((subject, predicate), [])
        if len(new) != 1 or not is_literal(value) or not is_literal(new[0]):
            raise Unsayable("the format has no word for this change")
        document, old = _written(store, subject, predicate, value)
        yield Replacement(document, old, (old[0], old[1], new[0]))
    if added:
        raise Unsayable("the format has no word for what is added")


def _written(store: Store, subject: Term, predicate: Term, value: Term) -> tuple[Document, Triple]:
    """The one place that *value* was made of: if there are several, that of the same name."""
    found = {
        triple: document
        for element in store.values(subject, FROM)
        for document, triple in _places(store, element, value)
    }
    name = _local(predicate)
    triples: Sequence[Triple] = list(found)
    if len(triples) > 1:
        triples = [each for each in triples if name in (_local(each[1]), _local(each[0]))]
    if len(triples) != 1:
        several = "several places of the text have" if found else "no place of the text has"
        raise Unsayable(f"{several} the value that changes")
    return found[triples[0]], triples[0]


def _places(store: Store, element: Term, value: Term) -> Iterator[tuple[Document, Triple]]:
    """Where *element*, or one right below it, says *value*."""
    address = f"{element[:-1]}/"
    below = [each for _, each in store.said(element) if each.startswith(address)]
    for each in (element, *below):
        yield from store.written(each, None, value)


def _local(term: Term) -> str:
    return re.split(r"[#/]", term.rstrip(">"))[-1].partition(";")[0]
