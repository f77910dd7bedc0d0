"""Updates tables that were read from a store, where something changed."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, MutableMapping
from typing import TypeAlias, TypeVar

import pyoxigraph as ox

from kinlint.engine.store import token
from kinlint.facts.predicate_index import Table, number_of
from kinlint.incremental.change import TYPE, Changes
from kinlint.terms import Term

Subject: TypeAlias = ox.NamedNode | ox.BlankNode | ox.Triple
Value = TypeVar("Value")
Values: TypeAlias = Mapping[Term, list[Term]]


def update_index(
    changes: Changes,
    tables: MutableMapping[Term, Table],
    numbers: MutableMapping[Term, dict[Term, float]],
    instances: MutableMapping[Term, frozenset[Term]],
) -> None:
    """Replace those of *tables*, *numbers* and *instances* that *changes* are about.

    What replaces them is what would be read now, in the same order.
    """
    store = changes.store.oxigraph
    touched: dict[ox.NamedNode, dict[Subject, None]] = {}
    for quad in (*changes.removed, *changes.added):
        touched.setdefault(quad.predicate, {})[quad.subject] = None
        if quad.predicate == TYPE and (kind := token(quad.object)) in instances:
            node = frozenset((token(quad.subject),))
            same = store.quads_for_pattern(quad.subject, TYPE, quad.object, None)
            there = next(iter(same), None) is not None
            instances[kind] = instances[kind] | node if there else instances[kind] - node
    for predicate, subjects in touched.items():
        name = token(predicate)
        if name not in tables:
            continue
        found = {
            str(subject): sorted(
                token(quad.object)
                for quad in store.quads_for_pattern(subject, predicate, None, None)
            )
            for subject in subjects
        }
        tables[name] = _table(tables[name], found)
        if name in numbers:
            numbers[name] = _numbers(tables[name], numbers[name], found)


def _table(old: Table, found: Values) -> Table:
    """Return *old* with the values that are *found* of some subjects, sorted by subject."""
    new = Table()
    one, several = dict(old.one), dict(old.several)
    for subject, values in found.items():
        if len(values) == 1:
            one[subject] = values[0]
            several.pop(subject, None)
            continue
        one.pop(subject, None)
        several[subject] = values
        if not values:
            del several[subject]
    new.one, new.several = _sorted(one, old.one), _sorted(several, old.several)
    return new


def _sorted(table: dict[Term, Value], old: Mapping[Term, Value]) -> dict[Term, Value]:
    """Return *table* by subject; it is sorted still unless it has more than the *old* one."""
    if table.keys() <= old.keys():
        return table
    return {subject: table[subject] for subject in sorted(table)}


def _numbers(table: Table, old: Mapping[Term, float], found: Values) -> dict[Term, float]:
    """Return the numbers of *table*, whose subjects other than those *found* have *old* ones."""
    subjects: Iterable[Term] = (*table.one, *table.several)
    numbers = (
        (each, number_of(table.values(each)) if each in found else old.get(each))
        for each in subjects
    )
    return {subject: number for subject, number in numbers if number is not None}
