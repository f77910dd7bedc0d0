"""The outline of a text: its robots as trees of links and joints, and all else that has a name."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from enum import Enum, auto
from typing import TypeAlias

from kinlint.addresses import last_tag, lifted
from kinlint.light_dataclasses import dataclass, field
from kinlint.navigation.index import Index
from kinlint.navigation.occurrence import Entity, Role
from kinlint.navigation.xacro_names import label
from kinlint.structure import Frame, Joint, Part, Structure
from kinlint.terms import Term, iri_value, is_blank, is_iri
from kinlint.text import Location, Span

DEEPEST = 40
"""Most levels of symbols; what hangs deeper becomes a sibling of the last one."""

Named: TypeAlias = tuple[Location | None, str]
"""A place where something is named, and the IRI of the frame that it is."""


class Sort(Enum):
    """Sort of thing that a symbol stands for."""

    ROBOT = auto()
    LINK = auto()
    JOINT = auto()
    FRAME = auto()
    MACRO = auto()
    PROPERTY = auto()
    OTHER = auto()


@dataclass
class Symbol:
    """A named thing of a file."""

    name: str
    """Its name."""
    detail: str
    """More about it."""
    sort: Sort
    """Its kind."""
    whole: Span
    """The span of its description."""
    identifier: Span
    """The span of its name, which lies in it."""
    below: list[Symbol] = field(default_factory=list)
    """The symbols in it."""


def outline(
    name: str, structures: Iterable[Structure], index: Index, types: Callable[[Entity], str]
) -> Sequence[Symbol]:
    """Return the symbols of the text called *name*; *types* tells what a node is.

    A part that another text describes is left out, and what hangs below it is hung higher.
    """
    symbols: list[Symbol] = []
    described = (each for each in index.occurrences if each.role is Role.DESCRIPTION)
    frames = {(each.location, _frame(each.entity)) for each in described}
    for structure in structures:
        tree = _tree(name, structure, frames)
        robot = _symbol(name, structure, structure.name, "robot", Sort.ROBOT)
        if tree and robot is not None:
            robot.below = tree
            symbols.append(robot)
        else:
            symbols += tree
    known = {each.identifier for each in _everything(symbols)}
    symbols += _others(name, index, known, None if symbols else types)
    return symbols


def _tree(name: str, structure: Structure, frames: Collection[Named]) -> list[Symbol]:
    """Return the symbols of one robot, as it hangs together, with those of *frames* that it has."""
    tops: list[Symbol] = []
    holders: list[tuple[list[Symbol], int]] = []
    for step in structure.steps():
        place, depth = holders[step.above] if step.above >= 0 else (tops, 0)
        symbol = _part(name, step.part, frames)
        if symbol is None:
            holders.append((place, depth))
            continue
        place.append(symbol)
        deeper = depth + 1 < DEEPEST
        holders.append((symbol.below, depth + 1) if deeper else (place, depth))
    return tops


def _part(name: str, part: Part, frames: Collection[Named]) -> Symbol | None:
    """Return the symbol of *part*; that of a link has those of *frames* below that are its."""
    if isinstance(part, Joint):
        detail = f"{part.kind} joint" if part.kind else "joint"
        return _symbol(name, part, part.name, detail, Sort.JOINT)
    symbol = _symbol(name, part, part.name, "link", Sort.LINK)
    if symbol is not None:
        own = (each for each in part.frames if (each.location, each.iri) in frames)
        below = (
            _symbol(name, each, each.name.removesuffix("/frame"), "frame", Sort.FRAME)
            for each in own
        )
        symbol.below = [each for each in below if each is not None]
    return symbol


def _symbol(
    name: str, placed: Structure | Part | Frame, title: str, detail: str, sort: Sort
) -> Symbol | None:
    location, whole = placed.location, placed.whole
    if location is None or location.source.name != name:
        return None
    span = location.span
    if whole is None or whole.source.name != name or not _within(span, whole.span):
        return Symbol(title, detail, sort, span, span)
    return Symbol(title, detail, sort, whole.span, span)


def _others(
    name: str, index: Index, known: set[Span], types: Callable[[Entity], str] | None
) -> Iterator[Symbol]:
    """Yield what else is described in the text: without *types*, only what xacro defines."""
    for each in index.occurrences:
        span = each.location.span
        if each.location.source.name != name or each.role is not Role.DESCRIPTION:
            continue
        if span in known or is_blank(each.entity):
            continue
        written = each.location.source[span].strip('"')
        if (xacro := label(each.entity)) is not None:
            kind, title = xacro
            if kind != "parameter":
                known.add(span)
                sort = Sort.MACRO if kind == "macro" else Sort.PROPERTY
                yield Symbol(title, kind, sort, span, span)
        elif types is not None and written:
            known.add(span)
            detail = _kind(each.entity) or types(each.entity)
            yield Symbol(written, detail, Sort.OTHER, span, span)


def _frame(entity: Entity) -> str:
    """Return the IRI of the frame that *entity* is, or that its element stands for."""
    own = iri_value(entity) if is_iri(entity) else ""
    return f"{lifted(own)}/frame" if _kind(entity) == "frame" else own


def _kind(entity: Term) -> str:
    """Return the tag of an element by its address, such as a group; empty for other nodes."""
    return last_tag(entity)


def _everything(symbols: Sequence[Symbol]) -> Iterator[Symbol]:
    waiting = list(symbols)
    while waiting:
        symbol = waiting.pop()
        yield symbol
        waiting += symbol.below


def _within(inner: Span, outer: Span) -> bool:
    return outer.start <= inner.start and inner.end <= outer.end
