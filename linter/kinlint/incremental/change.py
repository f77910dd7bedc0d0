"""Changes of the graphs of a store, with the terms by which queries may depend on them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from typing import TypeAlias

import pyoxigraph as ox

from kinlint.engine.compiler.shacl_terms import SUBCLASS
from kinlint.engine.store import Store
from kinlint.light_dataclasses import dataclass, field
from kinlint.terms import RDF_TYPE, Term, Triple, iri_value

Kind: TypeAlias = ox.NamedNode | ox.BlankNode | ox.Literal | ox.Triple
TYPE = ox.NamedNode(iri_value(RDF_TYPE))


def to_quads(triples: Iterable[Triple], name: Term) -> list[ox.Quad]:
    """Return *triples* in the graph *name*, less those that no RDF store accepts."""
    lines = [f"{s} {p} {o} {name} .\n" for s, p, o in triples]
    return list(_parsed(lines)) if lines else []


def _parsed(lines: list[str]) -> Iterator[ox.Quad]:
    try:
        text = "".join(lines).encode()
        yield from list(ox.parse(text, ox.RdfFormat.N_QUADS, lenient=True))
    except (SyntaxError, UnicodeEncodeError, MemoryError):
        if len(lines) > 1:
            half = len(lines) // 2
            yield from _parsed(lines[:half])
            yield from _parsed(lines[half:])


@dataclass
class Changes:
    """The changes of a store since its model was last analysed."""

    store: Store
    """Store of the model."""
    removed: list[ox.Quad] = field(default_factory=list)
    """Quads that are gone."""
    added: list[ox.Quad] = field(default_factory=list)
    """Quads that are new."""
    properties: set[Term] = field(default_factory=set)
    """The properties of the triples that changed."""
    classes: set[Term] = field(default_factory=set)
    """The classes of the types that changed, and those above them."""
    rewritten: bool = False
    """True if a file makes other statements, or makes them in another order."""
    _above: dict[Kind, frozenset[Term]] = field(default_factory=dict)

    def __bool__(self) -> bool:
        return bool(self.removed or self.added)

    def apply(self, removed: Iterable[ox.Quad], added: Iterable[ox.Quad]) -> Changes:
        """Remove and add to the store what it has and has not; return what that changed."""
        store = self.store.oxigraph
        gone = [quad for quad in dict.fromkeys(removed) if quad in store]
        for quad in gone:
            store.remove(quad)
        come = [quad for quad in dict.fromkeys(added) if quad not in store]
        store.extend(come)
        both = set(gone).intersection(come)
        made = Changes(self.store)
        made.removed = [quad for quad in gone if quad not in both]
        made.added = [quad for quad in come if quad not in both]
        made.update_names()
        self.removed += made.removed
        self.added += made.added
        self.properties |= made.properties
        self.classes |= made.classes
        return made

    @contextmanager
    def undone(self, name: Term) -> Iterator[None]:
        """Put the graph *name* of the store back to what it was before the changes, for a while."""
        store, graph = self.store.oxigraph, ox.NamedNode(iri_value(name))
        turns = Counter(quad for quad in self.added if quad.graph_name == graph)
        turns.subtract(quad for quad in self.removed if quad.graph_name == graph)
        came = [quad for quad, number in turns.items() if number > 0]
        went = [quad for quad, number in turns.items() if number < 0]
        for quad in came:
            store.remove(quad)
        store.extend(went)
        try:
            yield
        finally:
            for quad in went:
                store.remove(quad)
            store.extend(came)

    def update_names(self) -> None:
        """Note the properties, and the classes with all that those are subclasses of."""
        changed = [*self.removed, *self.added]
        self.properties = {str(quad.predicate) for quad in changed if quad.predicate != TYPE}
        kinds = {quad.object for quad in changed if quad.predicate == TYPE}
        self.classes = set().union(*map(self.superclasses, kinds))

    def superclasses(self, kind: Kind) -> frozenset[Term]:
        """Return the class *kind* and all that it is a subclass of."""
        if kind not in self._above:
            found, waiting = {kind}, [kind]
            while waiting:
                wider = set(self._wider(waiting.pop())) - found
                found |= wider
                waiting += wider
            self._above[kind] = frozenset(map(str, found))
        return self._above[kind]

    def _wider(self, kind: Kind) -> list[Kind]:
        if isinstance(kind, ox.Literal):
            return []
        property_ = ox.NamedNode(iri_value(SUBCLASS))
        found = self.store.oxigraph.quads_for_pattern(kind, property_, None, None)
        return [quad.object for quad in found]
