"""Bodies and joints of a closed model.

The bodies that each joint joins, and what is on each body.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property

from kinlint.addresses import lifted_at, split, steps
from kinlint.document import FROM
from kinlint.facts.joint_trees import Edge
from kinlint.facts.metamodel_terms import attribute, chain, geom, kin
from kinlint.facts.predicate_index import Place, PredicateIndex
from kinlint.terms import Term, iri_value, is_iri, literal_value

BODY, JOINT, FRAME = geom("RigidBody"), chain("Joint"), geom("Frame")
LISTS = geom("simplices")
ON_BODY = kin("on-body")
ATTACHMENTS = chain("between-attachments")
SIDES = tuple((kin(f"{side}-attachment"), kin(f"{side}-body")) for side in ("parent", "child"))
"""The properties of a lifted joint that tell parent from child: the attachment, and its body."""
DIRECTED = tuple(term for side in SIDES for term in side)
TYPE = attribute("type")

KINDS = tuple(
    (kin(f"{name}Joint") if name != "Revolute" else chain("RevoluteJoint"), name.lower())
    for name in (
        *("Universal", "Revolute", "Prismatic", "Cylindrical", "Helical"),
        *("Spherical", "Planar", "Fixed", "Floating"),
    )
)
"""The classes of joints and what they are called; of a joint of several, the first counts."""
TWO_AXES = (kin("TwoAxisJoint"), "two-axis")


class Mechanism:
    """Bodies and joints of a closed model, in the order of the text."""

    def __init__(self, scan: PredicateIndex) -> None:
        self.scan = scan

    def place(self, node: Term) -> Place:
        """Return a key that sorts nodes by the text; a lifted one by its element."""
        origin = self.element(node)
        return self.scan.place(node if origin is None else origin)

    def element(self, node: Term) -> Term | None:
        """Return the element of a file that *node* was made of."""
        return min(self.scan.table(FROM).values(node), default=None)

    @cached_property
    def described(self) -> Sequence[Term]:
        """Bodies that files describe."""
        return sorted(sorted(self.scan.instances(BODY)), key=self.place)

    @cached_property
    def joints(self) -> Sequence[Term]:
        """All joints, and nodes that join attachments without being typed as joints."""
        joining = {joint for joint, _ in self.scan.table(ATTACHMENTS).items()}
        return sorted(sorted(self.scan.instances(JOINT) | joining), key=self.place)

    @cached_property
    def carrier(self) -> Mapping[Term, Term]:
        """Body that each attachment is on, described or not; of several, the first."""
        found: dict[Term, Term] = {}
        for node, bodies in self.scan.table(ON_BODY).items():
            found[node] = min(bodies, key=self.place) if len(bodies) > 1 else bodies[0]
        for body, parts in self.scan.table(LISTS).items():
            for part in parts:
                found.setdefault(part, body)
        return found

    @cached_property
    def frames(self) -> Mapping[Term, Sequence[Term]]:
        """Frames on each body."""
        found: dict[Term, list[Term]] = {}
        for frame in sorted(sorted(self.scan.instances(FRAME)), key=self.place):
            if (body := self.carrier.get(frame)) is not None:
                found.setdefault(body, []).append(frame)
        return found

    @cached_property
    def edges(self) -> Sequence[Edge]:
        """Each joint with the bodies that it joins; an attachment on no body counts as a body."""
        return list(map(self._edge, self.joints))

    @cached_property
    def bodies(self) -> Sequence[Term]:
        """All bodies, those that only joints name behind those that are described."""
        ends = (end for each in self.edges for end in each.ends)
        return tuple(dict.fromkeys((*self.described, *ends)))

    def on(self, body: Term) -> Callable[[Term], bool]:
        """Return the test whether *body* carries a frame or a point."""
        return lambda node: self.carrier.get(node) == body

    def near(self, joint: Term, body: Term | None) -> Term | None:
        """Return the attachment of *joint* on *body*."""
        ends = self.attachments(joint)
        return next((end for end in ends if self._on(joint, end) == body), None)

    def attachments(self, joint: Term) -> Sequence[Term]:
        """Return the attachments of *joint* as written.

        That of the parent first, if one is stated.
        """
        ends = self.scan.table(ATTACHMENTS).values(joint)
        own = self._sides[0][0].get(joint)
        return sorted(ends, key=lambda end: (end != own, self._written.get((joint, end), 0), end))

    @cached_property
    def _sides(self) -> Sequence[tuple[Mapping[Term, Term], Mapping[Term, Term]]]:
        """Attachment and body of each joint at its parent, and at its child."""
        return [(self.scan.single(end), self.scan.single(body)) for end, body in SIDES]

    @cached_property
    def _written(self) -> Mapping[tuple[Term, Term], int]:
        """Order in which joints name their attachments."""
        said = (
            (s, o)
            for document in self.scan.documents
            if not document.format.is_tree
            for s, p, o in document.statements
            if p == ATTACHMENTS
        )
        return {pair: index for index, pair in enumerate(said)}

    def _edge(self, joint: Term) -> Edge:
        if self.element(joint) is not None:
            parent, child = (bodies.get(joint) for _, bodies in self._sides)
            return Edge(joint, parent, child, directed=True)
        ends = [self._on(joint, end) for end in self.attachments(joint)]
        known = [end for end in ends if end is not None]
        first, second = (known[at] if len(known) > at else None for at in range(2))
        return Edge(joint, first, second, tuple(known[2:]))

    def _on(self, joint: Term, attachment: Term) -> Term | None:
        """Return the body that *attachment* is on, or a node that stands for a missing one."""
        if (body := self.carrier.get(attachment)) is not None:
            return body
        for ends, bodies in self._sides:
            if ends.get(joint) == attachment:
                return bodies.get(joint)
        return attachment

    def kind(self, joint: Term) -> str:
        """Return the type of a joint, as its file writes it, or by its class.

        Empty if neither tells.
        """
        element = self.element(joint)
        for said in self.scan.table(TYPE).values(element) if element is not None else ():
            return literal_value(said)
        return self.movement(joint)

    def movement(self, joint: Term) -> str:
        """Return what a joint is called by its class; empty if it is only a joint."""
        return next(self._kinds(joint), "")

    def _kinds(self, joint: Term) -> Iterator[str]:
        yield from (name for kind, name in (*KINDS, TWO_AXES) if joint in self.scan.instances(kind))


def named(node: Term) -> str:
    """Return the IRI of *node* without its brackets, or its label if it has none."""
    return node[1:-1] if is_iri(node) else node


def model_of(part: Term) -> Term:
    """Return the robot or the outermost model that an element's *part* is in, by its address."""
    way: list[str] = []
    kinds = ["world", "model"]
    for tag, name in steps(split(iri_value(part))[1], tuple(kinds)):
        if not name or tag not in kinds:
            break
        del kinds[: kinds.index(tag) + 1]
        way += (tag, name)
    return lifted_at(part, "/".join(way))
