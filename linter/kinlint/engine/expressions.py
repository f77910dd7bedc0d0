"""Class expressions of OWL 2 RL as conditions that can be matched and conclusions to draw."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import count
from typing import NamedTuple

from kinlint.engine.axioms import Axiom, Pattern, name
from kinlint.engine.ontology_index import Schema
from kinlint.term_format import article
from kinlint.terms import RDF_TYPE, Term, is_iri
from kinlint.vocabulary import OWL

THING = f"<{OWL}Thing>"
NOTHING = f"<{OWL}Nothing>"


class Condition(NamedTuple):
    """Patterns that hold of a member of a class, and the same in words after "whatever"."""

    body: tuple[Pattern, ...]
    """Patterns that hold of a member."""
    words: str
    """The same in words."""


class Expressions:
    """The class expressions of a schema."""

    def __init__(self, schema: Schema) -> None:
        self.schema = schema

    def implication(self, part: Term, whole: Term) -> Iterator[Axiom]:
        """Yield the axioms by which every *part* is a *whole*."""
        for condition in self.conditions(part, "?x", count(1)):
            if is_iri(part):
                yield from self.conclusions(whole, "?x", condition.body, f"every {name(part)}")
            else:
                subject = f"whatever {condition.words}"
                yield from self.conclusions(whole, "?x", condition.body, subject)

    def definition(self, defined: Term) -> Iterator[Axiom]:
        """Yield the axioms of *defined*, a name for the class expression that it has itself."""
        member = (("?x", RDF_TYPE, defined),)
        yield from self._drawn(defined, "?x", member, f"every {name(defined)}")
        for condition in self._met(defined, "?x", count(1)):
            yield from self.conclusions(
                defined, "?x", condition.body, f"whatever {condition.words}"
            )

    def conditions(self, kind: Term, of: Term, fresh: Iterator[int]) -> Iterator[Condition]:
        """Yield the alternative ways in which *of* is recognised as a member of *kind*."""
        if is_iri(kind):
            if kind not in (THING, NOTHING) and not self.schema.is_datatype(kind):
                yield Condition(((of, RDF_TYPE, kind),), f"is {article(name(kind))}")
        else:
            yield from self._met(kind, of, fresh)

    def _met(self, kind: Term, of: Term, fresh: Iterator[int]) -> Iterator[Condition]:
        """Yield the conditions of the expression that the node *kind* bears."""
        for items in self._get(kind, "unionOf"):
            for member in self.schema.list(items):
                yield from self.conditions(member, of, fresh)
        for items in self._get(kind, "intersectionOf"):
            found = [Condition((), "")]
            for member in self.schema.list(items):
                options = list(self.conditions(member, of, fresh))
                found = [_both(left, right) for left in found for right in options]
            yield from (each for each in found if each.body)
        for relation in self._get(kind, "onProperty"):
            yield from self._restricted(kind, relation, of, fresh)

    def _restricted(
        self, kind: Term, relation: Term, of: Term, fresh: Iterator[int]
    ) -> Iterator[Condition]:
        """Yield the conditions of the restriction *kind* of *relation*."""
        said = self.schema.phrase(relation)
        for value in self._get(kind, "hasValue"):
            yield Condition((self.schema.arc(relation, of, value),), f"has {name(value)} as {said}")
        for filler in self._get(kind, "someValuesFrom"):
            other = f"?v{next(fresh)}"
            arc = self.schema.arc(relation, of, other)
            if filler == THING:
                yield Condition((arc,), f"has {said}")
                continue
            for inner in self.conditions(filler, other, fresh):
                member = inner.words.removeprefix("is ")
                if member == inner.words or " and " in member:
                    member = f"something that {inner.words}"
                yield Condition((arc, *inner.body), f"has {member} as {said}")

    def conclusions(
        self, kind: Term, of: Term, body: tuple[Pattern, ...], subject: str
    ) -> Iterator[Axiom]:
        """Yield the axioms by which *of* is a member of *kind* whenever *body* holds."""
        if not is_iri(kind):
            yield from self._drawn(kind, of, body, subject)
        elif kind == NOTHING:
            yield Axiom(f"{subject} cannot be", body, (of, RDF_TYPE, kind))
        elif kind != THING and not self.schema.is_datatype(kind):
            yield Axiom(f"{subject} is {article(name(kind))}", body, (of, RDF_TYPE, kind))

    def _drawn(
        self, kind: Term, of: Term, body: tuple[Pattern, ...], subject: str
    ) -> Iterator[Axiom]:
        """Yield the conclusions from the expression that the node *kind* bears."""
        for items in self._get(kind, "intersectionOf"):
            for member in self.schema.list(items):
                yield from self.conclusions(member, of, body, subject)
        for relation in self._get(kind, "onProperty"):
            said = self.schema.phrase(relation)
            for value in self._get(kind, "hasValue"):
                arc = self.schema.arc(relation, of, value)
                yield Axiom(f"{subject} has {name(value)} as {said}", body, arc)
            for filler in self._get(kind, "allValuesFrom"):
                other = f"?w{len(body)}"
                arcs = (*body, self.schema.arc(relation, of, other))
                inner = f"whatever {_one(subject)} has as {said}"
                yield from self.conclusions(filler, other, arcs, inner)

    def _get(self, kind: Term, keyword: str) -> list[Term]:
        return self.schema.objects(kind, f"<{OWL}{keyword}>")


def _one(subject: str) -> str:
    """Return the subject of a sentence about all as one of them: `every Joint` as `a Joint`."""
    if subject.startswith("every "):
        return article(subject.removeprefix("every "))
    return subject.replace("whatever", "something that", 1)


def _both(left: Condition, right: Condition) -> Condition:
    words = f"{left.words} and {right.words}" if left.words else right.words
    return Condition((*left.body, *right.body), words)
