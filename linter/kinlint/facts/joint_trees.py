"""Trees of joints: which end is the parent, where the roots are, and which joints close loops."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator, Mapping, Sequence

from kinlint.facts.strongly_connected import strongly_connected_components
from kinlint.light_dataclasses import dataclass, field, replace
from kinlint.terms import Term


@dataclass(frozen=True, slots=True)
class Edge:
    """Joint with the bodies at its ends."""

    joint: Term
    """Joint itself."""
    parent: Term | None
    """Body on the side of the root; None where none is stated."""
    child: Term | None
    """Body on the other side; None where none is stated."""
    others: tuple[Term, ...] = ()
    """Further bodies of a joint that joins more than two."""
    directed: bool = False
    """True if the file states which is the parent; otherwise ends come as written."""
    closes: bool = False
    """True if it closes a loop: its child hangs elsewhere."""

    @property
    def ends(self) -> tuple[Term, ...]:
        """All bodies that it joins, each once."""
        found = (self.parent, self.child, *self.others)
        return tuple(dict.fromkeys(end for end in found if end is not None))


@dataclass(frozen=True)
class JointTrees:
    """Edges in the order in which they were given, and the bodies that trees begin with."""

    edges: Sequence[Edge] = ()
    """Edges from parent to child, in the order in which they were given."""
    roots: Sequence[Term] = field(default=())
    """Bodies that trees begin with."""


def arrange_joints(bodies: Sequence[Term], edges: Sequence[Edge]) -> JointTrees:
    """Return the trees that *edges* make of *bodies*, which have all their ends.

    Both are in text order. Directed edges keep their parents; others span each component
    breadth-first (Featherstone, Rigid Body Dynamics Algorithms, 2008, on connectivity: a
    spanning tree and loop joints). Takes linear time.
    """
    directed = [each for each in edges if each.directed]
    loose = [each for each in edges if not each.directed]
    held = {end for each in directed for end in each.ends}
    reached = {end for each in loose for end in each.ends} - held
    told = [body for body in bodies if body not in reached]
    found, roots = _followed(told, directed)
    spread, starts = _spread([body for body in bodies if body in reached], loose, held)
    done = {each.joint: each for each in (*found, *spread)}
    first = {*roots, *(body for body in starts if body not in held)}
    return JointTrees(
        [done[each.joint] for each in edges], [body for body in bodies if body in first]
    )


def _followed(bodies: Sequence[Term], edges: Sequence[Edge]) -> tuple[list[Edge], list[Term]]:
    """Return the trees of directed edges: the first joint that claims a body carries it.

    The first body of a cycle is a root.
    """
    carrier: dict[Term, Edge] = {}
    for each in edges:
        if each.child is not None and each.child != each.parent:
            carrier.setdefault(each.child, each)
    for root in list(_cycles(bodies, carrier)):
        del carrier[root]
    closing = (each.child is not None and carrier.get(each.child) is not each for each in edges)
    found = [replace(each, closes=is_) for each, is_ in zip(edges, closing, strict=True)]
    return found, [body for body in bodies if body not in carrier]


def _cycles(bodies: Sequence[Term], carrier: Mapping[Term, Edge]) -> Iterator[Term]:
    """Yield the first body of each cycle."""
    place = {body: index for index, body in enumerate(bodies)}
    above = {
        body: [edge.parent] if edge.parent is not None else [] for body, edge in carrier.items()
    }
    for cycle in strongly_connected_components(above):
        if len(cycle) > 1:
            yield min(cycle, key=lambda each: place.get(each, len(place)))


def _spread(
    bodies: Sequence[Term], edges: Sequence[Edge], held: Iterable[Term]
) -> tuple[list[Edge], list[Term]]:
    """Return trees that spread from one body of each component, the first that is nobody's child.

    Or from those *held* by other trees, if the component has one.
    """
    near: dict[Term, list[Edge]] = {}
    for each in edges:
        for end in each.ends:
            near.setdefault(end, []).append(each)
    children = {end for each in edges for end in (each.child, *each.others)}
    fitting = [body for body in bodies if body not in children]
    done: dict[Term, Edge] = {}
    starts = [body for body in held if body in near]
    seen = set(starts)
    for start in starts:
        _grow(start, near, seen, done)
    for start in (*fitting, *bodies):
        if start not in seen:
            starts.append(start)
            seen.add(start)
            _grow(start, near, seen, done)
    for each in edges:
        done.setdefault(each.joint, each)
    return list(done.values()), starts


def _grow(
    start: Term, near: Mapping[Term, Sequence[Edge]], seen: set[Term], done: dict[Term, Edge]
) -> None:
    """Grow a tree from *start* to all that it reaches, nearest first."""
    waiting = deque([start])
    while waiting:
        body = waiting.popleft()
        for each in near.get(body, ()):
            if each.joint in done:
                continue
            ends = [end for end in each.ends if end != body]
            fresh = [end for end in ends if end not in seen]
            whole = each.parent is not None and each.child is not None
            chosen = fresh or ends[:1] or [body] * whole
            done[each.joint] = replace(
                each,
                parent=body,
                child=chosen[0] if chosen else None,
                others=tuple(chosen[1:]),
                closes=whole and not fresh,
            )
            seen.update(fresh)
            waiting.extend(fresh)
