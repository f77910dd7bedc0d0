"""States an element of the outermost graph, in the order of `Triples`."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Any

from kinlint.formats.blank_nodes import BlankNodes
from kinlint.formats.json_text.json_outline import Repeating
from kinlint.formats.jsonld.compiled.term_table import (
    Declined,
    Kind,
    Meaning,
    Scope,
    Shape,
    TermTable,
)
from kinlint.formats.jsonld.rdf_literals import value_literal
from kinlint.terms import Term

DEEPEST = 50
"""Number of nodes within each other beyond which PyLD expands an element."""


class Walk(ABC):
    """Common part of both walks: which nodes there are, and in which order.

    Raises Declined for what only PyLD expands: whatever is told of, and rare keywords.
    """

    def __init__(self, blanks: BlankNodes) -> None:
        self.blanks = blanks
        self.around: list[Term] = []
        """The nodes that are being stated, the outermost first."""

    def element(self, element: dict[str, Any], scope: Scope) -> None:
        """State an element of the outermost graph."""
        if len(element) < 2:  # noqa: PLR2004  a name alone states nothing
            raise Declined("an element without properties")
        if type(element) is Repeating:
            raise Declined("a key that stands twice")
        self._node(element, scope.table(element))

    @abstractmethod
    def _shape(self, element: dict[str, Any], table: TermTable) -> Shape:
        """Return the meanings of the keys of a node."""

    @abstractmethod
    def _types(self, subject: Term, classes: list[Term], key: str, value: Any) -> None:
        """State the types of a node, *value* under *key*, as they are written."""

    @abstractmethod
    def _property(self, subject: Term, meaning: Meaning, key: str, value: Any) -> None:
        """State the values of a property."""

    @abstractmethod
    def _list(self, meaning: Meaning, key: str, value: Any) -> Term:
        """State the list of *value*, an array or its only element, and return its first cell."""

    def _listed(self, meaning: Meaning, key: str, value: Any) -> Term:
        """State *value* of a *key* whose values are lists."""
        if not isinstance(value, dict):
            return self._list(meaning, key, value)
        if len(value) != 1:
            raise Declined("an object as a list")
        keys = meaning.scope.table(value).keys
        if keys[next(iter(value))].kind is not Kind.LIST:
            raise Declined("an object as a list")
        return self._object(meaning, key, value)[0]

    def _value(self, meaning: Meaning, key: str, value: Any) -> Term:
        """Return the term of a value that is no array, stating it if it is an object."""
        if isinstance(value, str):
            term: Term = meaning.words[value]
        elif isinstance(value, (int, float)):
            term = meaning.numbers[repr(value)]
        elif isinstance(value, dict):
            term = self._object(meaning, key, value)[0]
        else:
            raise Declined("null, or an array in an array")
        return term

    @abstractmethod
    def _describe(self, subject: Term, element: dict[str, Any], naming: str | None) -> None:
        """Note that *element* describes *subject*, which the member *naming* names."""

    @abstractmethod
    def _nested(
        self, node: Term, meaning: Meaning, key: str, element: dict[str, Any], naming: str | None
    ) -> None:
        """Note that *node* is described within others, as a value of *key*."""

    def _node(self, element: dict[str, Any], table: TermTable) -> tuple[Term, str | None]:
        """State a node; return its term, and the key of its name."""
        naming, typing, members = self._shape(element, table)
        subject = self.blanks.fresh() if naming is None else _name(table, element[naming])
        self.around.append(subject)
        if len(self.around) > DEEPEST:
            raise Declined("nodes within nodes")
        if typing is not None:
            self._types(subject, table.classes, typing, element[typing])
        stating = typing is not None and bool(table.classes)
        for meaning, key in members:
            value = element[key]
            self._property(subject, meaning, key, value)
            stating = stating or value != [] or meaning.listed
        if not stating:
            raise Declined("a node of which nothing is stated")
        self.around.pop()
        self._describe(subject, element, naming)
        return subject, naming

    def _object(
        self, meaning: Meaning, key: str, element: dict[str, Any]
    ) -> tuple[Term, str | None]:
        """State a node, list or literal under *key*.

        Return its term, and the key in *element* whose value stands for it, if one does.
        """
        first = next(iter(element), None)
        if first is None or type(element) is Repeating:
            raise Declined("an empty object, or a key that stands twice")
        table = meaning.scope.table(element)
        keys = table.keys
        kind = keys[first].kind
        if len(element) == 1:
            if kind is Kind.ID:
                return _name(table, element[first]), first
            if kind is Kind.LIST:
                return self._list(_inner(table, meaning, key), first, element[first]), first
        if any(keys[each].kind is Kind.VALUE for each in element):
            return _literal(table, element)
        node, naming = self._node(element, table)
        self._nested(node, meaning, key, element, naming)
        return node, naming


def _name(table: TermTable, name: Any) -> Term:
    if not isinstance(name, str):
        raise Declined("a name that is no string")
    term: Term = table.identifiers[name]
    return term


def _inner(table: TermTable, meaning: Meaning, key: str) -> Meaning:
    """Return what *key* means in a list or set that is written as an object."""
    found: Meaning = table.keys[key]
    if found.predicate != meaning.predicate or found.listed != meaning.listed:
        raise Declined("another meaning within")
    return found


def _literal(table: TermTable, element: dict[str, Any]) -> tuple[Term, str]:
    """Return the literal of a value object, and the key of its value."""
    item: dict[str, Any] = {}
    standing = ""
    for key, value in element.items():
        kind = table.keys[key].kind
        if kind is Kind.VALUE and "@value" not in item and isinstance(value, (str, int, float)):
            item["@value"] = value
            standing = key
        elif kind is Kind.TYPE and "@type" not in item and isinstance(value, str):
            item["@type"] = table.datatypes[value]
        elif kind is Kind.LANGUAGE and "@language" not in item and isinstance(value, str):
            item["@language"] = value.lower()
        else:
            raise Declined(f"'{key}' of a value")
    if "@language" in item and ("@type" in item or not isinstance(item["@value"], str)):
        raise Declined("a language of what is no string")
    term = value_literal(item)
    if term is None:
        raise Declined("a value that is no literal")
    return term, standing
