"""Words for what a consumer made of a feature, from what it made of a robot that has it."""

from __future__ import annotations

import math
import re

HONOURED = "honoured"


def outcome(feature, made, plain):
    """Return what became of *feature*: `honoured`, `refused`, `died`, or the word for the change.

    *made* is the summary of the robot that has it, *plain* that of the robot that has none.
    """
    if "died" in made or made.get("refused", "").startswith("SystemExit"):
        return "died"
    if "refused" in made:
        return "refused"
    told = OUTCOMES.get(feature)
    if told is not None:
        return told(made)
    same = all(made[part] == plain[part] for part in ("links", "joints", "floating"))
    return "ignored" if same else HONOURED


def first(*pairs):
    """Return the word of the first of *pairs* whose condition holds."""
    return next((word for condition, word in pairs if condition), HONOURED)


def elbow(made):
    return made["joints"]["elbow"]


def upper(made):
    return made["links"]["upper"]


def free(made, name, child):
    """What became of a floating joint."""
    one = made["joints"].get(name)
    if one is None:
        return "free body" if made["joints"].get(child, {}).get("freedom") == 6 else "nothing"
    return first((one["freedom"] == 0, "fixed"), (one["freedom"] != 6, "another"))


def planar(made):
    total = sum(
        each["freedom"] for name, each in made["joints"].items() if name.startswith("elbow")
    )
    return first((total == 2, "two"), (total != 3, "fixed"))


def mass(made):
    kilograms = upper(made)["mass"]
    return first((kilograms == 1, "1 kg"), (kilograms != 0, "from shapes"))


def limits(made):
    return elbow(made)["limits"]


def inertia(made):
    """What became of an inertia that no body has; a file's name tells nothing."""
    told = re.search(r"(inertia matrix|central inertia|rotational inertia)", made["told"])
    return "another inertia" if told else HONOURED


def rotation(made):
    turned = upper(made)["place"][:9]
    return HONOURED if abs(turned[0]) < 1e-6 and abs(turned[3] - 1) < 1e-6 else "no rotation"


def coupled(made):
    if "not actuated" in made["told"]:
        return "held"
    return HONOURED if made["joints"]["wrist"]["coupled"] else "free"


def ends(made, expected):
    found = limits(made)
    close = found is not None and all(
        a == b or (None not in {a, b} and abs(a - b) < 1e-6)
        for a, b in zip(found, expected, strict=True)
    )
    words = ((close, HONOURED), (found is None, "unlimited"))
    told = first(*words, (True, "other"))
    if told != "other":
        return told
    near = [None if each is None else round(each, 6) for each in found]
    return {
        (-1, 0): "0",
        (0, 0): "locked",
        (-1, -1): "locked",
        (-1, None): "infinite",
        (-1, 2): "limited",
    }.get(tuple(near), str(near))


def effort(made, expected):
    found = elbow(made)["effort"]
    return first(
        (found == expected, HONOURED),
        (found is None, "unlimited"),
        (found == 0, "0"),
        (found == -expected, "positive"),
    )


def fixed(made):
    if "camera" not in made["links"]:
        return "merged"
    return "frame" if "to_camera" in made.get("frames", ()) else HONOURED


def broken(made):
    numbers = [n for each in made["links"].values() for n in each["place"]]
    return "not a number" if any(map(math.isnan, numbers)) else HONOURED


def inertial(made, expected):
    found = upper(made)["inertia"]
    near = all(abs(a - b) < 1e-6 for a, b in zip(found, expected, strict=True))
    return HONOURED if near else "from shapes"


def shaped(*kinds):
    """Return what tells whether the link has shapes of these *kinds*."""
    return lambda made: first(
        (not upper(made)["kinds"], "nothing"), (upper(made)["kinds"] != [*kinds], "hull")
    )


def moves(freedom, name="elbow"):
    """Return what tells whether the joint *name* has this many degrees of freedom."""
    return lambda made: first((made["joints"].get(name, {}).get("freedom") != freedom, "another"))


