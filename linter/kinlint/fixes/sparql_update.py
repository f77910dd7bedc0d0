"""A change of the graph as the SPARQL Update that makes it."""

from __future__ import annotations

from collections.abc import Iterable

from kinlint.addresses import abbreviated
from kinlint.edits import Delta
from kinlint.terms import Term, Triple, is_blank


def render_update(delta: Delta) -> str:
    """Return *delta* as one operation.

    SPARQL cannot name blank nodes: those that lose something are variables, found by what they
    lose. Elements of files have IRIs relative to where kinlint runs.
    """
    lost = {term: f"?node{number}" for number, term in enumerate(_blanks(delta.removed), 1)}
    removed, added = (_block(triples, lost) for triples in (delta.removed, delta.added))
    if lost:
        return f"DELETE {{{removed}}}\nINSERT {{{added}}}\nWHERE {{{removed}}}"
    parts = [("DELETE DATA", removed, delta.removed), ("INSERT DATA", added, delta.added)]
    return " ;\n".join(f"{word} {{{block}}}" for word, block, triples in parts if triples)


def _blanks(triples: Iterable[Triple]) -> Iterable[Term]:
    return dict.fromkeys(term for triple in triples for term in triple if is_blank(term))


def _block(triples: Iterable[Triple], names: dict[Term, str]) -> str:
    lines = ("  {} {} {} .\n".format(*(_shown(term, names) for term in each)) for each in triples)
    return "\n" + "".join(lines)


def _shown(term: Term, names: dict[Term, str]) -> str:
    return abbreviated(names.get(term, term))
