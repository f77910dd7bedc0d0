"""Hover text of terms that no model describes: units, kinds of quantity, classes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinlint.engine.store import Store
from kinlint.navigation.unit_symbols import KIND, SYMBOL, coherent, multiplier, symbol
from kinlint.term_format import TermFormatter
from kinlint.terms import RDF_TYPE, Term, iri, iri_value, is_iri, literal_value
from kinlint.vocabulary import KIN, OWL, QUANTITY_KIND, RDFS, UNIT

SUPERIOR = (iri(f"{RDFS}subClassOf"), iri(f"{RDFS}subPropertyOf"))
COMMENT, DEFINED = iri(f"{RDFS}comment"), iri(f"{RDFS}isDefinedBy")
VALUES, RELEASE = iri(f"{KIN}values"), iri(f"{KIN}inRelease")
MOST = 12


def page(term: Term, store: Store, display: TermFormatter) -> Sequence[str]:
    """Items of a list in Markdown on *term*, which is no node of a model."""
    if not is_iri(term):
        return ()
    name = iri_value(term)
    if name.startswith(UNIT):
        return [f"- {each}" for each in _unit(term, store, display)]
    if name.startswith(QUANTITY_KIND):
        return [f"- {each}" for each in _kind(term, store)]
    return [f"- {each}" for each in _term(term, store, display)]


def sort(term: Term, store: Store) -> str:
    """Return the sort of *term* by how models use it: a word, or nothing."""
    name = iri_value(term) if is_iri(term) else ""
    if name.startswith(UNIT):
        return "unit"
    if name.startswith(QUANTITY_KIND):
        return "kind of quantity"
    if name and any(True for _ in store.subjects(term)):
        return "property"
    return "class" if any(store.subjects(RDF_TYPE, term)) else ""


def _unit(unit: Term, store: Store, display: TermFormatter) -> Iterator[str]:
    if not any(store.values(unit, SYMBOL)):
        yield "a unit that kinlint does not know"
        return
    own = symbol(store, unit) or "1"
    yield f"symbol: {own}"
    factor, si = multiplier(store, unit), coherent(store, unit)
    if factor is not None and si and factor != 1:
        yield f"in SI: 1 {own} = {factor:.12g} {si}"
    kinds = sorted(store.values(unit, KIND))
    yield f"measures: {', '.join(f'`{display.term(each)}`' for each in kinds)}"


def _kind(kind: Term, store: Store) -> Iterator[str]:
    symbols = sorted(filter(None, (symbol(store, each) for each in store.subjects(KIND, kind))))
    if symbols:
        more = f" and {len(symbols) - MOST} more" if len(symbols) > MOST else ""
        yield f"units: {', '.join(symbols[:MOST])}{more}"


def _term(term: Term, store: Store, display: TermFormatter) -> Iterator[str]:
    for comment in store.values(term, COMMENT):
        yield literal_value(comment)
    above = {
        each
        for property_ in SUPERIOR
        for each in store.values(term, property_)
        if is_iri(each) and each != term and not each.startswith((f"<{OWL}", RDF_TYPE[:-5]))
    }
    if above:
        yield f"is also: {', '.join(f'`{display.term(each)}`' for each in sorted(above))}"
    takes = sorted(display.term(each) for each in store.values(term, VALUES))
    if takes:
        yield f"takes: {', '.join(takes)}"
    for context in sorted(store.values(term, DEFINED)):
        if is_iri(context):
            yield f"in context: <{iri_value(context)}>"
    yield f"<{iri_value(term)}>"
