"""Trees of links and joints that files describe, and what keeps them from being trees."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cache, cached_property

from kinlint.addresses import element_of, is_repeated
from kinlint.facts.elements_by_tag import elements, robot_elements
from kinlint.facts.fact_statements import fact, integer
from kinlint.facts.joint_trees import Edge
from kinlint.facts.mechanism import Mechanism, model_of
from kinlint.facts.metamodel_terms import attribute
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.facts.strongly_connected import strongly_connected_components
from kinlint.formats.records import BY_NAME
from kinlint.light_dataclasses import replace
from kinlint.suggestion import nearest
from kinlint.terms import Term, Triple, iri, is_literal, literal, literal_value
from kinlint.vocabulary import SRC

UNEXPANDED, MISSING_PART = iri(f"{SRC}Unexpanded"), iri(f"{SRC}MissingPart")
DOCUMENT = iri(f"{SRC}document")
MOST = 20
"""Most names that lead nowhere and are compared with all others: each takes linear time."""


class LinkTrees:
    """Links and joints of each robot whose file tells parent from child.

    Robots, bodies and joints are nodes of the lifted graph; facts are stated of their elements.
    Takes time linear in both.
    """

    def __init__(self, scan: PredicateIndex, mechanism: Mechanism) -> None:
        self.scan = scan
        self.mechanism = mechanism

    @cached_property
    def robots(self) -> Mapping[Term, Sequence[Edge]]:
        """Joints of each robot; an end is None where no link has the name that is written."""
        found: dict[Term, list[Edge]] = {robot: [] for robot in (*self._fixed, *self.links)}
        for edge in sorted(self.mechanism.edges, key=lambda each: each.joint):
            if edge.directed:
                ends = (end if end in self._known else None for end in (edge.parent, edge.child))
                parent, child = ends
                found.setdefault(model_of(edge.joint), []).append(
                    replace(edge, parent=parent, child=child)
                )
        return found

    @cached_property
    def links(self) -> Mapping[Term, Sequence[Term]]:
        """Bodies of each robot that files describe by elements."""
        found: dict[Term, list[Term]] = {}
        for body in sorted(self.mechanism.described):
            if self.mechanism.element(body) is not None:
                found.setdefault(model_of(body), []).append(body)
        return found

    @cached_property
    def _known(self) -> frozenset[Term]:
        return frozenset(body for bodies in self.links.values() for body in bodies)

    @cached_property
    def _fixed(self) -> Sequence[Term]:
        """Robots, each as its element, whose root most readers fix to the world."""
        found = (
            robot
            for document in self.scan.documents
            if BY_NAME[document.format.lifted_as].fixed_root
            for robot in robot_elements(self.scan, document)
        )
        return sorted(set(found))

    @cached_property
    def claims(self) -> Mapping[Term, Sequence[Edge]]:
        """Joints that name each body as their child, in the order of the text."""
        found: dict[Term, list[Edge]] = {}
        for edges in self.robots.values():
            for edge in edges:
                if edge.child is not None:
                    found.setdefault(edge.child, []).append(edge)
        for claimed in found.values():
            if len(claimed) > 1:
                claimed.sort(key=lambda edge: self.mechanism.place(edge.joint))
        return found

    @cached_property
    def above(self) -> Mapping[Term, Edge]:
        """Joint that carries each body: the first that names it as its child."""
        return {body: edges[0] for body, edges in self.claims.items()}

    @cached_property
    def roots(self) -> Mapping[Term, Sequence[Term]]:
        """Named bodies of each robot that no joint carries."""
        return {
            robot: [body for body in self.links.get(robot, ()) if self._is_root(body)]
            for robot in self.robots
        }

    def _is_root(self, body: Term) -> bool:
        return body not in self.above and not is_repeated(body) and bool(self._name(body))

    @property
    def bases(self) -> Iterator[Term]:
        """Bodies that nothing moves: roots that readers fix to the world, and the world itself."""
        for robot in self._fixed:
            links = self.links.get(robot, ())
            yield from (each for each in links if each not in self.above and not is_repeated(each))

    def _name(self, node: Term) -> str | None:
        """Return the name of the element that *node* was made of."""
        return self.attribute_text(self._element(node), "name")

    def attribute_text(self, element: Term, name: str) -> str | None:
        """Return the text of an attribute of *element*; None if it is not written."""
        value = self.scan.single(attribute(name)).get(element)
        return literal_value(value) if value is not None and is_literal(value) else None

    def _element(self, node: Term) -> Term:
        return self.mechanism.element(node) or element_of(node)

    def facts(self) -> Iterator[Triple]:
        """Yield the roots, the links with several parents or an unknown one, and joints in a cycle.

        Nothing of a robot whose text is still to be expanded: its names are not known.
        """
        for edges in self.claims.values():
            for edge in edges[1:]:
                if (claim := self._naming(edge.joint, "child")) is not None:
                    yield claim, fact("claimed-by"), self._element(edges[0].joint)
        for robot, edges in self.robots.items():
            if robot.partition("#")[0] in self._raw:
                continue
            links = self.links.get(robot, ())
            stated = element_of(robot)
            yield stated, fact("links"), integer(len(links))
            yield from self._rooted(robot, stated)
            yield from self._unresolved(robot, edges)
            for joint in self._cycles(edges):
                yield stated, fact("circle"), self._element(joint)

    def _naming(self, joint: Term, side: str) -> Term | None:
        """Return the first element that names the link at a *side* of *joint*."""
        owner = self._element(joint)
        found = elements(self.scan, owner, side)
        return next((each for each in found if not is_repeated(each)), None)

    def _rooted(self, robot: Term, stated: Term) -> Iterator[Triple]:
        """Yield the root of *robot*, and further ones, unless a joint reaches no known link."""
        roots = [self._element(body) for body in self.roots[robot]]
        edges = self.robots[robot]
        whole = all(edge.parent is not None and edge.child is not None for edge in edges)
        if len(roots) == 1:
            yield stated, fact("root"), roots[0]
        elif roots and whole:
            first, *others = sorted(roots, key=self.scan.place)
            for link in others:
                yield link, fact("root-beside"), first

    @cached_property
    def _raw(self) -> frozenset[Term]:
        """Documents, less the end of their tokens, in which something is missing or raw."""
        documents = self.scan.table(DOCUMENT)
        raw = (*self.scan.instances(UNEXPANDED), *self.scan.instances(MISSING_PART))
        return frozenset(each[:-1] for node in raw for each in documents.values(node))

    def _unresolved(self, robot: Term, edges: Iterable[Edge]) -> Iterator[Triple]:
        """Yield the elements that name a link which *robot* does not have, with a name like it."""
        ends = [(each, side) for each in edges for side in ("parent", "child")]
        lost = (
            self._naming(each.joint, side) for each, side in ends if getattr(each, side) is None
        )
        missing = sorted(element for element in lost if element is not None)
        if not missing:
            return
        names = [name for body in self.links.get(robot, ()) if (name := self._name(body))]
        near = cache(lambda name: nearest(name, names))
        for element in missing[:MOST]:
            name = self.attribute_text(element, "link")
            if name is not None:
                yield element, fact("unresolved"), literal(name)
                if (other := near(name)) is not None:
                    yield element, fact("near-name"), literal(other)

    def _cycles(self, edges: Iterable[Edge]) -> Iterator[Term]:
        """Yield one joint of each cycle of parents into which no joint leads from outside.

        No root carries its links. A joint between a link and itself does not count: it joins
        nothing.
        """
        above: dict[Term, list[Term]] = {}
        for edge in edges:
            if edge.child is not None and edge.parent is not None:
                above.setdefault(edge.child, []).append(edge.parent)
        for cycle in strongly_connected_components(above):
            own = set(cycle)
            if len(cycle) > 1 and all(own.issuperset(above[body]) for body in cycle):
                yield min(self.above[body].joint for body in cycle)
