"""Names of facts that are computed together, each with the terms that it follows from."""

from __future__ import annotations

from kinlint.facts import compared_units, inputs
from kinlint.facts.metamodel_terms import kin, qudt

QUANTITIES = {
    **dict.fromkeys(("x", "y", "z"), inputs.VECTORS),
    **dict.fromkeys(("alpha", "beta", "gamma"), inputs.ANGLES),
    "mass": (*inputs.MASSES, *inputs.TENSORS),
    "value": (qudt("value"), *inputs.UNITS),
    **{name: (kin(name), *inputs.UNITS) for name in ("lower", "upper", "offset")},
}
RESIDUALS = {
    **dict.fromkeys(("determinant", "orthonormality"), inputs.COSINES),
    "orthogonality": inputs.BASES,
    "norm": inputs.QUATERNION,
    "spread": (*inputs.TURNS, *inputs.VECTORS),
}
MOMENTS = {
    **dict.fromkeys(
        ("least-moment", "middle-moment", "greatest-moment"), (*inputs.TENSORS, *inputs.UNITS)
    ),
    "mass": (*inputs.MASSES, *inputs.TENSORS),
    "body-mass": inputs.INERTIAS,
    **dict.fromkeys(
        (
            *("least-central-moment", "middle-central-moment", "greatest-central-moment"),
            "centre-distance",
        ),
        (*inputs.INERTIAS, inputs.FIRST_MOMENT),
    ),
}
TREES = dict.fromkeys(
    ("root", "root-beside", "claimed-by", "circle", "unresolved", "near-name", "links"),
    inputs.TREES,
)
WELDS = dict.fromkeys(
    ("welded-mass", "rests-on", "moved-by"),
    (*inputs.INERTIAS, *inputs.WELDS, *inputs.TREES, kin("MassProperty")),
)
PROPORTIONS = {
    "gyration": inputs.INERTIAS,
    **dict.fromkeys(("extent", "least-density", "greatest-density"), inputs.SIZES),
}
PLANNING = dict.fromkeys(("comprises", "moves", "between", "joints"), inputs.TREES)
RELATED = {
    **dict.fromkeys(("Agreement", "closed-by"), inputs.RELATIONS),
    **dict.fromkeys(("of", "first", "second", "traced-to", "compared"), ()),
}
WATER = dict.fromkeys(
    ("water-mass", "water-ixx", "water-iyy", "water-izz"),
    (*inputs.SHAPES, *inputs.PLACED, kin("MassProperty")),
)
MOTIONS = dict.fromkeys(("lacks", "closes-loop", "tree-beside"), inputs.MOTIONS)
STEPS = {
    **dict.fromkeys(("step", "in-cycle"), inputs.DATA),
    **dict.fromkeys(("index", "operator"), ()),
}
DRAWN = dict.fromkeys(
    ("unmirrored", "axis-unmirrored", "moves-unlike", "hangs-across"), inputs.DRAWN
)
WHEELS = dict.fromkeys(
    ("disc-cosine", "drive-cosine", "track", "leftward", "rolling-radius", "wheel-base"),
    (*inputs.DRAWN, *inputs.SHAPES),
)
SIBLINGS = dict.fromkeys(
    ("in-place-of", "placed-unlike", "turns-against", "shaped-unlike"),
    (*inputs.DRAWN, *inputs.SHAPES),
)
ODD = ("own-step", "usual-step", "own-size", "usual-size")
MISPLACED = dict.fromkeys(
    ("inertia-of", "other-axes-of", "swapped-sizes-of"), (*inputs.SIZES, *inputs.RELATIONS)
)
SOLID = tuple(f"{each}-{axis}" for each in ("moment", "solid") for axis in "xyz")
NODES = ("member", "derived-from", "size")
ERRORS = ("distance", "angle", "magnitude", "length", "Cycle")
CHANGES = ("entry", "amended")
UNLIKE = {"unit-unlike": (*compared_units.TERMS, *inputs.UNITS)}
ELSEWHERE = ("meant-elsewhere", "called-elsewhere")
IDLE = dict.fromkeys(("idle", "working"), inputs.DRIVES)
