"""Assemblies: bodies that joints put together, each joint turned away from the root."""

from __future__ import annotations

from collections.abc import Sequence

from kinlint.formats.usd.physics_joints import ROOT, PhysicsJoint
from kinlint.formats.usd.stage import StagePrim
from kinlint.light_dataclasses import dataclass, field


@dataclass(eq=False)
class Assembly:
    """Bodies that joints connect without the world, with these joints."""

    bodies: list[StagePrim] = field(default_factory=list)
    """Bodies, in the order in which joints name them."""
    joints: list[PhysicsJoint] = field(default_factory=list)
    """Joints, in the order of their prims."""
    root: StagePrim | None = None
    """Body that the others follow; None if the world carries it, or nothing tells."""

    @property
    def base(self) -> StagePrim:
        """The body that stands for it: its root, or else its first one."""
        return self.root or self.bodies[0]


class _Groups:
    """Bodies in groups, each called by one of its bodies."""

    def __init__(self) -> None:
        self.above: dict[StagePrim, StagePrim] = {}

    def find(self, body: StagePrim) -> StagePrim:
        """Return the body by which the group of *body* is called."""
        above = self.above
        while above.setdefault(body, body) is not body:
            above[body] = above[above[body]]
            body = above[body]
        return body


def assemblies(joints: Sequence[PhysicsJoint]) -> list[Assembly]:
    """Return the assemblies that *joints* make, each joint turned so that the parent comes first.

    Joints of a tree are turned away from its root; where nothing tells it, body0 is the parent.
    """
    groups = _Groups()
    for joint in joints:
        names = [groups.find(side.body) for side in joint.sides if side.body is not None]
        groups.above[names[-1]] = names[0]
    found: dict[StagePrim, Assembly] = {}
    for body in groups.above:
        found.setdefault(groups.find(body), Assembly()).bodies.append(body)
    for joint in joints:
        first = joint.sides[0].body or joint.sides[1].body
        if first is not None:
            found[groups.find(first)].joints.append(joint)
    for each in found.values():
        each.root = _root(each)
        _turn(each)
    return list(found.values())


def _root(assembly: Assembly) -> StagePrim | None:
    """Return the body with the root schema, or that the world carries, or that no joint moves."""
    tree = [each for each in assembly.joints if not each.closes_loop]
    marked = [each for each in assembly.bodies if each.has(ROOT)]
    if len(marked) == 1:
        return marked[0]
    carried = [
        j.sides[1].body or j.sides[0].body for j in tree if None in (s.body for s in j.sides)
    ]
    if len(carried) == 1:
        return carried[0]
    moved = {joint.sides[1].body for joint in tree}
    free = [each for each in assembly.bodies if each not in moved]
    return free[0] if len(free) == 1 else None


def _turn(assembly: Assembly) -> None:
    """Turn the joints of *assembly* away from its root, and from the world."""
    for joint in assembly.joints:
        joint.turned = joint.sides[1].body is None
    beside = _beside(assembly)
    reached = {assembly.root} if assembly.root is not None else set()
    pending = list(reached)
    while pending:
        at = pending.pop(0)
        for joint in beside.get(at, ()) if at is not None else ():
            one, other = (side.body for side in joint.sides)
            end = other if one is at else one
            if end is not None and end not in reached:
                joint.turned = one is not at
                reached.add(end)
                pending.append(end)


def _beside(assembly: Assembly) -> dict[StagePrim, list[PhysicsJoint]]:
    """Return the joints of the tree at each body of *assembly*."""
    beside: dict[StagePrim, list[PhysicsJoint]] = {}
    for joint in assembly.joints:
        for side in joint.sides:
            if side.body is not None and not joint.closes_loop:
                beside.setdefault(side.body, []).append(joint)
    return beside


def cut_off(assembly: Assembly) -> dict[PhysicsJoint, StagePrim]:
    """Return the joints left out of the tree that alone lead on to a body, with that body.

    A body with an articulation root of its own is another robot, and not cut off.
    """
    excluded = [each for each in assembly.joints if each.closes_loop]
    if not excluded:
        return {}
    trees = _trees(assembly)
    base, known = trees.find(assembly.base), set(_roots_around(assembly.base))
    rooted = {trees.find(each) for each in assembly.bodies if each.has(ROOT)}
    found = {}
    for joint in excluded:
        one, other = (side.body for side in joint.sides)
        if one is None or other is None:
            continue
        far = other if trees.find(one) is base else one
        tree = trees.find(far)
        apart = base in (trees.find(one), trees.find(other)) and tree not in (base, *rooted)
        if apart and known.issuperset(_roots_around(far)):
            found[joint] = far
    return found


def further_roots(assembly: Assembly) -> dict[StagePrim, StagePrim]:
    """Return the bodies and joints with the root schema whose tree has another root, with that."""
    marked = [(each, each) for each in assembly.bodies if each.has(ROOT)]
    for joint in assembly.joints:
        body = joint.sides[1].body or joint.sides[0].body
        if body is not None and joint.prim.has(ROOT) and not joint.closes_loop:
            marked.append((joint.prim, body))
    if not marked[1:]:
        return {}
    trees = _trees(assembly)
    first: dict[StagePrim, StagePrim] = {}
    found = {}
    for prim, body in sorted(marked, key=lambda each: each[0] is not assembly.root):
        root = first.setdefault(trees.find(body), prim)
        if root is not prim:
            found[prim] = root
    return found


def _trees(assembly: Assembly) -> _Groups:
    """Return the bodies of *assembly* in groups by the joints of its trees."""
    trees = _Groups()
    for joint in assembly.joints:
        one, other = (side.body for side in joint.sides)
        if one is not None and other is not None and not joint.closes_loop:
            trees.above[trees.find(other)] = trees.find(one)
    return trees


def _roots_around(body: StagePrim) -> list[StagePrim]:
    """Return the prims around *body* with the root schema."""
    return [each for each in body.around() if each.has(ROOT)]
