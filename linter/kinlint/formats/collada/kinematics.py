"""The joints and links of the kinematics models of a COLLADA document, with units resolved.

The motion of a joint stands between the transforms of an attachment and those of the child link
(COLLADA 1.5, attachment_full); the two halves of a joint that closes a loop both lead to its frame.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinlint.formats.collada.addressing import Addressing
from kinlint.formats.collada.asset_units import metres
from kinlint.formats.collada.collada_elements import ColladaElement
from kinlint.formats.collada.transforms import place
from kinlint.formats.rigid_transform import IDENTITY, Transform, inverse
from kinlint.light_dataclasses import dataclass, field
from kinlint.terms import Term

PRIMITIVES = ("revolute", "prismatic")
FULL, START, END = "attachment_full", "attachment_start", "attachment_end"


@dataclass(eq=False)
class Joint:
    """Joint between two links."""

    node: Term
    """Its node: that of its element, or one of its own where that is used several times."""
    element: ColladaElement
    """The joint that is attached."""
    named: ColladaElement
    """The joint or its instance in the model, as the attachment names it."""
    model: ColladaElement
    """The kinematics model."""
    attachment: ColladaElement
    """Attachment to the parent."""
    parent: ColladaElement
    """The link that carries it."""
    child: ColladaElement
    """The link that it moves."""
    on_parent: Transform | None
    """Pose of its frame in the parent at zero, in metres; None if unknown."""
    on_child: Transform | None
    """Pose of its frame in the child."""
    end: ColladaElement | None = None
    """Attachment to the child, if it closes a loop."""

    @property
    def primitives(self) -> Sequence[ColladaElement]:
        """The motions it is made of, in their order."""
        return [*self.element.all(*PRIMITIVES)]


@dataclass(eq=False)
class Model:
    """Kinematics model."""

    element: ColladaElement
    """Its element."""
    joints: list[Joint] = field(default_factory=list)
    """Its joints."""
    links: list[ColladaElement] = field(default_factory=list)
    """Its links, each behind the one that carries it."""
    halves: list[ColladaElement] = field(default_factory=list)
    """The attachments of joints that close loops of which the other half is missing."""

    @property
    def roots(self) -> list[ColladaElement]:
        """The links that no attachment carries."""
        return [each for each in self.links if each.parent and each.parent.tag != FULL]


def models(root: ColladaElement, addressing: Addressing) -> list[Model]:
    """Return the kinematics models below *root*, once each, however often they are instanced."""
    reader = _Models(addressing)
    libraries = root.all("library_kinematics_models")
    return [reader.model(each) for one in libraries for each in one.all("kinematics_model")]


class _Models:
    def __init__(self, addressing: Addressing) -> None:
        self.addressing = addressing
        self._uses: dict[ColladaElement, int] = {}

    def model(self, element: ColladaElement) -> Model:
        model = Model(element)
        halves: dict[ColladaElement, dict[str, ColladaElement]] = {}
        technique = element.first("technique_common")
        for link in _links(technique) if technique is not None else ():
            model.links.append(link)
            for each in link.all(FULL, START, END):
                named, joint = self._joint(each)
                if named is None or joint is None:
                    continue
                if each.tag == FULL:
                    model.joints += self._full(model, joint, named, each, link)
                else:
                    halves.setdefault(named, {}).setdefault(each.tag, each)
        for named, found in halves.items():
            if START in found and END in found:
                model.joints.append(self._loop(model, named, found[START], found[END]))
            else:
                model.halves += found.values()
        return model

    def _joint(
        self, attachment: ColladaElement
    ) -> tuple[ColladaElement | None, ColladaElement | None]:
        """Return what *attachment* names, and the joint that it is or is an instance of."""
        found = self.addressing.by_path(attachment.text("joint"), attachment)
        if not isinstance(found, ColladaElement):
            return None, None
        joint = self.addressing.instanced(found) if found.tag == "instance_joint" else found
        return found, joint if joint is not None and joint.tag == "joint" else None

    def _full(
        self,
        model: Model,
        joint: ColladaElement,
        named: ColladaElement,
        attachment: ColladaElement,
        link: ColladaElement,
    ) -> Iterator[Joint]:
        for child in attachment.all("link"):
            own = place(child, metres(child))
            on_child = None if own is None else IDENTITY if own == IDENTITY else inverse(own)
            on_parent = place(attachment, metres(attachment))
            node = self._node(joint)
            yield Joint(
                node, joint, named, model.element, attachment, link, child, on_parent, on_child
            )
            return

    def _loop(
        self, model: Model, named: ColladaElement, start: ColladaElement, end: ColladaElement
    ) -> Joint:
        parent, child = start.parent, end.parent
        assert parent is not None
        assert child is not None
        joint = self._joint(start)[1] or named
        on_parent, on_child = (place(each, metres(each)) for each in (start, end))
        node = self._node(joint)
        return Joint(
            node, joint, named, model.element, start, parent, child, on_parent, on_child, end
        )

    def _node(self, joint: ColladaElement) -> Term:
        count = self._uses[joint] = self._uses.get(joint, 0) + 1
        return joint.node if count == 1 else f"{joint.node[:-1]}/use/{count}>"


def _links(technique: ColladaElement) -> Iterator[ColladaElement]:
    pending = [*technique.all("link")][::-1]
    while pending:
        link = pending.pop()
        yield link
        carried = (each for full in link.all(FULL) for each in full.all("link"))
        pending += [*carried][::-1]
