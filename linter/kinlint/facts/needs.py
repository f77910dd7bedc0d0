"""What computed properties are computed from: so that asking for one asks for its sources."""

from __future__ import annotations

from collections.abc import Iterable

from kinlint.facts.names import (
    AS_SEEN_BY,
    COORDINATE_OF,
    REFERENCES,
    body,
    chain,
    coord,
    geom,
    inertia,
    kin,
)
from kinlint.terms import Term, iri
from kinlint.vocabulary import FACT

MASSES = (inertia("mass"), body("mass"))
MOMENTS = (inertia("ixx"), inertia("ixy"), body("xx"), *MASSES)
TURNS = (coord("direction-cosine-x"), kin("qx"), kin("alpha"))
PLACES = (coord("x"), *TURNS)
WELDS = (kin("FixedJoint"), chain("between-attachments"), geom("simplices"))
INERTIAS = (*MOMENTS, body("RigidBodyInertia"))
SHAPES = tuple(map(kin, ("GeometryReference", "of-body", "size", "radius", "length", "mesh")))
NEEDS: dict[str, tuple[Term, ...]] = {
    **dict.fromkeys(("least-moment", "middle-moment", "greatest-moment"), MOMENTS),
    **dict.fromkeys(
        ("least-central-moment", "middle-central-moment", "greatest-central-moment"),
        (*MOMENTS, inertia("first-moment-of-mass")),
    ),
    "centre-distance": (inertia("first-moment-of-mass"),),
    "mass": MASSES,
    "body-mass": MASSES,
    **dict.fromkeys(("welded-mass", "rests-on", "moved-by"), (*INERTIAS, *WELDS)),
    "gyration": INERTIAS,
    **dict.fromkeys(
        ("extent", "least-density", "greatest-density", "shared-with", "shapes", "astray"),
        (*INERTIAS, *SHAPES),
    ),
    **dict.fromkeys(
        ("idle", "working"),
        (chain("joints"), *map(kin, ("actuates", "of-actuator", "upper", "follower"))),
    ),
    "drift": (*INERTIAS, *WELDS, chain("Joint"), *map(kin, ("of-joint", "lower", "upper"))),
    "twin": (*INERTIAS, *map(kin, ("of-joint", "of-actuator", "actuates"))),
    **dict.fromkeys(("comprises", "moves", "joints", "between", "resembles"), REFERENCES),
    "lower": (kin("lower"),),
    "upper": (kin("upper"),),
    "offset": (kin("offset"),),
    **dict.fromkeys(("x", "y", "z"), (coord("x"),)),
    **dict.fromkeys(("determinant", "orthonormality", "orthogonality"), (TURNS[0],)),
    "norm": (kin("qx"),),
    "spread": TURNS,
    **dict.fromkeys(("alpha", "beta", "gamma"), (kin("alpha"),)),
    **dict.fromkeys(("distance", "angle", "magnitude", "closed-by"), PLACES),
}
"""The properties that those named are computed from, where they are not of the model as a whole."""

CONCLUDED: dict[Term, tuple[Term, ...]] = {
    kin("on-body"): (geom("simplices"),),
    kin("joins-body"): (chain("between-attachments"), geom("simplices")),
    kin("of-body"): (body("of-body"), kin("of-body")),
    kin("driven-by"): (kin("actuates"),),
}
"""The properties from which axioms conclude those named."""

INFERRED = frozenset(
    {
        COORDINATE_OF,
        AS_SEEN_BY,
        *map(kin, ("on-body", "of-body", "Coordinate", "reads", "writes")),
        *map(kin, ("MassProperty", "GeometryReference")),
    }
)
"""What facts read of what axioms conclude."""


def sources(wanted: Iterable[Term]) -> frozenset[Term]:
    """*wanted* with the properties that what is computed of it is computed from."""
    found = set(wanted)
    for name, terms in NEEDS.items():
        if iri(f"{FACT}{name}") in found:
            found.update(terms)
    for term in CONCLUDED.keys() & found:
        found.update(CONCLUDED[term])
    return frozenset(found)
