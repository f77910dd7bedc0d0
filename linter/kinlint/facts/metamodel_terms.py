"""The terms of the metamodels that numbers are computed from."""

from __future__ import annotations

from kinlint.terms import Term, iri
from kinlint.vocabulary import ATTRIBUTE, KIN, METAMODELS, QUDT, REFERENCE, SDF, SRDF, URDF

GEOMETRY = f"{METAMODELS}geometry/"
DYNAMICS = f"{METAMODELS}newtonian-rigid-body-dynamics/"


def geom(name: str) -> Term:
    """A term of geometry/structural-entities."""
    return iri(f"{GEOMETRY}structural-entities#{name}")


def rel(name: str) -> Term:
    """A term of geometry/spatial-relations."""
    return iri(f"{GEOMETRY}spatial-relations#{name}")


def coord(name: str) -> Term:
    """A term of geometry/coordinates."""
    return iri(f"{GEOMETRY}coordinates#{name}")


def chain(name: str) -> Term:
    """A term of kinematic-chain/structural-entities."""
    return iri(f"{METAMODELS}kinematic-chain/structural-entities#{name}")


def body(name: str) -> Term:
    """A term of newtonian-rigid-body-dynamics/structural-entities."""
    return iri(f"{DYNAMICS}structural-entities#{name}")


def inertia(name: str) -> Term:
    """A term of newtonian-rigid-body-dynamics/coordinates."""
    return iri(f"{DYNAMICS}coordinates#{name}")


def algorithm(name: str) -> Term:
    """A term of algorithm."""
    return iri(f"{METAMODELS}algorithm#{name}")


def kin(name: str) -> Term:
    """A term of kinlint's own."""
    return iri(KIN + name)


def qudt(name: str) -> Term:
    """A term of QUDT's schema."""
    return iri(QUDT + name)


def urdf(name: str) -> Term:
    """An element of URDF."""
    return iri(URDF + name)


def sdf(name: str) -> Term:
    """An element of SDFormat."""
    return iri(SDF + name)


def srdf(name: str) -> Term:
    """An element of SRDF."""
    return iri(SRDF + name)


def reference(name: str) -> Term:
    """What the attribute of this name refers to, where its value is the name of something."""
    return iri(REFERENCE + name)


def attribute(name: str) -> Term:
    """An attribute of an element, in any XML format."""
    return iri(ATTRIBUTE + name)


OF = rel("of")
WITH_RESPECT_TO = rel("with-respect-to")
COORDINATE_OF = kin("coordinate-of")
AS_SEEN_BY = kin("as-seen-by")
