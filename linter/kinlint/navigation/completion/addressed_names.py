"""Addresses of elements: URIs of ids, paths of scoped identifiers, and names of parameters."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinlint.formats.xml.element_types import Address
from kinlint.formats.xml.unfinished_text import TextElement
from kinlint.navigation.completion.candidate import Candidate, Kind

PARAMETER = "newparam"
BY_SID = frozenset({"rigid_body", "rigid_constraint"})
"""Tags of what is looked for in the physics model that is instanced."""
MOST = 2_000
"""Most elements whose instances are looked for."""


def candidates(address: Address, elements: Sequence[TextElement]) -> Iterator[Candidate]:
    """Yield what *address* can lead to among the *elements* of a text."""
    targets = frozenset(address.targets)
    if address.manner == "parameter":
        yield from _named("sid", [each for each in elements if each.tag == PARAMETER])
        return
    fitting = [each for each in elements if not targets or each.tag in targets]
    if address.manner == "uri":
        yield from _named("id", fitting, "#")
    elif targets and targets <= BY_SID:
        yield from _named("sid", fitting)
    elif address.manner == "sid":
        yield from _paths(fitting[:MOST], elements)


def _named(word: str, elements: Sequence[TextElement], mark: str = "") -> Iterator[Candidate]:
    for each in elements:
        if name := each.attributes.get(word):
            yield Candidate(f"{mark}{name}", Kind.NAME, each.tag)


def _paths(fitting: Sequence[TextElement], elements: Sequence[TextElement]) -> Iterator[Candidate]:
    """Yield the paths to the *fitting* ones among *elements*, also by way of an instance."""
    instances: dict[str, list[str]] = {}
    for each in elements:
        if (url := each.attributes.get("url", "")).startswith("#") and (path := _path(each)):
            instances.setdefault(url[1:], []).append(path)
    for each in fitting:
        own = each.attributes.get("id")
        if own and "sid" not in each.attributes:
            yield Candidate(own, Kind.NAME, each.tag)
        if not (path := _path(each)):
            continue
        around, _, sid = path.partition("/")
        for way in instances.get(around, ()):
            yield Candidate(f"{way}/{sid}", Kind.NAME, each.tag)
        yield Candidate(path, Kind.NAME, each.tag)


def _path(element: TextElement) -> str:
    """Return the id around *element* and its sid; empty if it has none of one of them."""
    sid = element.attributes.get("sid")
    around = (each.attributes.get("id") for each in element.ancestors)
    id_ = next(filter(None, around), None)
    return f"{id_}/{sid}" if sid and id_ else ""
