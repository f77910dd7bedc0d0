"""Cycles of dependencies.

Joints that follow themselves, and groups that are parts of themselves.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from operator import itemgetter

from kinlint.facts.elements_by_tag import elements_by_parent
from kinlint.facts.fact_statements import fact
from kinlint.facts.metamodel_terms import kin, reference
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.facts.strongly_connected import strongly_connected_components
from kinlint.terms import Term, Triple

ADDRESS = itemgetter(slice(1, -1))
"""Key of an IRI without its brackets, by which queries compare."""


def dependency_cycles(scan: PredicateIndex) -> Iterator[Triple]:
    """Yield each joint and each group that depends on itself, with the first one of its cycle."""
    for arcs in (_followed(scan), parts(scan)):
        for piece in strongly_connected_components(arcs):
            first = min(piece, key=ADDRESS)
            if len(piece) > 1 or first in arcs.get(first, ()):
                for node in sorted(piece):
                    yield node, fact("leads-back-to"), first


def _followed(scan: PredicateIndex) -> Mapping[Term, list[Term]]:
    """Return the leaders of each joint."""
    leaders, arcs = scan.table(kin("leader")), dict[Term, list[Term]]()
    for coupling, followers in sorted(scan.table(kin("follower")).items()):
        for each in followers:
            arcs.setdefault(each, []).extend(leaders.values(coupling))
    return arcs


def parts(scan: PredicateIndex) -> Mapping[Term, list[Term]]:
    """Return the subgroups of each planning group."""
    named = scan.table(reference("group"))
    return {
        group: [each for part in inner for each in named.values(part)]
        for group, inner in sorted(elements_by_parent(scan, "group"))
    }
