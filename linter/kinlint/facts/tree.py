"""The trees of links and joints that URDF files describe, and what keeps them from being trees."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, cached_property

from kinlint.addresses import child, is_repeated, root_of
from kinlint.facts.names import attribute, urdf
from kinlint.facts.scan import Scan
from kinlint.facts.statement import fact, integer
from kinlint.suggestion import nearest
from kinlint.terms import Term, Triple, iri, is_literal, literal, literal_value
from kinlint.vocabulary import SRC

UNEXPANDED = iri(f"{SRC}Unexpanded")
DOCUMENT = iri(f"{SRC}document")
MOST = 20
"""Names that lead nowhere are compared with all others, which for more of them would take long."""


@dataclass(frozen=True, slots=True)
class Edge:
    """One joint: its type, and the links at its two ends, None where no link has that name.

    `base` and `claim` are the elements that name parent and child.
    """

    joint: Term
    kind: str
    parent: Term | None
    child: Term | None
    base: Term | None
    claim: Term | None


class Trees:
    """The links and joints of each robot."""

    def __init__(self, scan: Scan) -> None:
        self.scan = scan

    @cached_property
    def robots(self) -> Mapping[Term, tuple[Edge, ...]]:
        """All robots that are written in URDF, each with its joints."""
        joints = self.scan.table(urdf("joint"))
        return {robot: tuple(map(self._edge, joints.of(robot))) for robot in self._named}

    @cached_property
    def _named(self) -> Sequence[Term]:
        """The elements that are robots."""
        table = self.scan.table(urdf("robot"))
        return sorted({root for _, roots in table.items() for root in roots})

    def _edge(self, joint: Term) -> Edge:
        (base, parent), (claim, child) = (self._end(joint, side) for side in ("parent", "child"))
        return Edge(joint, self.said(joint, "type") or "", parent, child, base, claim)

    def _end(self, joint: Term, side: str) -> tuple[Term | None, Term | None]:
        """The first element that says what is at a *side* of *joint*, and the link it names."""
        elements = self.scan.table(urdf(side)).of(joint)
        element = next((each for each in elements if not is_repeated(each)), None)
        name = self.said(element, "link") if element is not None else None
        if name is None:
            return element, None
        link = child(root_of(joint), "link", name)
        return element, link if link in self._links else None

    def said(self, element: Term, name: str) -> str | None:
        """The text of an attribute."""
        value = self.scan.single(attribute(name)).get(element)
        return literal_value(value) if value is not None and is_literal(value) else None

    @cached_property
    def _links(self) -> frozenset[Term]:
        table = self.scan.table(urdf("link"))
        return frozenset(link for robot in self._named for link in table.of(robot))

    @cached_property
    def _claims(self) -> Mapping[Term, Sequence[Edge]]:
        """The joints that name each link as their child, in the order of the text."""
        found: dict[Term, list[Edge]] = {}
        for edges in self.robots.values():
            for edge in edges:
                if edge.child is not None:
                    found.setdefault(edge.child, []).append(edge)
        for claimed in found.values():
            if len(claimed) > 1:
                claimed.sort(key=lambda edge: self.scan.place(edge.joint))
        return found

    @cached_property
    def above(self) -> Mapping[Term, Edge]:
        """The joint that carries each link: the first that names it as its child."""
        return {link: edges[0] for link, edges in self._claims.items()}

    @cached_property
    def roots(self) -> Mapping[Term, tuple[Term, ...]]:
        """The links of each robot that no joint carries."""
        return {robot: tuple(self._roots(robot)) for robot in self.robots}

    def _roots(self, robot: Term) -> Iterator[Term]:
        for link in self.scan.table(urdf("link")).of(robot):
            carried = link in self.above or is_repeated(link)
            if not carried and self.said(link, "name"):
                yield link

    def facts(self) -> Iterator[Triple]:
        """The roots, the links that several joints carry or none has, and joints in a circle.

        Nothing of a robot whose text is still to be expanded: its names are not known.
        """
        for edges in self._claims.values():
            for edge in edges[1:]:
                if edge.claim is not None:
                    yield edge.claim, fact("claimed-by"), edges[0].joint
        for robot, edges in self.robots.items():
            if robot.partition("#")[0] in self._raw:
                continue
            links = self.scan.table(urdf("link")).of(robot)
            yield robot, fact("links"), integer(len(links))
            yield from self._rooted(robot, edges)
            yield from self._unresolved(robot, edges)
            for joint in self._circles(robot, edges):
                yield robot, fact("circle"), joint

    def _rooted(self, robot: Term, edges: Iterable[Edge]) -> Iterator[Triple]:
        """The root of *robot*, and further ones, unless a joint of it reaches no known link."""
        roots = self.roots[robot]
        whole = all(edge.parent is not None and edge.child is not None for edge in edges)
        if len(roots) == 1:
            yield robot, fact("root"), roots[0]
        elif roots and whole:
            first, *others = sorted(roots, key=self.scan.place)
            for link in others:
                yield link, fact("root-beside"), first

    @cached_property
    def _raw(self) -> frozenset[Term]:
        """The documents, less the end of their tokens, in which something is not expanded."""
        documents = self.scan.table(DOCUMENT)
        raw = self.scan.instances(UNEXPANDED)
        return frozenset(each[:-1] for node in raw for each in documents.of(node))

    def _unresolved(self, robot: Term, edges: Iterable[Edge]) -> Iterator[Triple]:
        """The elements that name a link which *robot* does not have, with a name like it."""
        ends = [(edge.base, edge.parent) for edge in edges]
        ends += [(edge.claim, edge.child) for edge in edges]
        missing = [element for element, link in ends if link is None and element is not None]
        if not missing:
            return
        named = [self.said(link, "name") for link in self.scan.table(urdf("link")).of(robot)]
        known = [name for name in named if name]
        near = cache(lambda name: nearest(name, known))
        for element in sorted(missing)[:MOST]:
            name = self.said(element, "link")
            if name is not None:
                yield element, fact("unresolved"), literal(name)
                if (other := near(name)) is not None:
                    yield element, fact("near-name"), literal(other)

    def _circles(self, robot: Term, edges: Iterable[Edge]) -> Iterator[Term]:
        """One joint of each circle: there, the way from child to parent comes to no root.

        A joint between a link and itself is not meant: it joins nothing.
        """
        done = {*self.roots[robot], *(edge.child for edge in edges if edge.child == edge.parent)}
        for edge in edges:
            way: dict[Term, Term] = {}
            link = edge.child
            while link is not None and link not in done and link not in way:
                carrier = self.above.get(link)
                if carrier is None:
                    break
                way[link] = carrier.joint
                link = carrier.parent
            if link is not None and link in way:
                yield way[link]
            done.update(way)
