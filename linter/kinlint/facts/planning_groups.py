"""Planning groups of SRDF: the joints they comprise, and the links between two links."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from functools import cached_property

from kinlint.facts.dependency_cycles import parts
from kinlint.facts.elements_by_tag import elements, elements_by_parent
from kinlint.facts.fact_statements import fact, integer
from kinlint.facts.joint_trees import Edge
from kinlint.facts.link_trees import LinkTrees
from kinlint.facts.metamodel_terms import attribute, reference
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.facts.strongly_connected import strongly_connected_components
from kinlint.light_dataclasses import replace
from kinlint.terms import Term, Triple, iri, is_iri, literal
from kinlint.vocabulary import SRC

JOINED_TO = iri(f"{SRC}joinedTo")
ADJACENT, FIXED = literal("Adjacent"), literal("fixed")


class PlanningGroups:
    """SRDF files of a run that are joined to a URDF."""

    def __init__(self, scan: PredicateIndex, trees: LinkTrees) -> None:
        self.scan = scan
        self.trees = trees
        self.joined = scan.single(JOINED_TO)

    def facts(self) -> Iterator[Triple]:
        """Yield the joints and links of groups, lengths of chains, and links between pairs."""
        for semantic in sorted(self.joined):
            for group in elements(self.scan, semantic, "group"):
                for joint in sorted(self._comprises(group)):
                    yield group, fact("comprises"), joint
                    if (edge := self._edges.get(joint)) is not None and edge.child is not None:
                        yield group, fact("moves"), edge.child
                yield from self._chains(group)
            for pair in elements(self.scan, semantic, "disable_collisions"):
                if ADJACENT in self.scan.table(attribute("reason")).values(pair):
                    yield from ((pair, fact("between"), link) for link in self._between(pair))

    @cached_property
    def _comprised(self) -> Mapping[Term, frozenset[Term]]:
        """Joints of each group that has subgroups, or is one, those of its subgroups included."""
        arcs = parts(self.scan)
        found: dict[Term, frozenset[Term]] = {}
        for piece in strongly_connected_components(arcs):
            beyond = {each for group in piece for each in arcs.get(group, ())}.difference(piece)
            own = (self._listed(group) for group in piece)
            joints = frozenset[Term]().union(*own, *(found[each] for each in beyond))
            found.update(dict.fromkeys(piece, joints))
        return found

    def _comprises(self, group: Term) -> Collection[Term]:
        """Return the joints of *group*, those of its subgroups included."""
        return self._comprised[group] if group in self._comprised else self._listed(group)

    def _listed(self, group: Term) -> set[Term]:
        """Return the joints that *group* itself names.

        As such, by links that they carry, as a chain.
        """
        found: set[Term] = set()
        for joint in elements(self.scan, group, "joint"):
            found.update(self._refers(joint, "joint"))
        for link in elements(self.scan, group, "link"):
            found.update(self._carrier(target) for target in self._refers(link, "link"))
        for chain in elements(self.scan, group, "chain"):
            found.update(edge.joint for edge in self._way(*self._ends(chain)) or ())
        return found - {""}

    def _refers(self, element: Term, name: str) -> Sequence[Term]:
        return self.scan.table(reference(name)).values(element)

    def _carrier(self, link: Term) -> Term:
        """Return the joint that carries *link*: a virtual one where nothing else does."""
        edge = self._above.get(link)
        return edge.joint if edge is not None else self._virtual.get(link, "")

    @cached_property
    def _virtual(self) -> dict[Term, Term]:
        """Virtual joint of each link that has one."""
        table = self.scan.table(reference("child_link"))
        return {link: joint for joint, links in table.items() for link in links}

    @cached_property
    def _edges(self) -> dict[Term, Edge]:
        """Joints, with the links at their ends, as elements."""
        found: dict[Term, Edge] = {}
        for edges in self.trees.robots.values():
            for edge in edges:
                joint = self._element(edge.joint) or edge.joint
                ends = self._element(edge.parent), self._element(edge.child)
                found[joint] = replace(edge, joint=joint, parent=ends[0], child=ends[1])
        return found

    @cached_property
    def _above(self) -> Mapping[Term, Edge]:
        """Joint that carries each link, as elements."""
        carrying = (self._element(edge.joint) for edge in self.trees.above.values())
        found = (self._edges[joint] for joint in carrying if joint is not None)
        return {edge.child: edge for edge in found if edge.child is not None}

    def _element(self, node: Term | None) -> Term | None:
        return None if node is None else self.trees.mechanism.element(node)

    def _ends(self, element: Term, *names: str) -> tuple[Term | None, Term | None]:
        one, other = names or ("base_link", "tip_link")
        found = (next(iter(self._refers(element, name)), None) for name in (one, other))
        first, second = (link if link in self._links else None for link in found)
        return first, second

    @cached_property
    def _links(self) -> frozenset[Term]:
        found = elements_by_parent(self.scan, "link")
        return frozenset(link for _, links in found for link in links if is_iri(link))

    def _up(self, link: Term) -> dict[Term, Edge | None]:
        """Return *link* and the links above it, each with the joint that carries it."""
        found: dict[Term, Edge | None] = {}
        at: Term | None = link
        while at is not None and at not in found:
            found[at] = edge = self._above.get(at)
            at = edge.parent if edge is not None else None
        return found

    def _way(self, one: Term | None, other: Term | None) -> Sequence[Edge] | None:
        """Return the joints between two links: none for a link and itself, None without a path."""
        if one is None or other is None:
            return None
        near, far = self._up(one), self._up(other)
        if near.keys().isdisjoint(far):
            return None
        apart = near.keys() ^ far.keys()
        return [edge for link in apart if (edge := near.get(link) or far.get(link)) is not None]

    def _chains(self, group: Term) -> Iterator[Triple]:
        for chain in elements(self.scan, group, "chain"):
            way = self._way(*self._ends(chain))
            if way is not None:
                yield chain, fact("joints"), integer(len(way))

    def _between(self, pair: Term) -> Iterator[Term]:
        """Yield the links between those of *pair* that have collision shapes.

        MoveIt's setup assistant calls two links adjacent if no link with a shape is between them.
        None are told of links that no joint can move against each other: nothing is to be checked.
        """
        one, other = self._ends(pair, "link1", "link2")
        way = self._way(one, other) or ()
        kinds = self.scan.table(attribute("type"))
        if all(FIXED in kinds.values(edge.joint) for edge in way):
            return
        links = {link for edge in way for link in (edge.parent, edge.child)} - {one, other}
        yield from sorted(link for link in links if link and elements(self.scan, link, "collision"))
