"""Connected components of kinematic chains (paper, section II-C: a chain is a connected graph)."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Mapping, Sequence
from itertools import count

from kinlint.facts.fact_statements import DERIVED_FROM, MEMBER, fact, fact_node, integer
from kinlint.facts.mechanism import ATTACHMENTS, ON_BODY
from kinlint.facts.metamodel_terms import chain
from kinlint.facts.predicate_index import Place, PredicateIndex
from kinlint.facts.spanning_forest import DisjointSets
from kinlint.terms import Term, Triple

JOINTS = chain("joints")


def components(scan: PredicateIndex) -> Iterator[Triple]:
    """Yield the components of each chain, or a joint because of which they cannot be told."""
    numbers = count(1)
    for chain_, joints in sorted(scan.table(JOINTS).items()):
        joined = {joint: joined_by(scan, joint) for joint in sorted(joints)}
        loose = next((joint for joint, bodies in joined.items() if not bodies), None)
        if loose is not None:
            yield chain_, fact("undecided"), loose
            continue
        places = _listed(scan, chain_, joints)
        for piece in _pieces(joined):
            node = fact_node("component", next(numbers))
            yield chain_, fact("component"), node
            yield node, DERIVED_FROM, chain_
            yield node, fact("first"), min(piece, key=lambda joint: places[joint])
            yield node, fact("size"), integer(len(piece))
            bodies = (body for joint in piece for body in joined[joint])
            for member in dict.fromkeys((*piece, *bodies)):
                yield node, MEMBER, member


def joined_by(scan: PredicateIndex, joint: Term) -> tuple[Term, ...]:
    """Return the bodies that *joint* joins; none if fewer than two are known."""
    bodies = scan.table(ON_BODY)
    ends = scan.table(ATTACHMENTS).values(joint)
    if not ends or any(end not in bodies for end in ends):
        return ()
    joined = tuple(dict.fromkeys(body for end in ends for body in bodies.values(end)))
    return joined if len(joined) > 1 else ()


def _pieces(joined: Mapping[Term, Sequence[Term]]) -> list[list[Term]]:
    """Return the joints of *joined* in groups, each connected by the bodies it reaches."""
    roots = DisjointSets()
    for joint, bodies in joined.items():
        for body in bodies:
            roots.join(joint, body)
    pieces: dict[Term, list[Term]] = {}
    for joint in sorted(joined):
        pieces.setdefault(roots.representative(joint), []).append(joint)
    return list(pieces.values())


def _listed(scan: PredicateIndex, chain_: Term, joints: Sequence[Term]) -> Mapping[Term, Place]:
    """Return the place at which *chain_* lists each of its joints; unlisted ones come last."""
    places = {joint: (sys.maxsize, 0, joint) for joint in joints}
    for index, document in enumerate(scan.documents):
        if chain_ in document.map.nodes:
            for joint in joints:
                span = document.map.triples.get((chain_, JOINTS, joint))
                if span is not None:
                    places[joint] = min(places[joint], (index, span.start, joint))
    return places
