"""Terms of the metamodels that numbers are computed from."""

from __future__ import annotations

from collections.abc import Callable

from kinlint.terms import Term, iri
from kinlint.vocabulary import ATTRIBUTE, INHERITED, KIN, METAMODELS, QUDT, REFERENCE

GEOMETRY = f"{METAMODELS}geometry/"
DYNAMICS = f"{METAMODELS}newtonian-rigid-body-dynamics/"


def terms_in(namespace: str) -> Callable[[str], Term]:
    """Return the function from local names in *namespace* to terms."""
    return lambda name: iri(namespace + name)


geom = terms_in(f"{GEOMETRY}structural-entities#")
rel = terms_in(f"{GEOMETRY}spatial-relations#")
coord = terms_in(f"{GEOMETRY}coordinates#")
chain = terms_in(f"{METAMODELS}kinematic-chain/structural-entities#")
body = terms_in(f"{DYNAMICS}structural-entities#")
inertia = terms_in(f"{DYNAMICS}coordinates#")
algorithm = terms_in(f"{METAMODELS}algorithm#")
kin = terms_in(KIN)
qudt = terms_in(QUDT)
reference = terms_in(REFERENCE)
"""Properties from an element to the target of its attribute of that name."""
attribute = terms_in(ATTRIBUTE)
"""Attributes of elements, in any XML format."""
inherited = terms_in(INHERITED)
"""Attributes that elements of MJCF have from a default class."""

OF = rel("of")
WITH_RESPECT_TO = rel("with-respect-to")
COORDINATE_OF = kin("coordinate-of")
AS_SEEN_BY = kin("as-seen-by")
