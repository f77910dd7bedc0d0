"""Placement of a change of the graph.

The documents to remove its statements from and to add them to.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from math import isfinite

from kinlint.addresses import document_of
from kinlint.document import FROM, Document
from kinlint.edits import Delta, NotExpressible
from kinlint.engine.lifting import lifts
from kinlint.engine.literal_spelling import normal
from kinlint.engine.provenance import FIRST, Provenance
from kinlint.engine.store import Store
from kinlint.fixes.element_insertion import insertion, is_new
from kinlint.fixes.lowering import lower_delta, signed
from kinlint.light_dataclasses import dataclass, field
from kinlint.terms import (
    NUMERIC,
    XSD,
    Term,
    Triple,
    is_blank,
    is_iri,
    is_literal,
    literal,
    literal_datatype,
    literal_value,
)

DOUBLE = f"{XSD}double"


@dataclass
class Placed:
    """A change of the graph as changes of documents."""

    deltas: Mapping[Term, Delta]
    """The change of each document, by its graph."""
    lifted: Delta
    """The part of the change that is lifted from documents, less statements about cells of lists.
    """


@dataclass
class _Sheet:
    """Changes to make in one document."""

    document: Document
    """The document."""
    removed: dict[Triple, None] = field(default_factory=dict)
    """Statements to remove, in their order."""
    added: dict[Triple, None] = field(default_factory=dict)
    """Statements to add, in their order."""

    def delta(self) -> Delta:
        """The change; numbers have the type that was there.

        Those that only move, or change their sign, have its spelling too.
        """
        said = [value for _, _, value in self.removed if is_literal(value)]
        said += [signed(value, -1) for value in said if _is_number(value)]
        spelled = {normal(value): value for value in reversed(said)}
        types = {(s, p): literal_datatype(o) for s, p, o in self.removed if _is_number(o)}
        added: dict[Triple, None] = {}
        for s, p, o in self.added:
            if not is_literal(o):
                added[s, p, o] = None
                continue
            type_ = types.get((s, p)) if _is_number(o) else None
            value = literal(literal_value(o), type_) if type_ else o
            added[s, p, spelled.get(normal(value)) or _short(value)] = None
        return Delta(tuple(self.removed), tuple(added))


def _short(value: Term) -> Term:
    """Return *value* with an exponent in place of the zeros that a store writes."""
    if literal_datatype(value) != DOUBLE:
        return value
    number = float(literal_value(value))
    if not isfinite(number) or "e" not in repr(number):
        return value
    return literal(f"{number:.16E}".replace("E+", "E"), DOUBLE)


def place_delta(provenance: Provenance, delta: Delta, home: Document) -> Placed:
    """*delta* by document; *home* is where a repair belongs that could go anywhere.

    Raises NotExpressible for what no text says: what was inferred or computed.
    """
    store = provenance.store
    sheets: dict[Term, _Sheet] = {}

    def sheet(document: Document) -> _Sheet:
        return sheets.setdefault(document.graph, _Sheet(document))

    made = _new_of_lifted(delta, home)
    for document, triple in insertion(provenance, made) if made else ():
        sheet(document).added[triple] = None
    told = set(made)
    delta = Delta(delta.removed, tuple(each for each in delta.added if each not in told))
    above = [each for each in delta.removed if not _removed_from_documents(store, each, sheet)]
    if not all(map(store.is_lifted, above)):
        raise NotExpressible("what has to go is written nowhere: it follows from other statements")
    lifted = Delta(tuple(above), tuple(each for each in delta.added if _is_lifted(store, each[0])))
    named = [[each for each in part if is_iri(each[0])] for part in (lifted.removed, lifted.added)]
    for document, old, new in lower_delta(provenance, lifted):
        sheet(document).removed[old] = None
        sheet(document).added[new] = None
    told = set(lifted.added)
    rest = [each for each in delta.added if each not in told]
    for document, triple in _homes(store, rest, list(sheets.values()), home):
        for each in (document, *_besides(triple, document, sheets.values())):
            sheet(each).added[triple] = None
    return Placed(
        {graph: each.delta() for graph, each in sheets.items()}, Delta(*map(tuple, named))
    )


def _new_of_lifted(delta: Delta, home: Document) -> Sequence[Triple]:
    """Return the triples of new nodes that *delta* adds to the lifted model of *home*, if any."""
    known = lifts([home.format]) if home.format.is_tree else ()
    new = [each for each in delta.added if any(map(is_new, each[::2]))]
    return [each for each in new if each[1] in known]


def _is_number(term: Term) -> bool:
    """Tell whether *term* is a literal of one of the numeric types of SPARQL."""
    return is_literal(term) and literal_datatype(term) in NUMERIC


def _removed_from_documents(
    store: Store, triple: Triple, sheet: Callable[[Document], _Sheet]
) -> bool:
    """Tell whether documents assert *triple*, and note it as one to remove from them."""
    written = list(store.written(*triple))
    for document, spelled in written:
        sheet(document).removed[spelled] = None
    return bool(written)


def _besides(triple: Triple, home: Document, sheets: Iterable[_Sheet]) -> list[Document]:
    """The documents other than *home* that lose what *triple* replaces."""
    if any(is_blank(term) for term in triple[::2]):
        return []
    return [
        each.document
        for each in sheets
        if each.document is not home
        and any(triple[:2] == old[:2] or triple[::2] == old[::2] for old in each.removed)
    ]


def _is_lifted(store: Store, node: Term) -> bool:
    if is_blank(node):
        return any(
            map(store.is_lifted, ((node, FIRST, each) for each in store.values(node, FIRST)))
        )
    return is_iri(node) and any(True for _ in store.values(node, FROM))


def _homes(
    store: Store, added: Sequence[Triple], sheets: Sequence[_Sheet], home: Document
) -> Iterable[tuple[Document, Triple]]:
    """The document for each of the *added* triples; new nodes go where they are named."""
    new = {term for triple in added for term in triple[::2] if is_new(term)}
    where: dict[Term, Document] = {}
    left = list(added)
    while left:
        waiting = []
        for triple in left:
            subject, _, value = triple
            known = where.get(subject) if subject in new else _home(store, subject, sheets, home)
            if known is None:
                waiting.append(triple)
                continue
            if value in new:
                where.setdefault(value, known)
            yield known, triple
        if len(waiting) == len(left):
            where.update(dict.fromkeys((triple[0] for triple in waiting), home))
        left = waiting


def _home(store: Store, node: Term, sheets: Sequence[_Sheet], home: Document) -> Document:
    """The document that describes *node*, those that change first, and *home* before others."""
    own = store.documents.get(document_of(node))
    if own is not None:
        return own
    for each in sheets:
        if any(node == triple[0] for triple in each.removed):
            return each.document
    describing = [each for each in store.documents.values() if node in each.map.nodes]
    return home if home in describing or not describing else describing[0]
