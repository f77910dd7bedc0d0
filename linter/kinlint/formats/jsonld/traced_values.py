"""Marked values: what expansion leaves, as plain JSON types that remember their origin."""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum, auto
from typing import Any, NamedTuple

from kinlint.formats.json_text.json_values import Key, Object, Text
from kinlint.text import Span


class Reach(Enum):
    """The step by which a string became an IRI."""

    TERM = auto()
    """A context maps it as a whole."""
    PREFIX = auto()
    """A context maps the part before the colon."""
    SCHEME = auto()
    """It was taken as an absolute IRI because of its colon; its "scheme" may be a typing error."""
    ABSOLUTE = auto()
    """It has a scheme and an authority."""
    BLANK = auto()
    VOCAB = auto()
    """It was appended to an absolute `@vocab`."""
    DOCUMENT_BASE = auto()
    """It was relative, and no `@base` gives it a meaning beyond this file."""
    AUTHORS_BASE = auto()
    """It was relative to an absolute `@base`."""
    NOWHERE = auto()
    """It is still relative."""


RELATIVE = frozenset({Reach.DOCUMENT_BASE, Reach.AUTHORS_BASE, Reach.NOWHERE})


class Resolution(NamedTuple):
    """Meaning of a string under an active context."""

    iri: str | None
    """IRI that it expands to."""
    reach: Reach
    """Kind of the expansion."""
    unless: str = ""
    """Name of a context in force that could not be read, so that the meaning is uncertain."""
    terms: Mapping[str, Any] = {}
    """Terms of the context, where the string should have been one of them."""


class Iri(str):
    """An IRI with the token it was written as."""

    __slots__ = ("resolution", "token")
    token: Text
    resolution: Resolution

    @property
    def span(self) -> Span:
        """Return the span of its token."""
        return self.token.span


class Origin:
    """An object of the text on its way through expansion.

    `subject` becomes the term of the node it describes, once something is stated about that.
    """

    __slots__ = ("content", "element", "identifier", "naming", "parent", "prop", "subject")

    def __init__(self, element: Object, parent: Origin | None, prop: str | None) -> None:
        self.element = element
        self.parent = parent
        self.prop = prop
        self.subject: str | None = None
        self.naming: Key | None = None
        """Its key that means `@id`."""
        self.identifier: str | None = None
        """The expansion of its `@id`, kept for objects of which nothing is stated."""
        self.content: Key | None = None
        """Its key that means `@value`, `@list` or `@set`."""

    def identify(self, written: Text, iri: str) -> None:
        """Record that *written* means *iri*: if it is the `@id`, that names the node."""
        if self.naming is not None and self.element.get(self.naming) is written:
            self.identifier = iri

    @property
    def owner(self) -> Origin:
        """The object of the node that this object describes or belongs to."""
        origin = self
        while origin.parent is not None and origin.subject is None:
            if origin.content is None and origin.prop != "@reverse":
                break
            origin = origin.parent
        return origin


class Expanded(dict[str, Any]):
    """An expanded node, value or list, with the token it comes from."""

    __slots__ = ("origin", "span")
    span: Span
    origin: Origin | None

    def __init__(self, content: dict[str, Any], span: Span, origin: Origin | None = None) -> None:
        super().__init__(content)
        self.span = span
        self.origin = origin


class ExpandedArray(list[Any]):
    """The expanded elements of an array."""

    __slots__ = ("span",)
    span: Span

    def __init__(self, span: Span) -> None:
        super().__init__()
        self.span = span


def value_span(prop: str | None) -> Span | None:
    """Return the span of a member's value, given its key or the IRI that its key expanded to."""
    token = prop.token if isinstance(prop, Iri) else prop
    return token.value_span if isinstance(token, Key) else None