def counts(what):
    """Return what tells whether the number of the elbow called *what* counts."""
    return lambda made: HONOURED if elbow(made)[what] else "ignored"


def two_joints(made):
    alone = {"elbow", "second"} <= made["joints"].keys()
    return first((not alone, "one joint"))


def motor(made):
    """What became of a motor; MuJoCo has it beside the joints."""
    return first((elbow(made)["effort"] not in {6, None}, "ignored"))


SIMULATED = {
    "range-without-limited": lambda made: ends(made, (-0.5, 0.5)),
    "mjcf-hinge": moves(1),
    "mjcf-slide": moves(1),
    "mjcf-ball": moves(3),
    "mjcf-free": lambda made: first((not made["floating"], "stands")),
    "mjcf-two-joints": two_joints,
    "mjcf-welded-body": lambda made: "frame" if "upper" in str(made.get("frames")) else HONOURED,
    "mjcf-range": lambda made: ends(made, (-0.5, 0.5)),
    "mjcf-range-in-degrees": lambda made: ends(made, (-1, 1)),
    "mjcf-default-class": lambda made: ends(made, (-0.5, 0.5)),
    "mjcf-damping": counts("damping"),
    "mjcf-friction": counts("friction"),
    "mjcf-inertial": lambda made: inertial(made, (0.03, 0.04, 0.05)),
    "mjcf-turned-inertial": lambda made: inertial(made, (0.04, 0.03, 0.05)),
    "mjcf-mass-by-geoms": lambda made: inertial(made, (2 / 240, 2 / 240, 2 / 600)),
    **{
        f"mjcf-{kind}": shaped(kind)
        for kind in ("box", "cylinder", "sphere", "capsule", "ellipsoid")
    },
    "mjcf-mesh": shaped([1, 1, 1]),
    "mjcf-several-geoms": lambda made: first((upper(made)["shapes"] != 2, "another")),
    "mjcf-motor": motor,
    "mjcf-coupled-joints": lambda made: HONOURED if made["joints"]["wrist"]["coupled"] else "free",
    "mjcf-connect": lambda made: HONOURED if made.get("loops") else "open",
    "mjcf-weld": lambda made: HONOURED if made.get("loops") else "open",
    "mjcf-several-trees": lambda made: first(
        ("swing" not in made["joints"] and not made.get("others"), "the first")
    ),
    **{f"sdf-{kind}-joint": moves(1) for kind in ("revolute", "prismatic", "screw")},
    "sdf-continuous-joint": lambda made: ends(made, ()) if limits(made) else HONOURED,
    "sdf-fixed-joint": moves(0),
    "sdf-ball-joint": moves(3),
    "sdf-universal-joint": moves(2),
    "sdf-joint-to-world": lambda made: first((made["floating"], "moves")),
    "sdf-static-with-joints": moves(0),
    "sdf-position-limits": lambda made: ends(made, (-0.5, 0.5)),
    "sdf-effort-limit": lambda made: effort(made, 6),
    "sdf-velocity-limit": counts("speed"),
    "sdf-damping": counts("damping"),
    "sdf-friction": counts("friction"),
    "sdf-mimic": lambda made: HONOURED if made["joints"]["wrist"]["coupled"] else "free",
    "sdf-inertia": lambda made: inertial(made, (0.03, 0.04, 0.05)),
    "sdf-turned-inertial": lambda made: inertial(made, (0.04, 0.03, 0.05)),
    "sdf-link-without-inertial": lambda made: inertial(made, (1, 1, 1)),
    "sdf-pose-relative-to": lambda made: first(
        (abs(made["links"]["tip"]["place"][11] - 1.5) > 1e-6, "in the model")
    ),
    **{
        f"sdf-{kind}": shaped(kind)
        for kind in ("box", "cylinder", "sphere", "capsule", "ellipsoid")
    },
    "sdf-obj-mesh": shaped([1, 1, 1]),
    "sdf-stl-mesh": shaped([1, 1, 1]),
    "sdf-several-collisions": lambda made: first((upper(made)["shapes"] != 2, "another")),
}
"""The same for features of MJCF and SDF."""

