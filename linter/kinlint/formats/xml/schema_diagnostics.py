"""Deviations of a file from the schema of its format, as statements without judgement."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

from kinlint.formats.source_layer import SourceLayer, src
from kinlint.formats.xml.element_resemblance import element_meant
from kinlint.formats.xml.element_types import ElementType, Lifetime, Schema, Slot, version
from kinlint.formats.xml.span_lookup import ElementPlaces
from kinlint.formats.xml.value_reading import UNEXPANDED
from kinlint.light_dataclasses import dataclass, field
from kinlint.suggestion import nearest, slips
from kinlint.terms import XSD, Term, iri, literal
from kinlint.text import Span
from kinlint.vocabulary import ATTRIBUTE

LONGEST_WORD = 60
MOST_WORDS = 2_000
"""No word that is longer, and none after so many, is compared with the known ones."""


ABOUT_NAMES = {
    "UndeclaredAttribute",
    "UndeclaredPrefix",
    "MalformedText",
    "LaterFeature",
    "EarlierFeature",
}
"""Diagnostics about the name of an attribute, rather than its value."""

CHOICES = {"UnknownChoice", "UnusualChoice"}
"""Diagnostics about values of enumerations, which state the property of the value."""

MOST_PLACES = 3


class Diagnostic(NamedTuple):
    """Something to state of an element, at an attribute, at its text ("") or at its tag (None)."""

    kind: str
    """Local name of the class in the source vocabulary."""
    number: int
    """Number of the element, in document order."""
    place: str | None
    """Attribute; empty for the text, None for the tag."""
    details: Mapping[str, str | int | bool | None]
    """Further properties, by name."""


@dataclass
class Diagnostics:
    """Diagnostics so far. `scopes` are the prefixes that open elements declare."""

    schema: Schema
    """Schema of the format."""
    notes: list[Diagnostic] = field(default_factory=list)
    """Diagnostics so far."""
    scopes: dict[int, list[str]] = field(default_factory=dict)
    """Prefixes that open elements declare, by number of element."""
    _declared: dict[str, int] = field(default_factory=dict)
    _undeclared: set[str] = field(default_factory=set)
    _orders: dict[tuple[int, str], int] = field(default_factory=dict)
    _alike: dict[tuple[str, ...], str | None] = field(default_factory=dict)
    _version: str | None = None
    _stated: bool = True

    def note(
        self, kind: str, number: int, place: str | None, **details: str | int | bool | None
    ) -> None:
        """Keep a note for `state`."""
        self.notes.append(Diagnostic(kind, number, place, details))

    def check_unlisted(
        self, number: int, type_: ElementType, key: str, attributes: Mapping[str, str]
    ) -> bool:
        """Tell whether the unlisted attribute *key* has a meaning; if not, it declares a prefix."""
        prefix, colon, name = key.partition(":")
        if key == "xmlns" or (colon and prefix == "xmlns"):
            self.scopes.setdefault(number, []).append(name)
            self._declared[name] = self._declared.get(name, 0) + 1
            return False
        if colon:
            self.check_prefix(number, key, prefix, name)
        elif not type_.open:
            free = [each for each in type_.attributes if each not in attributes]
            resembles = self._nearest(key, free)
            self.note(
                "UndeclaredAttribute",
                number,
                key,
                attribute=key,
                tag=type_.tag,
                resembles=resembles,
            )
        return True

    def check_prefix(self, number: int, place: str | None, prefix: str, name: str) -> None:
        """Note the first use of each *prefix* that is not declared, and a *name* that is none."""
        if name.startswith(":"):
            self.note("MalformedText", number, place, reason=f"two colons in {prefix}:{name}")
            return
        if prefix == "xml" or prefix in self._undeclared or self._declared.get(prefix):
            return
        self._undeclared.add(prefix)
        self.note("UndeclaredPrefix", number, place, prefix=prefix)

    def leave_element(self, number: int) -> None:
        """Forget the prefixes that the element *number* declares, at its end."""
        for prefix in self.scopes.pop(number, ()):
            self._declared[prefix] -= 1

    def note_unlisted_element(
        self,
        number: int,
        outer: ElementType,
        tag: str,
        first: Mapping[str, int],
        attributes: Mapping[str, str],
    ) -> None:
        """Note an element that *outer* does not list; *first* are the tags that were there."""
        prefix, colon, name = tag.partition(":")
        if colon:
            self.check_prefix(number, None, prefix, name)
            if prefix == "xacro":
                self.note("Unexpanded", number, None, written=f"<{tag}>")
        elif not outer.open:
            elsewhere = self.schema.homes(tag, outer)
            listed = tag in outer.attributes or None
            if elsewhere:
                self.note(
                    "MisplacedElement", number, None, tag=tag, parentTag=outer.tag or None,
                    elsewhere=_listed(elsewhere), isAttribute=listed,
                )  # fmt: skip
            else:
                taken = outer.once & first.keys()
                free = {name: each for name, each in outer.children.items() if name not in taken}
                resembles = element_meant(tag, self._nearest(tag, [*free]), attributes, free)
                self.note(
                    "UndeclaredElement", number, None,
                    tag=tag, parentTag=outer.tag or None, isAttribute=listed,
                    resembles=None if listed else resembles,
                )  # fmt: skip

    def check_element(
        self,
        number: int,
        type_: ElementType,
        attributes: Mapping[str, str],
        display_only: Callable[[ElementType], bool],
        *,
        dated: bool,
    ) -> None:
        """Note missing attributes of an element, and features of other versions of the format.

        *display_only* tells whether an element of a type would only matter for display here, and
        *dated* whether it came or went without the element around it.
        """
        if not number:
            self._version = attributes.get("version", self.schema.version)
            self._stated = "version" in type_.attributes
        for name in type_.required:
            if name not in attributes:
                self.note(
                    "MissingAttribute", number, None,
                    attribute=name, tag=type_.tag, displayOnly=display_only(type_) or None,
                )  # fmt: skip
        for name in (*type_.choices, *type_.usual):
            if name in attributes:
                self.check_word(number, type_, name, attributes[name])
        if not type_.dated:
            return
        if dated and type_.lifetime is not None:
            self._dated(number, None, type_, type_.tag, type_.lifetime)
        for name, lifetime in type_.lifetimes.items():
            if name in attributes:
                self._dated(number, name, type_, name, lifetime)

    def check_word(self, number: int, type_: ElementType, key: str, written: str) -> None:
        """Check a value of an attribute with a list of words; *key* is empty for text."""
        if "$" in written:
            return
        if known := type_.choices.get(key):
            if written not in known:
                self.note(
                    "UnknownChoice", number, key,
                    tag=type_.tag, written=written, choices=", ".join(filter(None, known)),
                    resembles=nearest(written, filter(None, known)),
                )  # fmt: skip
        elif meant := _misspelt(written, type_.usual.get(key, ())):
            self.note("UnusualChoice", number, key, tag=type_.tag, written=written, resembles=meant)

    def _dated(
        self, number: int, place: str | None, type_: ElementType, name: str, life: Lifetime
    ) -> None:
        declared = version(self._version or "")
        if declared is None:
            return
        since, until = version(life.since or ""), version(life.until or "")
        stated = self._version if self._stated else None
        feature = {"feature": name, "tag": type_.tag, "declared": stated}
        if since is not None and (declared < since or not self._stated):
            self.note("LaterFeature", number, place, since=life.since, **feature)
        elif until is not None and declared > until:
            self.note("EarlierFeature", number, place, until=life.until, **feature)

    def note_malformed_value(
        self, number: int, tag: str, key: str, written: str, slot: Slot
    ) -> None:
        """Note a value that is not what *slot* takes; *key* is empty for text."""
        if UNEXPANDED.search(written):
            self.note_unexpanded(number, key, written)
            return
        expected = slot.reading.expected
        self.note(
            "MalformedValue", number, key,
            attribute=key or None, tag=tag, written=written, expected=expected,
            reason=slot.reading.reason(written),
        )  # fmt: skip

    def note_unexpanded(self, number: int, key: str, written: str) -> None:
        """Note an expression of xacro in a value; *key* is empty for text."""
        self.note("Unexpanded", number, key, written=written)

    def note_repeated(self, number: int, holder: int, tag: str, before: int) -> None:
        """Note a further element where the format takes one; *before* is the first."""
        order = self._orders[holder, tag] = self._orders.get((holder, tag), 1) + 1
        self.note("RepeatedElement", number, None, tag=tag, ordinal=order, first=before)

    def _nearest(self, word: str, known: Sequence[str]) -> str | None:
        """Return the word in *known* that is most like *word*; results are cached."""
        key = (word, *known)
        if key not in self._alike:
            if len(word) > LONGEST_WORD or len(self._alike) > MOST_WORDS:
                return None
            self._alike[key] = nearest(word, known)
        return self._alike[key]

    def state(self, layer: SourceLayer, places: ElementPlaces, nodes: list[Term]) -> None:
        """Put all that was noted into *layer*; *nodes* are the elements by their number."""
        for kind, number, place, details in self.notes:
            values = dict(details)
            if kind == "RepeatedElement":
                first = values.pop("first")
                assert isinstance(first, int)
                values["equal"] = _content(places, first) == _content(places, number)
            terms = [(name, _term(value)) for name, value in values.items()]
            if kind in CHOICES:
                terms.append(("property", iri(ATTRIBUTE + place) if place else src("text")))
            layer.add_node(
                kind, _span(places, kind, number, place), ("node", nodes[number]), *terms
            )


def _misspelt(written: str, usual: Sequence[str]) -> str:
    """Return the word of *usual* that *written* is a slip for; empty if it is none.

    The case of letters is one slip. A word without a slash may be the last part of a usual one.
    """
    if written in usual or len(written) > LONGEST_WORD:
        return ""
    known = usual if "/" in written else [each.rpartition("/")[2] for each in usual]
    folded = written.casefold()
    counts = ((folded == each.casefold() or slips(written, each), each) for each in known)
    found = [(count, each) for count, each in counts if count]
    return min(found)[1] if found and written not in known else ""


def _span(places: ElementPlaces, kind: str, number: int, place: str | None) -> Span:
    tag = places.tag(number)
    if place is None:
        return tag.name
    if place:
        spans = tag.keys if kind in ABOUT_NAMES else tag.attributes
        return spans.get(place, tag.name)
    runs = places.runs(number)
    return Span(runs[0].start, runs[-1].end) if runs else tag.name


def _listed(tags: Sequence[str]) -> str:
    """Return the first of *tags* in a phrase."""
    *most, last = tags[:MOST_PLACES]
    return f"{', '.join(most)} or {last}" if most else last


def _content(places: ElementPlaces, number: int) -> list[str]:
    """Return an element as it is written, but for space."""
    return places.text[slice(*places.whole(number))].split()


def _term(value: str | int | bool | None) -> Term | None:  # noqa: FBT001
    if value is None:
        return None
    if isinstance(value, bool):
        return literal("true" if value else "false", f"{XSD}boolean")
    if isinstance(value, int):
        return literal(str(value), f"{XSD}integer")
    return literal(value)
