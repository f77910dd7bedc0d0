"""The record of an expansion: keys dropped, contexts used, missing and broken."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

from kinlint.formats.json_text.json_values import Key, Text
from kinlint.formats.jsonld.traced_values import Origin, Reach, Resolution
from kinlint.light_dataclasses import dataclass, field
from kinlint.text import Span


class DroppedKey(NamedTuple):
    """A key that no context in force maps, and what it means instead."""

    key: Text
    """The key, with its place."""
    origin: Origin
    """The object that has the key."""
    resolution: Resolution
    """Result of resolving it as an IRI."""


class StrayValue(NamedTuple):
    """A value without effect: a would-be keyword where an IRI belongs, or a value of nothing."""

    kind: str
    """Class of the source layer that states it."""
    span: Span
    """Place of the value."""
    origin: Origin | None
    """The object that has the value; None for one outside of nodes."""
    written: str
    """The value as written."""
    reason: str
    """Reason why it has no effect."""
    key: str | None = None
    """Key that it is under; None if there is none."""


class ContextProblem(NamedTuple):
    """A context that is missing, broken or repeated: its IRI if it has one, and its place."""

    kind: str
    """Class of the source layer that states it."""
    context: str | None
    """IRI of the context; None for one without."""
    reason: str
    """Reason why the context cannot be used, if it cannot."""
    span: Span
    """Place where the context is named."""
    meant: str | None = None
    """IRI of the context that is read in its place."""


class ShadowedTerm(NamedTuple):
    """A term of one context document that a later document in the same array redefines."""

    term: str
    """The term."""
    context: str
    """Context that defines it last."""
    shadowed: str
    """Context that defined it before."""
    iri: str
    """Meaning of the term now."""
    shadowed_iri: str
    """Meaning of the term before."""


class TermDefinition(NamedTuple):
    """A term that a context in the file defines."""

    term: Key
    """Its name, which knows where its meaning stands."""
    written: str | None
    """The meaning, if it is a string."""
    mapping: Mapping[str, Any] | None
    """The meaning from there on; None if it has none."""
    former: Mapping[str, Any] | None
    """The meaning before that; None if it had none."""


@dataclass
class ExpansionRecord:
    """The notes of one file."""

    drops: dict[int, DroppedKey] = field(default_factory=dict)
    """Keys without meaning, by their position."""
    uses: dict[int, Text] = field(default_factory=dict)
    """IRIs of the contexts that are used, by their position."""
    problems: dict[tuple[int, int], ContextProblem] = field(default_factory=dict)
    """Problems of contexts, by their span."""
    shadows: dict[str, ShadowedTerm] = field(default_factory=dict)
    """Terms that a later context of an array redefines, by name."""
    shadow_uses: dict[ShadowedTerm, Text] = field(default_factory=dict)
    """The first key that uses each of these."""
    prefixes: dict[str, str] = field(default_factory=dict)
    """Namespaces by prefix."""
    definitions: dict[int, TermDefinition] = field(default_factory=dict)
    """Terms that contexts in the file define, by their position."""
    cleared: dict[int, tuple[Key, Origin]] = field(default_factory=dict)
    """Keys that a context maps to null, and the objects that have them, by their position."""
    strays: dict[Span, StrayValue] = field(default_factory=dict)
    """Values without effect, by their span."""
    unprefixed: dict[int, Text] = field(default_factory=dict)
    """Datatypes whose prefix is unknown, by their position."""

    def drop(self, key: Text, origin: Origin, resolution: Resolution) -> None:
        """Note that *key* in *origin* means nothing, as *resolution* says."""
        self.drops.setdefault(key.start, DroppedKey(key, origin, resolution))

    def reserve(self, value: Text, origin: Origin) -> None:
        """Record *value*, which should be an IRI, but is a word that JSON-LD reserves."""
        reason = "JSON-LD reserves words that begin with an at sign"
        stray = StrayValue("MalformedIri", value.span, origin, value, reason, _key(origin, value))
        self.strays.setdefault(value.span, stray)

    def float(self, value: Any, span: Span) -> None:
        """Record *value*, which stands in the place of nodes and so is the value of no property."""
        reason = "it is the value of no property"
        plain = isinstance(value, (str, int, float))
        written = f"{value}" if plain and not isinstance(value, bool) else "value"
        self.strays.setdefault(span, StrayValue("LostValue", span, None, written, reason))

    def undefine(self, datatype: Text) -> None:
        """Record a *datatype* with an unknown prefix, which a context in the file gives a term."""
        self.unprefixed.setdefault(datatype.start, datatype)

    def use(self, entry: Any) -> None:
        """Record the use of a context, if *entry* is an IRI written in the file."""
        if isinstance(entry, Text):
            self.uses[entry.start] = entry

    def define(
        self, entry: Mapping[str, Any], before: Mapping[str, Any], after: Mapping[str, Any]
    ) -> None:
        """Record what the context *entry* makes of terms that meant something *before* or not."""
        for term, meaning in entry.items():
            if isinstance(term, Key) and not term.startswith("@"):
                written = meaning if isinstance(meaning, str) else None
                now, old = after.get(term), before.get(term)
                self.definitions[term.start] = TermDefinition(term, written, now, old)

    def clear(self, key: Key, origin: Origin, reserved: Resolution | None) -> None:
        """Record a *key* of *origin* that a context maps to null, or that JSON-LD *reserved*."""
        if reserved is not None:
            self.drop(key, origin, reserved)
        else:
            self.cleared.setdefault(key.start, (key, origin))

    def problem(self, problem: ContextProblem) -> None:
        """Record that a context cannot be used."""
        self.problems.setdefault(problem.span, problem)

    def declare(self, mappings: Mapping[str, Any]) -> None:
        """Record the prefixes among the terms of a context in force."""
        for term, mapping in mappings.items():
            if mapping and mapping.get("_prefix"):
                self.prefixes.setdefault(term, str(mapping["@id"]))

    def redefine(self, shadow: ShadowedTerm) -> None:
        """Record that a term changes its meaning within one array of contexts."""
        self.shadows[shadow.term] = shadow

    def resolved(self, token: Text, resolution: Resolution) -> None:
        """Record that a token was expanded: a use of a term if it shadows another."""
        if resolution.reach is Reach.TERM:
            shadow = self.shadows.get(token)
            used = shadow is not None and shadow.iri == resolution.iri
        elif resolution.reach is Reach.PREFIX:
            shadow = self.shadows.get(token.partition(":")[0])
            used = shadow is not None and (resolution.iri or "").startswith(shadow.iri)
        else:
            return
        if shadow is None or not used:
            return
        first = self.shadow_uses.setdefault(shadow, token)
        if token.start < first.start:
            self.shadow_uses[shadow] = token


def _key(origin: Origin, value: Text) -> str | None:
    """Return the key of the member in which *value* stands."""
    for key, member in origin.element.items():
        if member is value or (isinstance(member, list) and any(e is value for e in member)):
            return str(key)
    return None
