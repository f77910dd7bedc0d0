"""Keeps what follows by axioms in step with what is stated: delete and rederive, then add.

What may have followed from something that is gone is deleted, and what still follows is put
back (Gupta, Mumick and Subrahmanian 1993); what is new is followed up from there.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TypeAlias

import pyoxigraph as ox

from kinlint.engine.axioms import Axiom, is_variable
from kinlint.engine.closure import FRESH
from kinlint.engine.store import ASSERTED_GRAPH, Store, statement
from kinlint.incremental.change import TYPE, Changes
from kinlint.terms import iri_value
from kinlint.vocabulary import INFERRED_GRAPH, LIFTED_GRAPH

Node: TypeAlias = ox.NamedNode | ox.BlankNode | ox.Literal | ox.Triple
Part: TypeAlias = "str | Node"
"""A variable, or a term."""
Pattern: TypeAlias = tuple[Part, Part, Part]
Subject: TypeAlias = ox.NamedNode | ox.BlankNode | ox.Triple
Fact: TypeAlias = tuple[Subject, ox.NamedNode, Node]
Key: TypeAlias = tuple[Node, Node | None]
Bindings: TypeAlias = dict[str, Node]

INFERRED, SCRATCH = (ox.NamedNode(iri_value(name)) for name in (INFERRED_GRAPH, FRESH))
STATED = tuple(ox.NamedNode(iri_value(name)) for name in (ASSERTED_GRAPH, LIFTED_GRAPH))


class Inference:
    """Axioms, ready to be followed from one triple to the next."""

    def __init__(self, store: Store, axioms: Sequence[Axiom]) -> None:
        self.store = store
        self._rules = [(tuple(map(_pattern, each.body)), _pattern(each.head)) for each in axioms]
        self._premises: dict[Key, list[tuple[int, int]]] = {}
        self._heads: dict[Key, list[int]] = {}
        for number, (body, head) in enumerate(self._rules):
            for place, pattern in enumerate(body):
                self._premises.setdefault(_key(pattern), []).append((number, place))
            self._heads.setdefault(_key(head), []).append(number)

    def follow(self, changes: Changes) -> None:
        """Bring the inferred graph in step with *changes*, which are made, and add to them.

        Once it was done, doing it again makes no difference.
        """
        store = self.store.oxigraph
        gone = [quad for quad in changes.removed if quad.graph_name in STATED]
        come = [quad for quad in changes.added if quad.graph_name in STATED and quad in store]
        lost = list(dict.fromkeys(map(_fact, gone)))
        doubtful = self._doubtful(lost)
        again = [_in(INFERRED, fact) for fact in map(_fact, come)]
        changes.apply([*(_in(INFERRED, fact) for fact in doubtful), *again], ())
        new = [fact for fact in (*lost, *doubtful) if self._follows(fact)]
        found = self._state(new, changes)
        waiting = [*map(_fact, come), *found]
        while waiting:
            concluded = dict.fromkeys(each for fact in waiting for each in self._from(fact))
            waiting = self._state(concluded, changes)

    def _state(self, facts: Iterable[Fact], changes: Changes) -> list[Fact]:
        """Infer those of *facts* that nobody states and that were not inferred yet."""
        new = [fact for fact in facts if not self._holds(fact)]
        changes.apply((), [_in(INFERRED, fact) for fact in new])
        return new

    def _doubtful(self, lost: Sequence[Fact]) -> list[Fact]:
        """Return what was inferred and may follow from what is *lost*, put back for this."""
        store = self.store.oxigraph
        store.extend([_in(SCRATCH, fact) for fact in lost])
        found: dict[Fact, None] = {}
        waiting = list(lost)
        while waiting:
            concluded = dict.fromkeys(each for fact in waiting for each in self._from(fact))
            waiting = [
                each for each in concluded if each not in found and _in(INFERRED, each) in store
            ]
            found.update(dict.fromkeys(waiting))
        store.clear_graph(SCRATCH)
        return list(found)

    def _from(self, fact: Fact) -> Iterator[Fact]:
        """Yield what follows from *fact*, together with what else holds."""
        for number, place in self._premises.get(_key(fact), ()):
            body, head = self._rules[number]
            known = _matched(body[place], fact, {})
            if known is None:
                continue
            rest = [pattern for index, pattern in enumerate(body) if index != place]
            for bindings in self._solutions(rest, known):
                subject, predicate, value = (_bound(part, bindings) for part in head)
                if isinstance(subject, ox.Literal | str) or isinstance(value, str):
                    continue
                if isinstance(predicate, ox.NamedNode):
                    yield subject, predicate, value

    def _follows(self, fact: Fact) -> bool:
        """Tell whether *fact* follows from what holds in one step."""
        for number in self._heads.get(_key(fact), ()):
            body, head = self._rules[number]
            known = _matched(head, fact, {})
            if known is not None and next(self._solutions(body, known), None) is not None:
                return True
        return False

    def _solutions(self, patterns: Sequence[Pattern], known: Bindings) -> Iterator[Bindings]:
        if not patterns:
            yield known
            return
        subject, predicate, value = (_bound(part, known) for part in patterns[0])
        if isinstance(subject, ox.Literal) or not isinstance(predicate, ox.NamedNode):
            return
        for quad in self.store.oxigraph.quads_for_pattern(
            None if isinstance(subject, str) else subject,
            predicate,
            None if isinstance(value, str) else value,
            None,
        ):
            bindings = _matched(patterns[0], _fact(quad), known)
            if bindings is not None:
                yield from self._solutions(patterns[1:], bindings)

    def _holds(self, fact: Fact) -> bool:
        found = self.store.oxigraph.quads_for_pattern(fact[0], fact[1], fact[2], None)
        return next(iter(found), None) is not None


def _fact(quad: ox.Quad) -> Fact:
    return quad.subject, quad.predicate, quad.object


def _in(graph: ox.NamedNode, fact: Fact) -> ox.Quad:
    return ox.Quad(fact[0], fact[1], fact[2], graph)


def _pattern(pattern: tuple[str, str, str]) -> Pattern:
    """Return *pattern* with its tokens as terms of the store."""
    subject, predicate, value = pattern
    return _part(subject), _part(predicate), _part(value)


def _part(token: str) -> Part:
    return token if is_variable(token) else statement(("<any:>", "<any:>", token)).object


def _key(pattern: Pattern | Fact) -> Key:
    """Return the property of *pattern*, and the class if it says that something is of one."""
    _, predicate, value = pattern
    assert not isinstance(predicate, str)
    return predicate, value if predicate == TYPE and not isinstance(value, str) else None


def _bound(part: Part, bindings: Bindings) -> Part:
    return bindings.get(part, part) if isinstance(part, str) else part


def _matched(pattern: Pattern, fact: Fact, known: Bindings) -> Bindings | None:
    """Bind the variables of *pattern*, some *known*, so that it gives *fact*; None if none do."""
    bindings = dict(known)
    for part, term in zip(pattern, fact, strict=True):
        if isinstance(part, str):
            if bindings.setdefault(part, term) != term:
                return None
        elif part != term:
            return None
    return bindings
