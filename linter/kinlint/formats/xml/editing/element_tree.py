"""Comparison of the elements of a document, independent of names of nodes and of layout.

Trees are equal if their elements are: by tag, by attributes and text, of which the words count and
the values of numbers, and by the elements within, in any order.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Hashable, Iterable, Mapping
from functools import lru_cache

from kinlint.document import Document
from kinlint.edits import Delta
from kinlint.formats.source_layer import src
from kinlint.formats.xml.editing.spelling import lexical_form, tokens
from kinlint.formats.xml.editing.stated_elements import KEPT, slot_of, tag_of
from kinlint.terms import RDF_TYPE, Term, Triple, is_literal, literal_value

STRAY, NODE, WRITTEN = src("StrayText"), src("node"), src("written")
DECLARATION = "xmlns"


def tree(document: Document) -> Hashable:
    """Return the elements of *document*; hashable."""
    return _tree(document.graph, document.statements, _stray(document.statements))


def changed(document: Document, delta: Delta) -> Hashable:
    """Return the value that `tree` must have after *delta* is applied to *document*."""
    removed = set(delta.removed)
    statements = [each for each in document.statements if each not in removed]
    return _tree(document.graph, [*statements, *delta.added], _stray(statements))


def _stray(statements: Iterable[Triple]) -> Mapping[Term, str]:
    """Return texts that stand where no text is read, by the nodes of their elements."""
    stray = {s for s, p, o in statements if p == RDF_TYPE and o == STRAY}
    if not stray:
        return {}
    nodes = {s: o for s, p, o in statements if p == NODE and s in stray}
    texts = {s: literal_value(o) for s, p, o in statements if p == WRITTEN and s in stray}
    return {nodes[each]: text for each, text in texts.items()}


def _tree(root: Term, statements: Iterable[Triple], stray: Mapping[Term, str]) -> Hashable:
    children: dict[Term, list[tuple[str, Term]]] = {}
    slots: dict[Term, dict[str, dict[int, Term]]] = {}
    for subject, predicate, value in statements:
        if is_literal(value):
            if slot := slot_of(predicate, value):
                slots.setdefault(subject, {}).setdefault(slot[0], {})[slot[1]] = value
        elif (tag := tag_of(predicate)) is not None:
            children.setdefault(subject, []).append((tag, value))
    done: dict[Term, Hashable] = {}
    waiting = [root]
    while waiting:
        node = waiting[-1]
        inside = children.get(node, [])
        missing = [each for _, each in inside if each not in done]
        if missing:
            waiting += missing
            continue
        waiting.pop()
        content = {
            (name, words)
            for name, value in slots.get(node, {}).items()
            if not name.startswith(DECLARATION) and ((words := _words(value)) or name)
        }
        if node in stray:
            content.add(("", tokens(stray[node])))
        counted = Counter((tag, done[each]) for tag, each in inside)
        done[node] = frozenset(content), frozenset(counted.items())
    return done[root]


def _words(values: Mapping[int, Term]) -> tuple[float | str, ...]:
    """Return the words and numbers of *values*, in order."""
    if len(values) == 1:
        return _said(*values.values())
    return tuple(word for number in sorted(values) for word in _said(values[number]))


@lru_cache(KEPT)
def _said(value: Term) -> tuple[float | str, ...]:
    return tokens(lexical_form(value))
