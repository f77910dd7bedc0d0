"""Vocabulary that facts are computed from, in groups that several facts need."""

from __future__ import annotations

from kinlint.facts import frame_placement, joint_numbers
from kinlint.facts.mechanism import DIRECTED, KINDS
from kinlint.facts.metamodel_terms import (
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
from kinlint.terms import Term

UNITS = (qudt("unit"), qudt("hasUnit"))
ABOUT = (
    *(COORDINATE_OF, AS_SEEN_BY, kin("of-body")),
    *(body("about"), body("reference-point"), rel("reference-point")),
)
"""Properties that tell the body, the frame and the point that numbers are about."""
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

PLACED = (
    *(*ANGLES, *QUATERNION, *map(coord, "xyz"), *map(kin, ("axes-sequence", "Extrinsic"))),
    *(rel("Pose"), OF, WITH_RESPECT_TO, COORDINATE_OF, AS_SEEN_BY, *frame_placement.NEEDED),
)
"""Vocabulary of lifted poses; other models may have numbers on relations, and positions alone."""
DRAWN = (*TREES, *PLACED, *RANGES, *joint_numbers.NEEDED)
SIZES = (*INERTIAS, *SHAPES, *PLACED)
BASES = (*COSINES, *(geom(f"vector-{axis}") for axis in "xyz"), geom("end"))
DATA = (kin("reads"), kin("writes"))
DRIVES = (chain("joints"), *map(kin, ("lower", "upper", "follower")), *BOUNDS)
SIDES = (*INERTIAS, *RANGES, *BOUNDS)
AT_ZERO = (
    *(chain("origin-offset"), chain("common-axis"), rel("lines")),
    *(kin("coincidence-of"), kin("of-joint")),
)
"""Vocabulary of what meets while joints are at zero, besides that of placements and joints."""
MOTIONS = (
    *(*RELATIONS, *PLACED, *TREES, *AT_ZERO, *WELDS, *joint_numbers.NEEDED),
    *(geom("simplices"), geom("Frame"), kin("AxialJoint"), chain("joints")),
    *(kind for kind, _ in KINDS),
)
"""Vocabulary of the motion that joints allow."""
DESCRIPTIONS = (
    *(*INERTIAS, *WELDS, *RANGES, *BOUNDS, *RELATIONS, *PLACED, *TREES, *SHAPES),
    *(*AT_ZERO, *joint_numbers.NEEDED, kin("scale"), geom("simplices")),
    *(kind for kind, _ in KINDS),
)

CONCLUDED: dict[Term, tuple[Term, ...]] = {
    kin("on-body"): (geom("simplices"),),
    kin("joins-body"): (chain("between-attachments"), geom("simplices")),
    kin("of-body"): (body("of-body"), kin("of-body")),
    kin("driven-by"): (kin("actuates"),),
}
"""Properties from which axioms conclude the keys, where these ask for more."""
