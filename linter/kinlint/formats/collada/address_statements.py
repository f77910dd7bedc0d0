"""Ends of the addresses in a COLLADA document, and the addresses that lead to none."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.formats.collada.addressing import Addressing, Missing
from kinlint.formats.collada.collada_elements import ColladaElement
from kinlint.formats.source_layer import src
from kinlint.formats.xml.element_types import Address
from kinlint.formats.xml.schema import TEXT
from kinlint.terms import Term, Triple, iri, iri_value, literal, literal_value
from kinlint.vocabulary import REFERENCE

OPENRAVE = "OpenRAVE"
"""The profile whose techniques are known; those of others are opaque."""
SYMBOL = "csymbol"
LEADER = Address(iri(f"{REFERENCE}leader"), "parameter", ())
"""Address by which a symbol in a formula leads to a joint."""


def address_statements(
    root: ColladaElement, addressing: Addressing
) -> Iterator[tuple[Triple, Triple | None]]:
    """Yield what follows from the addresses below *root*, each with the statement of the address.

    A text that is empty has no statement.

    That is what leads to the element that is addressed (`ref:`), or else a gap (`src:dangling`),
    and elements that are not of a kind that is to be addressed there (`src:unfit`).
    """
    for element in root.below():
        for place, address in _addresses(element):
            source = element.said.get(_name(place))
            written = element.text(_name(place))
            is_stated = source is not None or place == TEXT
            if not is_stated or not _is_known(element):
                continue
            found = _look_up(addressing, element, address, written) if written else Missing("")
            if isinstance(found, Missing):
                yield from ((each, source) for each in _gap(element, place, source, address, found))
            elif found is not None and source is not None:
                yield (element.node, address.predicate, found.node), source
                meant = addressing.followed(found)
                if meant is not None and address.targets and meant.tag not in address.targets:
                    for each in _unfit(element, place, source, address, meant):
                        yield each, source


def _addresses(element: ColladaElement) -> Iterator[tuple[Term, Address]]:
    yield from element.type.addresses.items()
    if element.tag == SYMBOL and any(each.tag == "formula" for each in element.ancestors()):
        yield TEXT, LEADER


def _name(place: Term) -> str:
    """Return the attribute of the property *place*; empty for the text."""
    return "" if place == TEXT else iri_value(place).rpartition("#")[2]


def _is_known(element: ColladaElement) -> bool:
    """Tell whether *element* is in no technique of an unknown profile."""
    return all(
        each.tag != "technique" or each.text("profile") == OPENRAVE for each in element.ancestors()
    )


def _look_up(
    addressing: Addressing, element: ColladaElement, address: Address, written: str
) -> ColladaElement | Missing | None:
    if address.manner == "uri":
        return addressing.by_uri(written)
    if address.manner == "sid":
        return addressing.by_path(written, element)
    return addressing.by_parameter(written, element)


def _gap(
    element: ColladaElement,
    place: Term,
    source: Triple | None,
    address: Address,
    missing: Missing,
) -> Iterator[Triple]:
    gap = _derived(element, address)
    written = source[2] if source is not None else literal("")
    yield element.node, src("dangling"), gap
    yield gap, src("property"), place
    yield gap, src("written"), written
    bare = address.manner == "uri" and "#" not in literal_value(written)
    yield gap, src("manner"), literal("file" if bare else address.manner)
    yield gap, src("step"), literal(missing.step)
    if missing.within is not None:
        yield gap, src("within"), missing.within.node


def _unfit(
    element: ColladaElement, place: Term, source: Triple, address: Address, found: ColladaElement
) -> Iterator[Triple]:
    node = _derived(element, address)
    yield element.node, src("unfit"), node
    yield node, src("property"), place
    yield node, src("written"), source[2]
    yield node, src("tag"), literal(found.tag)
    yield node, src("target"), found.node
    yield node, src("expected"), literal(_listed(address.targets))


def _derived(element: ColladaElement, address: Address) -> Term:
    return f"{element.node[:-1]};{iri_value(address.predicate).rpartition('#')[2]}>"


def _listed(tags: tuple[str, ...]) -> str:
    *most, last = (f"<{tag}>" for tag in tags)
    return f"{', '.join(most)} or {last}" if most else last
