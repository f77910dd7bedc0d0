"""Statements about the structure of COLLADA: roots of models, equal names, rings of instances."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinlint.formats.collada.addressing import Addressing
from kinlint.formats.collada.collada_elements import ColladaElement
from kinlint.formats.collada.kinematics import END, FULL, START, Model
from kinlint.formats.derived_statements import DerivedStatements
from kinlint.formats.xml.schema import TEXT

ENVIRONMENT = ("instance_light", "instance_camera")
"""Parts of a visual scene that are not those of a robot."""

PHYSICS = "physics_scene"


def state_models(root: ColladaElement, models: Sequence[Model], said: DerivedStatements) -> None:
    """State what is wrong with the links and joints of *models*, and if *root* instances none."""
    _state_left_out(root, models, said)
    for each in root.below() if any(model.joints for model in models) else ():
        if each.tag in ENVIRONMENT:
            said.word(each.node, "besideRobot", each.tag)
    for model in models:
        _state_roots(model, said)
        _state_attachments(model, said)
        for named in (model.links, [each.element for each in model.joints]):
            first: dict[str, ColladaElement] = {}
            for each in dict.fromkeys(named):
                name = each.text("name")
                if name and first.setdefault(name, each) is not each:
                    said.state(each.node, "sameNameAs", first[name].node)


def state_empty(root: ColladaElement, said: DerivedStatements) -> None:
    """State the elements below *root* that have no text where their type has a value.

    What leads elsewhere by its text is told as an address.
    """
    for each in root.below():
        slot = each.type.content
        has_value = each.said.get("") is not None or each.components or each.words is not None
        if slot is None or has_value or TEXT in each.type.addresses:
            continue
        if slot.reading[""] is None or "" in each.type.choices:
            said.word(each.node, "empty", each.tag)


def _state_left_out(root: ColladaElement, models: Sequence[Model], said: DerivedStatements) -> None:
    """State what the scene of *root*, or *root* without one, does not instance."""
    scenes = [*root.all("scene")] or [root]
    physics = [each for one in root.all("library_physics_scenes") for each in one.all(PHYSICS)]
    for scene in scenes:
        if models and models[0].links and scene.first("instance_kinematics_scene") is None:
            said.state(scene.node, "leavesOut", models[0].element.node)
        if physics and scene is not root and scene.first("instance_physics_scene") is None:
            said.state(scene.node, "leavesOutPhysics", physics[0].node)


def _state_attachments(model: Model, said: DerivedStatements) -> None:
    """State the attachments of *model* that lack their other half, or attach a joint once more."""
    for half in model.halves:
        said.word(half.node, "otherHalf", END if half.tag == START else START)
    first: dict[ColladaElement, ColladaElement] = {}
    for joint in model.joints:
        attached = joint.attachment
        if joint.end is None and first.setdefault(joint.named, attached) is not attached:
            said.state(attached.node, "attachedAfter", first[joint.named].node)


def _state_roots(model: Model, said: DerivedStatements) -> None:
    """State the links of *model* that nothing ties to its first one."""
    tied: dict[ColladaElement, list[ColladaElement]] = {}
    pairs = [(joint.parent, joint.child) for joint in model.joints if joint.end is not None]
    for link in model.links:
        pairs += ((link, child) for full in link.all(FULL) for child in full.all("link"))
    for one, other in pairs:
        tied.setdefault(one, []).append(other)
        tied.setdefault(other, []).append(one)
    reached: set[ColladaElement] = set()
    roots = model.roots
    for root in roots:
        if root in reached:
            continue
        if reached:
            said.state(root.node, "rootBeside", roots[0].node)
        pending = [root]
        while pending:
            at = pending.pop()
            if at not in reached:
                reached.add(at)
                pending += tied.get(at, ())


def state_rings(root: ColladaElement, addressing: Addressing, said: DerivedStatements) -> None:
    """State the instances below *root* by which an element contains itself."""
    done: set[ColladaElement] = set()
    open_: set[ColladaElement] = set()
    pending: list[tuple[ColladaElement, Iterator[ColladaElement]]] = [
        (root, _content(root, addressing))
    ]
    while pending:
        at, content = pending[-1]
        inner = next(content, None)
        open_.add(at)
        if inner is None:
            pending.pop()
            open_.discard(at)
            done.add(at)
        elif inner in open_:
            said.word(at.node, "ring", at.text("url"))
        elif inner not in done:
            pending.append((inner, _content(inner, addressing)))


def _content(element: ColladaElement, addressing: Addressing) -> Iterator[ColladaElement]:
    """Yield what is in *element*, and what it is an instance of."""
    yield from element.children
    inner = addressing.instanced(element)
    if inner is not None and element.tag.endswith(inner.tag):
        yield inner
