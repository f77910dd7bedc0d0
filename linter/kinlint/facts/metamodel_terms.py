"""Terms of the metamodels that numbers are computed from."""

from __future__ import annotations

from kinlint.terms import Term, iri
from kinlint.vocabulary import ATTRIBUTE, KIN, METAMODELS, QUDT, REFERENCE, SDF, SRDF, URDF

GEOMETRY = f"{METAMODELS}geometry/"
DYNAMICS = f"{METAMODELS}newtonian-rigid-body-dynamics/"


def geom(name: str) -> Term:
    """Return a term of geometry/structural-entities."""
    return iri(f"{GEOMETRY}structural-entities#{name}")


def rel(name: str) -> Term:
    """Return a term of geometry/spatial-relations."""
    return iri(f"{GEOMETRY}spatial-relations#{name}")


def coord(name: str) -> Term:
    """Return a term of geometry/coordinates."""
    return iri(f"{GEOMETRY}coordinates#{name}")


def chain(name: str) -> Term:
    """Return a term of kinematic-chain/structural-entities."""
    return iri(f"{METAMODELS}kinematic-chain/structural-entities#{name}")


def body(name: str) -> Term:
    """Return a term of newtonian-rigid-body-dynamics/structural-entities."""
    return iri(f"{DYNAMICS}structural-entities#{name}")


def inertia(name: str) -> Term:
    """Return a term of newtonian-rigid-body-dynamics/coordinates."""
    return iri(f"{DYNAMICS}coordinates#{name}")


def algorithm(name: str) -> Term:
    """Return a term of algorithm."""
    return iri(f"{METAMODELS}algorithm#{name}")


def kin(name: str) -> Term:
    """Return a term of kinlint's own."""
    return iri(KIN + name)


def qudt(name: str) -> Term:
    """Return a term of QUDT's schema."""
    return iri(QUDT + name)


def urdf(name: str) -> Term:
    """Return an element of URDF."""
    return iri(URDF + name)


def sdf(name: str) -> Term:
    """Return an element of SDFormat."""
    return iri(SDF + name)


def srdf(name: str) -> Term:
    """Return an element of SRDF."""
    return iri(SRDF + name)


def reference(name: str) -> Term:
    """Return the property from an element to the target of its attribute *name*."""
    return iri(REFERENCE + name)


def attribute(name: str) -> Term:
    """Return an attribute of an element, in any XML format."""
    return iri(ATTRIBUTE + name)


OF = rel("of")
WITH_RESPECT_TO = rel("with-respect-to")
COORDINATE_OF = kin("coordinate-of")
AS_SEEN_BY = kin("as-seen-by")
