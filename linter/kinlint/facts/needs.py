"""What computed properties are computed from: so that asking for one asks for its sources."""

from __future__ import annotations

from collections.abc import Iterable

from kinlint.facts import placement
from kinlint.facts.mechanism import DIRECTED
from kinlint.facts.names import (
    AS_SEEN_BY,
    COORDINATE_OF,
    OF,
    WITH_RESPECT_TO,
    body,
    chain,
    coord,
    geom,
    inertia,
    kin,
    qudt,
    rel,
)
from kinlint.terms import Term, iri
from kinlint.vocabulary import FACT

UNITS = (qudt("unit"), qudt("hasUnit"))
ABOUT = (
    *(COORDINATE_OF, AS_SEEN_BY, kin("of-body")),
    *(body("about"), body("reference-point"), rel("reference-point")),
)
"""Of which body, frame and point numbers are."""
MASSES = (inertia("mass"), body("mass"), *UNITS)
TENSORS = (
    *map(inertia, ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")),
    *map(body, ("xx", "yy", "zz")),
)
INERTIAS = (*TENSORS, *MASSES, *ABOUT)
FIRST_MOMENT = inertia("first-moment-of-mass")
ON_BODY = kin("on-body")
WELDS = (kin("FixedJoint"), chain("between-attachments"), ON_BODY)
TREES = (geom("RigidBody"), chain("Joint"), *DIRECTED)
RANGES = (*map(kin, ("JointPositionLimit", "of-joint", "lower", "upper")), *UNITS)
BOUNDS = (
    *map(kin, ("ActuatorForceLimit", "ActuatorVelocityLimit", "ActuatorAccelerationLimit")),
    *map(kin, ("actuates", "of-actuator")),
)
SHAPES = (
    *map(kin, ("GeometryReference", "CollisionGeometry", "Box", "Sphere", "Cylinder", "Capsule")),
    *map(kin, ("of-body", "size", "radius", "length", "mesh")),
    *UNITS,
)
PLACED = placement.NEEDED
COSINES = tuple(coord(f"direction-cosine-{axis}") for axis in "xyz")
QUATERNION = tuple(kin(f"q{part}") for part in "xyzw")
ANGLES = (*map(kin, ("alpha", "beta", "gamma")), *UNITS)
TURNS = (
    *(*COSINES, *QUATERNION, *ANGLES),
    *map(kin, ("axes-sequence", "Intrinsic", "Extrinsic")),
)
VECTORS = (
    *(coord("x"), coord("y"), coord("z"), COORDINATE_OF, *UNITS),
    *map(coord, ("PositionCoordinate", "PoseCoordinate")),
    *map(rel, ("Position", "Pose")),
)
RELATIONS = (
    *(*TURNS, *VECTORS, OF, WITH_RESPECT_TO, AS_SEEN_BY, kin("Coordinate"), rel("Orientation")),
    *map(geom, ("origin", "rotation-frame")),
)

NEEDS: dict[str, tuple[Term, ...]] = {
    **dict.fromkeys(("least-moment", "middle-moment", "greatest-moment"), TENSORS + UNITS),
    **dict.fromkeys(
        (
            *("least-central-moment", "middle-central-moment", "greatest-central-moment"),
            "centre-distance",
        ),
        (*INERTIAS, FIRST_MOMENT),
    ),
    **dict.fromkeys(("body-mass", "gyration"), INERTIAS),
    **dict.fromkeys(("transfer", "shift"), (*INERTIAS, *PLACED)),
    **dict.fromkeys(("decimal-slip", "sign-slip"), TENSORS + UNITS),
    "solid": (*INERTIAS, *SHAPES, *PLACED),
    **dict.fromkeys(
        ("water-mass", "water-ixx", "water-iyy", "water-izz"),
        (*SHAPES, *PLACED, kin("MassProperty")),
    ),
    "mass": (*MASSES, *TENSORS),
    **dict.fromkeys(
        ("welded-mass", "rests-on", "moved-by"), (*INERTIAS, *WELDS, *TREES, kin("MassProperty"))
    ),
    **dict.fromkeys(
        ("extent", "least-density", "greatest-density", "shared-with", "shapes"),
        (*INERTIAS, *SHAPES, *PLACED),
    ),
    "astray": (*INERTIAS, *SHAPES, *PLACED, geom("RigidBody")),
    **dict.fromkeys(
        ("idle", "working"), (chain("joints"), *map(kin, ("lower", "upper", "follower")), *BOUNDS)
    ),
    "drift": (*MASSES, *ABOUT, *WELDS, *RANGES, *PLACED, *DIRECTED, chain("Joint")),
    **dict.fromkeys(("twin", "unlike-siblings"), (*INERTIAS, *RANGES, *BOUNDS)),
    **dict.fromkeys(("comprises", "moves", "joints", "between"), TREES),
    **dict.fromkeys(
        ("root", "root-beside", "claimed-by", "circle", "unresolved", "near-name", "links"), TREES
    ),
    "leads-back-to": (kin("leader"), kin("follower")),
    **dict.fromkeys(("component", "undecided"), (chain("joints"), *WELDS)),
    **{name: (kin(name), *UNITS) for name in ("lower", "upper", "offset")},
    "value": (qudt("value"), *UNITS),
    **dict.fromkeys(("x", "y", "z"), VECTORS),
    **dict.fromkeys(("alpha", "beta", "gamma"), ANGLES),
    **dict.fromkeys(("determinant", "orthonormality"), COSINES),
    "norm": QUATERNION,
    "orthogonality": (*COSINES, *(geom(f"vector-{axis}") for axis in "xyz"), geom("end")),
    "spread": (*TURNS, *VECTORS),
    **dict.fromkeys(("Agreement", "distance", "angle", "magnitude", "closed-by"), RELATIONS),
    **dict.fromkeys(
        ("step", "in-cycle", "supplied-by", "reordered"), (kin("reads"), kin("writes"))
    ),
}
"""The properties that those named are computed from, beside what is said of elements of files.

What holds of any node, such as that its types exclude each other, is computed of what is there.
"""

CONCLUDED: dict[Term, tuple[Term, ...]] = {
    kin("on-body"): (geom("simplices"),),
    kin("joins-body"): (chain("between-attachments"), geom("simplices")),
    kin("of-body"): (body("of-body"), kin("of-body")),
    kin("driven-by"): (kin("actuates"),),
}
"""The properties from which axioms conclude those named, where these ask for more."""


def sources(wanted: Iterable[Term]) -> frozenset[Term]:
    """*wanted* with the properties that what is computed of it is computed from."""
    found = set(wanted)
    for name, terms in NEEDS.items():
        if iri(f"{FACT}{name}") in found:
            found.update(terms)
    for term in CONCLUDED.keys() & found:
        found.update(CONCLUDED[term])
    return frozenset(found)
