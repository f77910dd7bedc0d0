"""The terms of SHACL and RDFS that the compiler reads, as tokens."""

from __future__ import annotations

from kinlint.terms import RDF_TYPE, Term
from kinlint.vocabulary import KL, OWL, RDFS, SH

TYPE = RDF_TYPE
RULE_CLASS = f"<{KL}Rule>"
SUBCLASS = f"<{RDFS}subClassOf>"
CLASS = f"<{RDFS}Class>"
IMPORTS = f"<{OWL}imports>"


def sh(name: str) -> Term:
    """Return the token of a SHACL term."""
    return f"<{SH}{name}>"