BY_SHAPE = (2 / 240, 2 / 240, 2 / 600)
"""Moments of inertia of the box of the arm in USD, of 2 kg."""
STAGED = {
    **{f"usd-{kind}-joint": moves(1) for kind in ("revolute", "prismatic")},
    "usd-spherical-joint": moves(3),
    "usd-distance-joint": moves(6),
    "usd-generic-joint": moves(2),
    "usd-fixed-joint": moves(0),
    "usd-unlimited-joint": lambda made: "limited" if limits(made) else HONOURED,
    "usd-position-limits": lambda made: ends(made, (-0.5, 0.5)),
    "usd-cone-limit": lambda made: HONOURED if limits(made) else "ignored",
    "usd-joint-to-world": lambda made: first((made["floating"], "moves")),
    "usd-excluded-joint": lambda made: first(("close" not in made["joints"], "open")),
    "usd-closed-loop": lambda made: first(("close" not in made["joints"], "open")),
    "usd-disabled-joint": lambda made: first(("extra" in made["joints"], "closed")),
    "usd-drive": counts("stiffness"),
    "usd-drive-force": lambda made: effort(made, 6),
    "usd-acceleration-drive": lambda made: "force" if elbow(made)["stiffness"] else "ignored",
    "usd-inertia": lambda made: inertial(made, (0.03, 0.04, 0.05)),
    "usd-principal-axes": lambda made: inertial(made, (0.04, 0.03, 0.05)),
    **{
        f"usd-{kind}": lambda made: inertial(made, BY_SHAPE)
        for kind in ("mass-by-density", "mass-alone", "body-without-mass")
    },
    "usd-kinematic-body": lambda made: HONOURED,
    **{f"usd-{kind}": shaped(kind) for kind in ("box", "cylinder", "sphere", "capsule", "cone")},
    "usd-mesh": shaped([1, 1, 1]),
    "usd-convex-hull": lambda made: first(([1, 1, 1] not in upper(made)["kinds"], "nothing")),
    "usd-several-colliders": lambda made: first((upper(made)["shapes"] != 2, "another")),
    **{
        f"usd-mimic-of-{one}": lambda made: (
            HONOURED if made["joints"]["wrist"]["coupled"] else "free"
        )
        for one in ("newton", "physx")
    },
    "usd-other-units": lambda made: first((abs(upper(made)["place"][11] - 1) < 1e-6, "metres")),
    "usd-y-up": lambda made: first((abs(upper(made)["place"][10] + 1) > 1e-6, "on its side")),
}
"""The same for features of USD."""

