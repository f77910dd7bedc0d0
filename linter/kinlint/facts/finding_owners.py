"""Links and joints that findings are about, which pictures mark."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from itertools import islice

import pyoxigraph as ox

from kinlint.addresses import enclosing, is_address, is_within, lifted
from kinlint.engine.store import Store, statement, token
from kinlint.facts.connected_components import JOINTS
from kinlint.facts.mechanism import ATTACHMENTS
from kinlint.finding import Finding
from kinlint.terms import RDF_TYPE, Term, is_literal
from kinlint.vocabulary import FACT, KIN, KL, METAMODELS, REFERENCE, RULE, SRC

REACH, MOST = 4, 400
"""Most statements between an entity and its owner, and most nodes that are visited on the way."""
SHARED = tuple(
    f"<{each}"
    for each in (
        *(METAMODELS, KIN, KL, SRC, FACT, RULE),
        *("http://qudt.org/", "http://www.w3.org/"),
    )
)
"""Beginnings of the terms of vocabularies, which belong to no part of a robot."""
SPREADING = frozenset({ATTACHMENTS[1:-1], JOINTS[1:-1]})
"""Properties that lead from one part of a robot to another."""


class FindingOwners:
    """Parts of all robots, and the paths to them from what findings are about."""

    def __init__(self, store: Store, parts: Collection[Term], joints: Collection[Term]) -> None:
        self.store = store
        self.parts = parts
        self.joints = joints

    def owners(self, findings: Iterable[Finding]) -> Mapping[Term, Term]:
        """Return the part that each entity of *findings*, and of their members, belongs to."""
        told = (one for finding in findings for one in (finding, *finding.members))
        focuses = dict.fromkeys(finding.focus for finding in told)
        found = {focus: self._owner(focus) for focus in focuses}
        return {focus: part for focus, part in found.items() if part is not None}

    def _owner(self, focus: Term) -> Term | None:
        if not is_address(focus):
            return self._nearest(focus)
        return self._above(focus) or next(
            (part for target in self._named(focus) if (part := self._above(target))), None
        )

    def _above(self, node: Term) -> Term | None:
        """Return the part that *node*, in a file of elements, lies in, by its address."""
        return next((each for each in enclosing(lifted(node)) if each in self.parts), None)

    def _named(self, element: Term) -> Iterator[Term]:
        """Yield what an element, or one right below it, refers to by name."""
        for level in range(2):
            below = [element] if not level else list(self._inside(element))
            for each in below:
                node = statement((each, RDF_TYPE, each)).subject
                for quad in self.store.oxigraph.quads_for_pattern(node, None, None, None):
                    if quad.predicate.value.startswith(REFERENCE):
                        yield token(quad.object)

    def _inside(self, element: Term) -> Iterator[Term]:
        values = (value for _, value in self.store.predicate_objects(element))
        return islice((value for value in values if is_within(value, element)), MOST)

    def _nearest(self, focus: Term) -> Term | None:
        """Return the part that the fewest statements lead to, either way.

        A link rather than a joint.
        """
        seen, ring = {focus}, [focus]
        for _ in range(REACH):
            met = [node for node in ring if node in self.parts]
            if met:
                return min(met, key=lambda node: (node in self.joints, node))
            around = (each for node in ring for each in self._around(node))
            ring = []
            for node in islice(around, MOST):
                if node not in seen:
                    seen.add(node)
                    ring.append(node)
        return None

    def _around(self, node: Term) -> Iterator[Term]:
        if is_literal(node):
            return
        term = statement((node, RDF_TYPE, node)).subject
        store = self.store.oxigraph
        for quad in islice(store.quads_for_pattern(term, None, None, None), MOST):
            near = token(quad.object)
            if not is_literal(near) and not _shared(near) and _near(quad.predicate):
                yield near
        for quad in islice(store.quads_for_pattern(None, None, term, None), MOST):
            near = token(quad.subject)
            if not _shared(near) and _near(quad.predicate):
                yield near


def _shared(node: Term) -> bool:
    """Tell whether *node* is a term of a vocabulary or an address, which belong to no part."""
    return node.startswith(SHARED) or is_address(node)


def _near(predicate: ox.NamedNode) -> bool:
    return predicate.value not in SPREADING and not predicate.value.startswith(FACT)
