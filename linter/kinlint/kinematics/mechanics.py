"""Bodies and joints of a model: who is fixed to whom, and which body carries each joint."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property

from kinlint.addresses import is_address, sibling
from kinlint.document import FROM, TREES
from kinlint.facts.component import ATTACHMENTS, ON_BODY
from kinlint.facts.names import attribute, chain, geom, kin, sdf
from kinlint.facts.scan import Place, Scan
from kinlint.kinematics.arrangement import Branch
from kinlint.terms import Term, iri, is_iri, literal_value
from kinlint.vocabulary import SRC

BODY, JOINT, FRAME = geom("RigidBody"), chain("Joint"), geom("Frame")
LISTS = geom("simplices")
TYPE = attribute("type")
TEXT = iri(f"{SRC}text")
FRAME_OF = "/frame>"
"""How the address of the frame ends that an element has, behind that of the element."""

KINDS = tuple(
    (kin(f"{name}Joint") if name != "Revolute" else chain("RevoluteJoint"), name.lower())
    for name in (
        *("Universal", "Revolute", "Prismatic", "Cylindrical", "Helical"),
        *("Spherical", "Planar", "Fixed", "Floating"),
    )
)
"""The classes of joints and what they are called; of a joint of several, the first counts."""
TWO_AXES = (kin("TwoAxisJoint"), "two-axis")


class Mechanics:
    """What is joined in a closed model; bodies and joints come in the order of the text."""

    def __init__(self, scan: Scan) -> None:
        self.scan = scan

    def place(self, node: Term) -> Place:
        """Sorts nodes by the text; one that was made of an element by that of the element."""
        origin = self.element(node)
        return self.scan.place(node if origin is None else origin)

    def element(self, node: Term) -> Term | None:
        """The element of a file that *node* was made of."""
        return min(self.scan.table(FROM).of(node), default=None)

    @cached_property
    def described(self) -> Sequence[Term]:
        """The bodies that files describe."""
        return sorted(self.scan.instances(BODY), key=self.place)

    @cached_property
    def joints(self) -> Sequence[Term]:
        """All joints, and what joins attachments without being called a joint."""
        joining = {joint for joint, _ in self.scan.table(ATTACHMENTS).items()}
        return sorted(self.scan.instances(JOINT) | joining, key=self.place)

    @cached_property
    def carrier(self) -> Mapping[Term, Term]:
        """The body that each attachment is on, described or not; of several, the first."""
        found: dict[Term, Term] = {}
        for node, bodies in self.scan.table(ON_BODY).items():
            found[node] = min(bodies, key=self.place) if len(bodies) > 1 else bodies[0]
        for body, parts in self.scan.table(LISTS).items():
            for part in parts:
                found.setdefault(part, body)
        return found

    @cached_property
    def frames(self) -> Mapping[Term, Sequence[Term]]:
        """The frames on each body."""
        found: dict[Term, list[Term]] = {}
        for frame in sorted(self.scan.instances(FRAME), key=self.place):
            if (body := self.carrier.get(frame)) is not None:
                found.setdefault(body, []).append(frame)
        return found

    @cached_property
    def branches(self) -> Sequence[Branch]:
        """Each joint with the bodies that it joins; what is attached to nothing is a body."""
        return list(map(self._branch, self.joints))

    @cached_property
    def bodies(self) -> Sequence[Term]:
        """All bodies, those that only joints speak of behind those that are described."""
        ends = (end for each in self.branches for end in each.ends)
        return tuple(dict.fromkeys((*self.described, *ends)))

    def near(self, joint: Term, body: Term | None) -> Term | None:
        """The attachment of *joint* on *body*."""
        return next((end for end in self.attachments(joint) if self._on(end) == body), None)

    def attachments(self, joint: Term) -> Sequence[Term]:
        """What *joint* is between, as written: that of the parent first, if one is said to be."""
        ends = self.scan.table(ATTACHMENTS).of(joint)
        own = f"{joint[:-1]}{FRAME_OF}"
        return sorted(ends, key=lambda end: (end != own, self._written.get((joint, end), 0), end))

    @cached_property
    def _written(self) -> Mapping[tuple[Term, Term], int]:
        """The order in which joints name their attachments."""
        said = (
            (s, o)
            for document in self.scan.documents
            if document.format not in TREES
            for s, p, o in document.statements
            if p == ATTACHMENTS
        )
        return {pair: index for index, pair in enumerate(said)}

    def _branch(self, joint: Term) -> Branch:
        ends = [self._on(end) for end in self.attachments(joint)]
        if self.element(joint) is None:
            known = [end for end in ends if end is not None]
            first, second = (known[at] if len(known) > at else None for at in range(2))
            return Branch(joint, first, second, tuple(known[2:]))
        own = f"{joint[:-1]}{FRAME_OF}"
        parent = self._on(own) or self._named(joint, "parent")
        child = next((self._on(end) for end in self.attachments(joint) if end != own), None)
        return Branch(joint, parent, child or self._named(joint, "child"), directed=True)

    def _on(self, attachment: Term) -> Term | None:
        """The body that *attachment* is on, or what stands for the one that is not there."""
        if (body := self.carrier.get(attachment)) is not None:
            return body
        if attachment in self._bodies or not is_address(attachment):
            return attachment
        owner = f"{attachment.removesuffix(FRAME_OF)}>"
        return owner if attachment.endswith(FRAME_OF) and owner not in self._known_joints else None

    @cached_property
    def _bodies(self) -> frozenset[Term]:
        return self.scan.instances(BODY)

    @cached_property
    def _known_joints(self) -> frozenset[Term]:
        return frozenset(self.joints)

    def _named(self, joint: Term, side: str) -> Term | None:
        """What an SDF joint calls its parent or child, where nothing bears that name."""
        element = self.element(joint)
        assert element is not None
        for said in self.scan.table(sdf(side)).of(element):
            for text in self.scan.table(TEXT).of(said):
                return sibling(joint, "link", literal_value(text).strip())
        return None

    def kind(self, joint: Term) -> str:
        """What kind of joint it is, as its file says, or by its class; nothing if neither does."""
        element = self.element(joint)
        for said in self.scan.table(TYPE).of(element) if element is not None else ():
            return literal_value(said)
        return next(self._kinds(joint), "")

    def _kinds(self, joint: Term) -> Iterator[str]:
        yield from (name for kind, name in (*KINDS, TWO_AXES) if joint in self.scan.instances(kind))


def named(node: Term) -> str:
    """The IRI of *node*, or its label if it has none."""
    return node[1:-1] if is_iri(node) else node
