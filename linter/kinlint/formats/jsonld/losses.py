"""Losses of JSON-LD: what an author wrote and RDF would drop, for the source layer."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, NamedTuple

from kinlint.formats.doubles import TOO_LARGE
from kinlint.formats.jsonld.expansion_observer import Slot
from kinlint.formats.jsonld.rdf_literals import malformed, too_large
from kinlint.formats.jsonld.traced_values import RELATIVE, Iri, Origin, Reach, Resolution
from kinlint.formats.jsonld.uri_schemes import REGISTERED
from kinlint.light_dataclasses import dataclass, replace
from kinlint.terms import XSD, Term, iri, literal
from kinlint.text import Span
from kinlint.vocabulary import KL

_MANNERS = frozenset({"NestedNode", "RepeatedValue"})
"""Kinds that concern the writing only: nothing of the node is lost."""

_FALLEN = frozenset({Reach.DOCUMENT_BASE, Reach.NOWHERE})


class Detail(NamedTuple):
    """A further property of a loss: a name in the source vocabulary, and a term."""

    name: str
    """Local name of the property in the source vocabulary."""
    value: Term
    """Its value."""


@dataclass(frozen=True)
class Loss:
    """A loss of a *kind* of the source vocabulary, at the token that is lost."""

    kind: str
    """Local name of the class in the source vocabulary."""
    span: Span
    """Place of what is lost."""
    node: Term | None = None
    """Node that it belonged to; None if there is none."""
    details: tuple[Detail, ...] = ()
    """Further properties."""

    @property
    def relation(self) -> str:
        """Name of its relation to the node: rules ignore a node with losses."""
        return "subject" if self.kind in _MANNERS else "node"

    def with_details(self, details: Iterable[Detail]) -> Loss:
        """Return a copy with further details."""
        return replace(self, details=(*self.details, *details))


def text_details(**texts: str) -> tuple[Detail, ...]:
    """Return details that are plain strings."""
    return tuple(Detail(name, literal(text)) for name, text in texts.items())


def unless(resolution: Resolution) -> tuple[Detail, ...]:
    """Return the name of the context that may give a meaning to what has none, if there is one."""
    return text_details(unless=resolution.unless) if resolution.unless else ()


@dataclass(frozen=True)
class LostType:
    """A loss of a type, with what another release is asked about it."""

    loss: Loss
    """The loss."""
    written: Iri
    """The type as written."""
    origin: Origin | None
    """The object that has the type; None for one outside of nodes."""


class Nested(NamedTuple):
    """A node that is described within *depth* others."""

    span: Span
    """Place of the object that describes the node."""
    node: Term
    """The node."""
    depth: int
    """Number of nodes around it."""
    slot: Slot
    """Property that it is a value of."""


class LossObserver:
    """Notices IRIs that are not what their author meant, on their way into the graph.

    What a context would explain that could not be read is uncertain, and told with its name.
    """

    def __init__(self) -> None:
        self.losses: list[Loss] = []
        self.types: list[LostType] = []
        self.values: list[tuple[str, Loss]] = []
        self.identifiers: set[str] = set()
        self.within: dict[Term, list[Nested]] = {}
        # By their addresses, which hold as long as they are kept.
        self._sound: dict[int, Resolution] = {}

    def seen(self, written: Iri, role: str, node: Term | None, slot: Slot | None = None) -> None:
        """Check *written*, which stands for a node, a property, a datatype or a value."""
        if written.resolution.reach in _FALLEN:
            self._reference(written, role, node, slot)
        elif role == "property" and written.startswith("_:"):
            details = text_details(key=written.token)
            self.losses.append(Loss("DroppedKey", written.span, node, details))
        self._absolute(written, node, slot)

    def note_repeated(self, node: Term, slot: Slot, value: Term, span: Span) -> None:
        """Note that a *value* of an unordered property of *node* is repeated at *span*."""
        details = (*_where(slot), Detail("value", value))
        self.losses.append(Loss("RepeatedValue", span, node, details))

    def nested(self, node: Term, slot: Slot, span: Span, depth: int, outermost: Term) -> None:
        """Note that *node* is described within *depth* other nodes.

        Remarks to kinlint do not count.
        """
        if slot.prop is None or not slot.prop.startswith(f"<{KL}"):
            self.within.setdefault(outermost, []).append(Nested(span, node, depth, slot))

    def nests(self) -> list[Loss]:
        """Return the first nested node in each outermost node, with the number of all in it."""
        losses = []
        for outermost, all_nested in self.within.items():
            first = min(all_nested)
            depth, count = max(each.depth for each in all_nested), len(all_nested)
            details = (
                *_where(first.slot),
                Detail("depth", literal(str(depth), f"{XSD}integer")),
                Detail("count", literal(str(count), f"{XSD}integer")),
                Detail("outermost", outermost),
            )
            losses.append(Loss("NestedNode", first.span, first.node, details))
        return losses

    def type(self, written: Iri, node: Term | None, origin: Origin | None) -> None:
        """Check *written*, which stands for the type of a node."""
        if written.resolution.reach in RELATIVE:
            details = (*text_details(written=written.token), *_target(written))
            loss = Loss("RelativeType", written.span, node, (*details, *unless(written.resolution)))
            self.types.append(LostType(loss, written, origin))
        else:
            self._absolute(written, node)

    def _absolute(self, written: Iri, node: Term | None, slot: Slot | None = None) -> None:
        if id(written.resolution) in self._sound:
            return
        resolution, (scheme, _, rest) = written.resolution, written.partition(":")
        # A term can be defined by a compact IRI whose prefix is not.
        defined_by_it = resolution.reach is Reach.TERM and scheme != "_"
        taken = resolution.reach is Reach.SCHEME or (defined_by_it and not rest.startswith("//"))
        if taken and scheme.lower() not in REGISTERED:
            details = text_details(prefix=scheme, written=written.token)
            details = (*details, *unless(resolution))
            self.losses.append(Loss("UndefinedPrefix", written.span, node, details))
        elif malformed(written):
            details = (*text_details(written=written.token), *(_where(slot) if slot else ()))
            self.losses.append(Loss("MalformedIri", written.span, node, details))
        else:
            self._sound[id(resolution)] = resolution

    def graph(self, written: Iri) -> None:
        """Check *written*, which names a graph."""
        if not malformed(written):
            name = Detail("name", iri(written))
            if not written.startswith("_:"):
                self.losses.append(Loss("NamedGraph", written.span, None, (name,)))

    def value(self, item: dict[str, Any], node: Term | None, span: Span) -> None:
        """Note that the literal at *span* is invalid.

        Impossible datatypes are reported elsewhere.
        """
        if "@language" in item and item.get("@type") is None:
            reason = f"'{item['@language']}' is not a language tag"
            details = text_details(written=str(item["@value"]), reason=reason)
            self.losses.append(Loss("LostValue", span, node, details))
        elif too_large(item):
            details = text_details(written=item["@value"], reason=TOO_LARGE)
            self.losses.append(Loss("LostValue", span, node, details))

    def _reference(self, written: Iri, role: str, node: Term | None, slot: Slot | None) -> None:
        details = (
            *text_details(written=written.token),
            *_target(written),
            *text_details(role=role),
            *unless(written.resolution),
        )
        if role == "value" and slot is not None and slot.prop is not None:
            details = (*details, Detail("property", slot.prop))
        loss = Loss("RelativeReference", written.span, node, details)
        if role == "value":
            self.values.append((written, loss))
        else:
            if role == "identifier":
                self.identifiers.add(written)
            self.losses.append(loss)

    def references(self) -> list[Loss]:
        """Return relative values, save those that name a node described by a relative `@id`."""
        return [loss for written, loss in self.values if written not in self.identifiers]


def _where(slot: Slot) -> tuple[Detail, ...]:
    prop = (Detail("property", slot.prop),) if slot.prop is not None else ()
    return (*prop, *text_details(key=slot.key))


def _target(written: Iri) -> tuple[Detail, ...]:
    if malformed(written) or written.resolution.reach is Reach.NOWHERE:
        return ()
    return (Detail("iri", iri(written)),)
