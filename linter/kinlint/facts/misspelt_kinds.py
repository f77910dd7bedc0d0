"""Kinds of quantity that nothing describes and that are spelled almost like a known one."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.facts.fact_statements import fact
from kinlint.facts.metamodel_terms import qudt
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.suggestion import distance
from kinlint.terms import Term, Triple, iri_value, is_iri
from kinlint.vocabulary import QUANTITY_KIND


def resemblances(scan: PredicateIndex) -> Iterator[Triple]:
    """Yield each undescribed kind with the only known one that differs by one letter.

    QUDT has kinds that lie two letters apart, such as reluctance and reactance.
    """
    known = scan.instances(qudt("QuantityKind"))
    used = {kind for _, kinds in scan.table(qudt("hasQuantityKind")).items() for kind in kinds}
    strange = [kind for kind in sorted(used - known) if _local(kind)]
    if not strange:
        return
    names = {_plain(kind): kind for kind in sorted(known) if _local(kind)}
    shortened: dict[str, list[str]] = {}
    for name in names:
        for each in _shortened(name):
            shortened.setdefault(each, []).append(name)
    for kind in strange:
        plain = _plain(kind)
        alike = {name for each in _shortened(plain) for name in shortened.get(each, ())}
        near = [names[name] for name in alike if distance(plain, name, 1) <= 1]
        if len(near) == 1:
            yield kind, fact("resembles"), near[0]


def _shortened(name: str) -> Iterator[str]:
    """Yield *name* and all that it is without one letter.

    Names one slip apart share one of these.
    """
    yield name
    for at in range(len(name)):
        yield name[:at] + name[at + 1 :]


def _local(kind: Term) -> str:
    """Return the name of a kind in QUDT's namespace, else nothing."""
    if not is_iri(kind):
        return ""
    space, _, name = iri_value(kind).rpartition("/")
    return name if f"{space}/" == QUANTITY_KIND else ""


def _plain(kind: Term) -> str:
    """Return the letters of a name, without case and hyphens."""
    return "".join(filter(str.isalnum, _local(kind))).casefold()
