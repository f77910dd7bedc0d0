"""Expansion as far as it goes where packages are missing: what needs them is left out."""

from __future__ import annotations

import re
from collections.abc import Callable

from kinlint.formats.xacro.dom import Element
from kinlint.formats.xacro.expansion import Expansion, Fault
from kinlint.formats.xacro.expansion_limits import Limits
from kinlint.formats.xacro.expansion_session import Omitted, Session
from kinlint.formats.xacro.xacro_parser import ParsedXacro

PACKAGE = "package"
"""Kind of fault: a package is not found."""
ROUNDS = 40
"""Most elements that are left out; more depend on a package that is the robot itself."""
CONTAINERS = frozenset({"robot", "xacro:macro", "xacro:if", "xacro:unless"})
"""Elements whose children are left out one by one."""
_FOLLOWS = re.compile(
    r"there is no macro '|there is no property '|there is no block '"
    r"|.*(?:name '[^']*' is not defined|there is no '[^']*')",
    re.DOTALL,
)
"""Faults that the lack of definitions explains."""


def expand_as_far_as_possible(session: Callable[[Omitted], Session], bounds: Limits) -> Expansion:
    """Return the expansion by a *session*, without the elements that need a missing package.

    *session* makes one that leaves elements out, within *bounds* for all of them. Elements that
    lack a definition after that are left out, too. Any other fault ends the expansion, and so does
    too much that is missing.
    """
    omitted: Omitted = frozenset()
    first = expansion = session(omitted).expand()
    for _ in range(ROUNDS):
        fault = expansion.fault
        if fault is None or not _explained(fault, omitted):
            break
        element = _to_omit(fault, expansion)
        if element is None or (key := _key(element)) in omitted:
            break
        omitted |= {key}
        expansion = _continued(session(omitted).expand(), expansion, element)
    return first if expansion.fault is not None and bounds.exhausted else expansion


def _continued(expansion: Expansion, before: Expansion, element: Element) -> Expansion:
    """Return *expansion* with what is missing by the one *before* it, which lacked *element*."""
    known = {each.name: each for each in (*expansion.missing, *before.missing)}
    expansion.missing[:] = known.values()
    expansion.omitted[:] = [*before.omitted, element]
    return expansion


def _explained(fault: Fault, omitted: Omitted) -> bool:
    return fault.kind == PACKAGE or (bool(omitted) and _FOLLOWS.match(fault.reason) is not None)


def _key(element: Element) -> tuple[str, int]:
    return element.origin.source.name, element.origin.start


def _to_omit(fault: Fault, expansion: Expansion) -> Element | None:
    """Return the element to leave out so that *fault* does not occur; None if that is no way.

    A macro call, an include or a property alone; else all of a link, a joint or their like.
    """
    path = next((way for each in expansion.files.values() if (way := _path(each, fault))), [])
    if len(path) > 1 and path[-1].tagName.startswith("xacro:"):
        return None if path[-1].tagName == "xacro:macro" else path[-1]
    return next((each for each in path[1:] if each.tagName not in CONTAINERS), None)


def _path(parsed: ParsedXacro, fault: Fault) -> list[Element]:
    """Return the elements of *parsed* around the place of *fault*, the root first."""
    root = parsed.root
    if root is None or root.origin.source.name != fault.source.name:
        return []
    way = [root]
    while True:
        inner = next((each for each in way[-1].elements if _holds(each, fault)), None)
        if inner is None:
            return way
        way.append(inner)


def _holds(element: Element, fault: Fault) -> bool:
    return element.origin.start <= fault.span.start < element.origin.end
