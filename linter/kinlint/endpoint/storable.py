"""Statements as any store holds them: blank nodes with names, literals in whatever spelling."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import pyoxigraph as ox

from kinlint.terms import NUMERIC, XSD, Term, Triple, is_blank, literal_datatype, literal_value
from kinlint.vocabulary import KINLINT

NAMED = f"<{KINLINT}.well-known/genid/"
"""Beginning of the names of blank nodes (RDF 1.1 Concepts, section 3.5)."""
BOOLEANS = {"1": "true", "0": "false"}
Key = tuple[Term, Term, str]


def skolemised(term: Term) -> Term:
    """Return *term*; of a blank node, a name."""
    return f"{NAMED}{term[2:]}>" if is_blank(term) else term


def unskolemised(term: Term) -> Term:
    """Return the blank node that *term* is the name of, else *term*."""
    return f"_:{term[len(NAMED) : -1]}" if term.startswith(NAMED) else term


def key(triple: Triple) -> Key:
    """Return what two spellings of one statement share.

    Stores give back numbers, truth values and languages in spellings of their own.
    """
    subject, predicate, value = triple
    if not value.startswith('"') or value.endswith('"'):
        return triple
    if value.endswith(">"):
        kind, written = literal_datatype(value), literal_value(value)
        if kind in NUMERIC or kind.startswith(f"{XSD}"):
            return subject, predicate, f"{_same(written, kind)}^^{kind}"
        return triple
    text, _, language = value.rpartition("@")
    return subject, predicate, f"{text}@{language.lower()}"


def _same(written: str, kind: str) -> str:
    plain = written.strip()
    if kind == f"{XSD}boolean":
        return BOOLEANS.get(plain, plain)
    try:
        return f"{float(plain):.13g}"  # Virtuoso gives back no more digits than 14
    except ValueError:
        return written


def refused(statements: Sequence[Triple]) -> frozenset[Triple]:
    """Return those of *statements* that are no RDF, so that no store takes them."""
    if _is_rdf(statements):
        return frozenset()
    if len(statements) == 1:
        return frozenset(statements)
    half = len(statements) // 2
    return refused(statements[:half]) | refused(statements[half:])


def _is_rdf(statements: Iterable[Triple]) -> bool:
    try:
        text = "".join(map(line, statements)).encode()
        for _ in ox.parse(text, ox.RdfFormat.N_TRIPLES):
            pass
    except (SyntaxError, ValueError):
        return False
    return True


def line(triple: Triple) -> str:
    """Return *triple* as a line of N-Triples without blank nodes."""
    subject, predicate, value = triple
    return f"{skolemised(subject)} {predicate} {skolemised(value)} .\n"