OUTCOMES = {
    "revolute-joint": lambda made: first((elbow(made)["freedom"] != 1, "fixed")),
    "prismatic-joint": lambda made: first((elbow(made)["freedom"] != 1, "fixed")),
    "position-limits": lambda made: ends(made, (-0.5, 0.5)),
    "effort-limit": lambda made: effort(made, 6),
    "inertia": lambda made: inertial(made, (0.03, 0.04, 0.05)),
    "turned-inertial": lambda made: inertial(made, (0.04, 0.03, 0.05)),
    "box": shaped("box"),
    "cylinder": shaped("cylinder"),
    "sphere": shaped("sphere"),
    "stl-mesh": shaped([1, 1, 1]),
    "obj-mesh": shaped([1, 1, 1]),
    "collada-collision": shaped([1, 1, 1]),
    "scaled-mesh": shaped([0.5, 0.5, 0.5]),
    "mirrored-mesh": shaped([1, -1, 1]),
    "root-not-joined-to-world": lambda made: "moves" if made["floating"] else "stands",
    "root-fixed-to-world": lambda made: "moves" if made["floating"] else HONOURED,
    "root-with-inertia": lambda made: first(
        (made["links"].get("base", {"mass": 0})["mass"] != 2 and made.get("mass") != 6, "no mass")
    ),
    "continuous-joint": lambda made: ends(made, ()) if limits(made) else HONOURED,
    "continuous-joint-with-range": lambda made: "limited" if limits(made) else HONOURED,
    "floating-joint": lambda made: free(made, "elbow", "upper"),
    "nested-floating-joint": lambda made: free(made, "to_ball", "ball"),
    "planar-joint": planar,
    "planar-joint-with-damping": planar,
    "mimic": coupled,
    "mimic-of-unknown-joint": coupled,
    "mimic-of-another-kind": coupled,
    "several-roots": lambda made: (
        HONOURED if "loose" in made["links"] or "base" not in made["links"] else "the first"
    ),
    "several-parents": lambda made: "doubled",
    "repeated-joint-name": lambda made: "nameless" if "" in made["joints"] else "the last",
    "joint-named-like-link": lambda made: HONOURED if "upper" in made["joints"] else "lost",
    "name-with-separator": lambda made: first(("left elbow/1" not in made["joints"], "renamed")),
    "moving-link-without-inertial": mass,
    "bare-moving-link": mass,
    "massless-leaf": lambda made: first((made["links"]["leaf"]["mass"] != 0, "from shapes")),
    "negative-mass": lambda made: first(
        (made.get("mass") != 0 and upper(made)["mass"] != -2, "another inertia")
    ),
    "nan-mass": lambda made: first((not math.isnan(upper(made)["mass"]), "another")),
    "impossible-inertia": inertia,
    "negative-moment": inertia,
    "missing-limit": lambda made: ends(made, (9, 9)),
    "inverted-limit": lambda made: ends(made, (2, -1)),
    "equal-limits": lambda made: ends(made, (0.5, 0.5)),
    "missing-upper-limit": lambda made: ends(made, (9, 9)),
    "infinite-limit": lambda made: ends(made, (-1, None)),
    "zero-effort": lambda made: effort(made, 0),
    "negative-effort": lambda made: effort(made, -5),
    "missing-effort": lambda made: effort(made, 9),
    "velocity-limit": lambda made: HONOURED if elbow(made)["speed"] else "ignored",
    "zero-velocity": lambda made: first((elbow(made)["speed"] is None, "unlimited")),
    "joint-damping": lambda made: HONOURED if elbow(made)["damping"] else "ignored",
    "damping-element": lambda made: HONOURED if elbow(made)["damping"] else "ignored",
    "joint-friction": lambda made: HONOURED if elbow(made)["friction"] else "ignored",
    "short-axis": lambda made: HONOURED,
    "zero-axis": broken,
    "missing-axis": lambda made: "x" if elbow(made)["axis"] == [1, 0, 0] else "another",
    "several-collisions": lambda made: first((upper(made)["shapes"] != 2, "another")),
    "capsule": lambda made: first((upper(made)["shapes"] != 1, "nothing")),
    "undeclared-capsule": lambda made: first((upper(made)["shapes"] != 1, "nothing")),
    "missing-mesh": lambda made: first((upper(made)["shapes"] != 1, "nothing")),
    "negative-size": lambda made: first((upper(made)["shapes"] != 1, "nothing")),
    "zero-size": lambda made: first((upper(made)["shapes"] != 1, "nothing")),
    "undefined-material": lambda made: "ignored" if "Material" in made["told"] else HONOURED,
    "quaternion": rotation,
    "undeclared-quaternion": rotation,
    "repeated-inertial": lambda made: "the first" if upper(made)["mass"] == 2 else "the last",
    "decimal-comma": lambda made: "zero" if upper(made)["place"][11] == 0 else "another",
    "fixed-child": fixed,
    "empty-robot-name": lambda made: HONOURED,
    **SIMULATED,
    **STAGED,
}
"""By feature, the word for what became of it in a robot that was loaded."""
