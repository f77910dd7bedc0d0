"""Replaces values in the Turtle text that they were read from."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cached_property

from kinlint.document import Document
from kinlint.edits import Delta, Edit, NotExpressible
from kinlint.formats.blank_nodes import BlankNodes
from kinlint.formats.options import ReadOptions
from kinlint.formats.source_layer import src
from kinlint.formats.turtle.turtle_parser import Grammar
from kinlint.formats.turtle.turtle_tokens import Unread
from kinlint.terms import (
    RDF_TYPE,
    XSD,
    Term,
    Triple,
    iri_value,
    is_blank,
    is_iri,
    literal_datatype,
    literal_value,
)
from kinlint.text import Span

_BARE = {
    f"{XSD}integer": re.compile(r"[+-]?[0-9]+"),
    f"{XSD}decimal": re.compile(r"[+-]?[0-9]*\.[0-9]+"),
    f"{XSD}double": re.compile(r"[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)[eE][+-]?[0-9]+"),
    f"{XSD}boolean": re.compile(r"true|false"),
}
"""The literals that Turtle writes without quotes."""

NAMESPACE = src("namespace")
"""Property of a prefix, which is written as an IRI."""

_LOCAL = re.compile(r"(?:[^\W_]|_)[\w\-]*|")


class Editor:
    """Edits one document: the object of a triple gives way to another."""

    def __init__(self, document: Document, options: ReadOptions) -> None:
        self._document = document
        self._base = options.base

    def edits(self, delta: Delta) -> list[Edit]:
        """Return the edits that apply *delta* to the text, ascending and apart.

        Raises Unsayable where it is more than the replacement of objects that are written once.
        """
        coming: dict[tuple[Term, Term], list[Triple]] = {}
        for triple in delta.added:
            coming.setdefault(triple[:2], []).append(triple)
        edits = []
        for triple in delta.removed:
            heirs = coming.pop(triple[:2], [])
            if len(heirs) != 1 or is_blank(triple[2]):
                raise NotExpressible("in Turtle only one value can take the place of another")
            edits.append(self._replaced(triple, heirs[0][2]))
        if coming:
            raise NotExpressible("in Turtle nothing is added")
        return sorted(edits)

    def _replaced(self, triple: Triple, value: Term) -> Edit:
        if triple[1] == NAMESPACE:
            return Edit(self._document.map.triples[triple], f"<{literal_value(value)}>")
        spans = self._spans.get(triple, [])
        if len(spans) != 1:
            raise NotExpressible("it is not written in one place")
        text = self._document.source[spans[0]]
        return Edit(spans[0], self._written(value, text, triple[1]))

    @cached_property
    def _spans(self) -> Mapping[Triple, list[Span]]:
        """Return the spans of the object of each triple; empty where they are not known exactly."""
        source = self._document.source
        grammar = Grammar(source.text, self._base, BlankNodes(source.name))
        try:
            grammar.read()
        except Unread:
            return {}
        found: dict[Triple, list[Span]] = {}
        for subject, predicate, value, places in grammar.statements:
            found.setdefault((subject, predicate, value), []).append(places[2])
        stated = self._document.map.triples
        return found if all(triple in stated for triple in found) else {}

    def _written(self, term: Term, old: str, predicate: Term) -> str:
        """Return *term* in Turtle, in quotes like those of *old*.

        A number if that has a datatype.
        """
        if is_iri(term):
            return self._name(iri_value(term))
        if is_blank(term):
            raise NotExpressible("in Turtle nothing is added")
        if predicate == RDF_TYPE:
            raise NotExpressible("a class is no literal")
        lexical, datatype = literal_value(term), literal_datatype(term)
        bare = _BARE.get(datatype)
        if bare is not None and bare.fullmatch(lexical) and "^^" not in old:
            return lexical
        quote = "'" if old[:1] == "'" and "'" not in lexical else '"'
        text = lexical.replace("\\", "\\\\").replace(quote, f"\\{quote}")
        for character, escape in (("\n", "\\n"), ("\r", "\\r"), ("\t", "\\t")):
            text = text.replace(character, escape)
        tail = term[term.rindex('"') + 1 :]
        if tail.startswith("^^"):
            tail = f"^^{self._name(datatype)}"
        return f"{quote}{text}{quote}{tail}"

    def _name(self, iri: str) -> str:
        """Return *iri* with the longest prefix of the file that abbreviates it."""
        prefixes = self._document.prefixes.items()
        for prefix, namespace in sorted(prefixes, key=lambda each: -len(each[1])):
            local = iri[len(namespace) :]
            if namespace and iri.startswith(namespace) and _LOCAL.fullmatch(local):
                return f"{prefix}:{local}"
        return f"<{iri}>"
