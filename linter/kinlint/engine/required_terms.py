"""Which terms the constraints of a run look at, and which axioms can make those."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Sequence
from itertools import count

from kinlint.engine.axioms import Axiom
from kinlint.engine.constraint import PLAIN, Constraint
from kinlint.formats.records import ELEMENTS
from kinlint.sparql.ast import Triples, walk
from kinlint.sparql.parser import parse
from kinlint.sparql.patterns import patterns
from kinlint.sparql.tokens import is_variable, tokens
from kinlint.terms import RDF_TYPE, Term, Triple, is_iri
from kinlint.vocabulary import ATTRIBUTE, EXTENSION, REFERENCE

TERM = PLAIN
ALTERNATIVES = re.compile(r"<[^<>]*>( ?\| ?<[^<>]*>)*")
FOCUS = "?this"
ANY_CLASS: Term = "a"
"""Among terms: whatever class a node is said to be of, as far as it is there."""

FORMAT_LAYER = tuple(f"<{each}" for each in (*ELEMENTS, ATTRIBUTE, EXTENSION, REFERENCE))

_CLASS = re.compile(rf"(?:\ba|{re.escape(RDF_TYPE)}) \?(?!k_)\w")
HEAD = re.compile(r"SELECT [^{}]*WHERE")
ANY = re.compile(
    r"""(?:[?$]\w+|[]>;"')]|_:\w+) [?$]\w+ (?:[?$<"'[(\d]|[+-]\d|_:|true|false)|! ?(?:\( ?)?[<^]"""
)
"""Signs of a variable or negated property; without one there is neither."""


def terms(constraints: Iterable[Constraint]) -> frozenset[Term] | None:
    """The properties and classes that *constraints* speak of; None if one matches any property.

    What they rule out counts too: it has to be there to be seen. Of targets, all do, but where the
    query itself starts from what makes a node one (`kinlint.engine.compiler.narrow`).
    """
    found: set[Term] = set()
    for each in constraints:
        if each.deferred is not None or _matches_anything(each):
            return None
        chosen = [term for way in each.targets for term in sorted(_named(way))]
        spoken = Counter(TERM.findall(each.select))
        if _CLASS.search(each.select):
            found.add(ANY_CLASS)
        own = spoken - Counter(chosen)
        if not spoken.keys() >= set(chosen):
            found.update(spoken)
        else:
            found.update(own if _implied(each, own) else {*spoken, *chosen})
    return frozenset(found)


def _matches_anything(constraint: Constraint) -> bool:
    """Whether a pattern of *constraint* has any property, and not of elements of a file alone.

    What is said of an element stands in its file. A property that is one of a list is named.
    """
    select = constraint.select
    if not ANY.search(HEAD.sub(" ", select)):
        return False
    parts = walk(parse(tokens(select, {})))
    blocks = (part.tokens for part in parts if isinstance(part, Triples))
    found = [pattern for block in blocks for pattern in patterns(block, count())]
    elements = {
        end
        for each in found
        if any(word.startswith(FORMAT_LAYER) for word in each.path) and "!" not in each.path
        for end in (each.subject, each.object)
    }
    return any(
        ("!" in each.path or (is_variable(each.path[0]) and not _listed(each.path[0], select)))
        and elements.isdisjoint((each.subject, each.object))
        for each in found
    )


def _listed(variable: str, select: str) -> bool:
    """Whether *select* says which terms *variable* may stand for."""
    name = re.escape(variable)
    return bool(re.search(rf"(?<!! ){name} IN \(|\( {name} IN \(", select)) and not re.search(
        rf"! (\( )*{name} IN \(", select
    )


def _implied(constraint: Constraint, own: Counter[Term]) -> bool:
    """Whether what violates *constraint* is a target by what it matches, whatever else is one.

    *own* are the terms that it matches itself, beside its targets.
    """
    ways = {(way[1], way[0] == FOCUS) for way in constraint.targets if not is_iri(way[2])}
    return any(
        FOCUS in (subject, value)
        and ALTERNATIVES.fullmatch(predicate)
        and all(
            step in own and (step, subject == FOCUS) in ways for step in TERM.findall(predicate)
        )
        for subject, predicate, value in constraint.premises
    )


def _named(pattern: Triple) -> set[Term]:
    """The classes in *pattern*, or its properties, those in a path included."""
    _, predicate, value = pattern
    named = set(TERM.findall(predicate))
    return named | {value} if is_iri(value) else named


def relevant(axioms: Sequence[Axiom], wanted: frozenset[Term]) -> tuple[Axiom, ...]:
    """Those of *axioms* from which a statement with one of the *wanted* terms may follow."""
    needed = behind(axioms, wanted)
    return tuple(axiom for axiom in axioms if _head(axiom) in needed)


def behind(axioms: Sequence[Axiom], wanted: Iterable[Term]) -> frozenset[Term]:
    """The *wanted* terms, and those from which they follow by *axioms*."""
    bodies: dict[Term, set[Term]] = {}
    for axiom in axioms:
        body = bodies.setdefault(_head(axiom), set())
        body.update(term for pattern in axiom.body for term in _key(pattern))
    needed, waiting = set(wanted), list(wanted)
    while waiting:
        more = bodies.get(waiting.pop(), set()) - needed
        needed |= more
        waiting += more
    return frozenset(needed)


def made(axioms: Iterable[Axiom]) -> frozenset[Term]:
    """The properties and classes of what *axioms* conclude."""
    return frozenset(map(_head, axioms))


def _head(axiom: Axiom) -> Term:
    _, predicate, value = axiom.head
    return value if predicate == RDF_TYPE else predicate


def _key(pattern: Triple) -> tuple[Term, ...]:
    _, predicate, value = pattern
    return (value,) if predicate == RDF_TYPE else (predicate,)
