"""The properties and classes that the query of a constraint looks at."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from kinlint.engine.constraint import PLAIN, Constraint
from kinlint.engine.required_terms import ANY_CLASS
from kinlint.formats.records import ELEMENTS
from kinlint.sparql.ast import Select
from kinlint.sparql.parser import parse
from kinlint.sparql.patterns import Pattern
from kinlint.sparql.tokens import is_variable, tokens
from kinlint.sparql.variables import triple_patterns, words
from kinlint.terms import RDF_TYPE, Term, Triple, is_iri
from kinlint.vocabulary import ATTRIBUTE, EXTENSION, REFERENCE

FOCUS = "?this"
FORMAT_LAYER = tuple(f"<{each}" for each in (*ELEMENTS, ATTRIBUTE, EXTENSION, REFERENCE))


def query_terms(constraint: Constraint) -> tuple[Term, ...] | None:
    """Return the properties and classes that the query of *constraint* speaks of; None for any.

    What it rules out counts too: it has to be there to be seen. Of targets, all do, but where the
    query itself starts from what makes a node one (`kinlint.engine.compiler.target_narrowing`).
    """
    query = parse(tokens(constraint.select, {}))
    found = triple_patterns(query)
    if _matches_anything(query, found):
        return None
    chosen = [term for way in constraint.targets for term in sorted(_named(way))]
    spoken = Counter(word for word in words(query) if len(word) > 1 and PLAIN.fullmatch(word))
    own = spoken - Counter(chosen)
    spared = spoken.keys() >= set(chosen) and _implied(constraint, own)
    needed = set(own if spared else spoken)
    if any(path[-1] == RDF_TYPE and _is_open(value) for _, path, value in found):
        needed.add(ANY_CLASS)
    return tuple(sorted(needed))


def _is_open(value: str) -> bool:
    """Return whether *value* is a variable of the author's, not one of the compiler's."""
    return is_variable(value) and not value.startswith("?k_")


def _matches_anything(query: Select, found: Sequence[Pattern]) -> bool:
    """Return whether one of the patterns has any property, and not of elements of a file alone.

    What documents state of an element is in its file. A property that is one of a list is named.
    """
    elements = {
        end
        for each in found
        if any(word.startswith(FORMAT_LAYER) for word in each.path) and "!" not in each.path
        for end in (each.subject, each.object)
    }
    spelled = words(query)
    return any(
        ("!" in each.path or (is_variable(each.path[0]) and not _is_listed(each.path[0], spelled)))
        and elements.isdisjoint((each.subject, each.object))
        for each in found
    )


def _is_listed(variable: str, spelled: Sequence[str]) -> bool:
    """Return whether a query, *spelled* in words, names the terms that *variable* may be."""
    negated = set()
    for at in range(len(spelled) - 2):
        if spelled[at] == variable and (spelled[at + 1].upper(), spelled[at + 2]) == ("IN", "("):
            before = at - 1
            while spelled[before] == "(":
                before -= 1
            negated.add(spelled[before] == "!")
    return negated == {False}


def _implied(constraint: Constraint, own: Counter[Term]) -> bool:
    """Return whether what violates *constraint* is a target by what it matches, whatever else is.

    *own* are the terms that it matches itself, beside its targets.
    """
    ways = {(way[1], way[0] == FOCUS) for way in constraint.targets if not is_iri(way[2])}
    return any(
        FOCUS in (subject, value)
        and all(
            step in own and (step, subject == FOCUS) in ways for step in _alternatives(predicate)
        )
        for subject, predicate, value in constraint.premises
    )


def _alternatives(path: str) -> list[str]:
    """Return the IRIs between which *path* chooses; a step that is none is no way to a target."""
    return [step.strip() for step in path.split("|")]


def _named(pattern: Triple) -> set[Term]:
    """Return the classes in *pattern*, or its properties, those in a path included."""
    _, predicate, value = pattern
    named = set(PLAIN.findall(predicate))
    return named | {value} if is_iri(value) else named
