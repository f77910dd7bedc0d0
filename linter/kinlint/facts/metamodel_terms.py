"""Terms of the metamodels that numbers are computed from."""

from __future__ import annotations

from collections.abc import Callable

from kinlint.terms import Term, iri
from kinlint.vocabulary import ATTRIBUTE, KIN, METAMODELS, QUDT, REFERENCE

GEOMETRY = f"{METAMODELS}geometry/"
DYNAMICS = f"{METAMODELS}newtonian-rigid-body-dynamics/"


def _terms(namespace: str) -> Callable[[str], Term]:
    """Return the function from local names in *namespace* to terms."""
    return lambda name: iri(namespace + name)


geom = _terms(f"{GEOMETRY}structural-entities#")
rel = _terms(f"{GEOMETRY}spatial-relations#")
coord = _terms(f"{GEOMETRY}coordinates#")
chain = _terms(f"{METAMODELS}kinematic-chain/structural-entities#")
body = _terms(f"{DYNAMICS}structural-entities#")
inertia = _terms(f"{DYNAMICS}coordinates#")
algorithm = _terms(f"{METAMODELS}algorithm#")
kin = _terms(KIN)
qudt = _terms(QUDT)
reference = _terms(REFERENCE)
"""Properties from an element to the target of its attribute of that name."""
attribute = _terms(ATTRIBUTE)
"""Attributes of elements, in any XML format."""

OF = rel("of")
WITH_RESPECT_TO = rel("with-respect-to")
COORDINATE_OF = kin("coordinate-of")
AS_SEEN_BY = kin("as-seen-by")
