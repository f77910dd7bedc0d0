"""Dry run of a repair: the change of the graph that its SPARQL Update would make."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from kinlint.edits import Delta
from kinlint.engine.math_functions import MATH
from kinlint.engine.result import Result
from kinlint.engine.store import Store, rank
from kinlint.rule import KNOWN, Repair
from kinlint.terms import RDF_TYPE, Term, Triple, is_blank, is_iri, is_literal


def changed_triples(store: Store, repair: Repair, results: Sequence[Result]) -> Delta:
    """Return what *repair* removes and adds for all of *results*, in the terms of *store*.

    What is removed is there, and what is added is not; both are empty where the update matches
    nothing. New nodes are blank, one for each solution that the update tells from others. Before
    evaluation `$this` and `$focusNode` are the focus node, `$path` and `$predicate` the path,
    `$value` the value, and other variables what the rule found for them.
    """
    removed: dict[Triple, None] = {}
    added: dict[Triple, None] = {}
    used = {term[1:] for triple in (*repair.removed, *repair.added) for term in triple}
    for number, result in enumerate(results):
        rows = _rows(store, repair, _bound(repair, result))
        apart = {tuple(each for each in row.items() if each[0] in used): row for row in rows}
        for index, row in enumerate(apart.values()):
            fresh = f"new{number}x{index}x"
            removed.update(dict.fromkeys(_filled(repair.removed, row, fresh)))
            added.update(dict.fromkeys(_filled(repair.added, row, fresh)))
    return Delta(
        tuple(each for each in removed if each not in added and store.holds(each)),
        tuple(each for each in added if each not in removed and not store.says(each)),
    )


def _rows(store: Store, repair: Repair, bound: Mapping[str, Term]) -> Iterator[dict[str, Term]]:
    """The solutions of the WHERE, evaluated for what is *bound* alone.

    No query can name a blank node, but something that is said of it leads there. What the WHERE
    lists itself must not be given twice.
    """
    apart = {
        name: term for name, term in bound.items() if is_blank(term) or name in repair.assigned
    }
    named = {name: term for name, term in bound.items() if name not in apart}
    known = [
        f"?{name} {' '.join(pair)} ."
        for name, term in apart.items()
        if not is_literal(term) and (pair := _mark(store, term))
    ]
    if named:
        names = " ".join(f"?{name}" for name in named)
        known.append(f"VALUES ({names}) {{ ({' '.join(named.values())}) }}")
    query = repair.query.replace(KNOWN, f"{{ {' '.join(known)} }}")
    return iter(sorted(store.rows(query, apart, MATH), key=rank))


def _mark(store: Store, node: Term) -> tuple[Term, Term] | None:
    """A property and a value that a blank *node* has, as few others do."""
    said = [pair for pair in store.predicate_objects(node) if not is_blank(pair[1])]
    return min(
        said, key=lambda pair: (pair[0] == RDF_TYPE, is_iri(pair[1]), -len(pair[1])), default=None
    )


def _bound(repair: Repair, result: Result) -> Mapping[str, Term]:
    known: dict[str, Term | None] = {
        **result.bindings,
        **dict.fromkeys(("this", "focusNode"), result.focus),
        **dict.fromkeys(("path", "predicate"), result.path),
        "value": result.value,
    }
    return {name: term for name in repair.variables if (term := known.get(name)) is not None}


def _filled(templates: Sequence[Triple], row: Mapping[str, Term], fresh: str) -> Iterator[Triple]:
    """Return *templates* with the values of *row*; those that are no triple then are left out."""
    for template in templates:
        terms = [_term(term, row, fresh) for term in template]
        subject, predicate, value = terms
        if subject and predicate and value and not is_literal(subject) and is_iri(predicate):
            yield subject, predicate, value


def _term(term: Term, row: Mapping[str, Term], fresh: str) -> Term | None:
    if term.startswith("?"):
        return row.get(term[1:])
    return f"_:{fresh}{term[2:]}" if is_blank(term) else term
