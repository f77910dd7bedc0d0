"""Format profiles: the symptoms of a format that authors of models in it cannot avoid.

The tables are Turtle files, `shapes/profiles/*.ttl`. They name the elements and attributes by which
a model shows a symptom, and nothing else decides.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator
from functools import cache

from kinlint import resources
from kinlint.document import Document
from kinlint.light_dataclasses import dataclass
from kinlint.terms import Term, iri
from kinlint.vocabulary import KL, RDFS

_COMPONENT = re.compile(r"-1$")


@dataclass(frozen=True, slots=True)
class Symptom:
    """A symptom of an anti-pattern, such as AP1.1, what it is, and which properties show it."""

    number: str
    """Number, such as `AP1.1`."""
    title: str
    """Description in a few words."""
    shown_by: frozenset[Term]
    """Properties that show it."""


@dataclass(frozen=True, slots=True)
class FormatProfile:
    """Symptoms that are inherent in a format."""

    symptoms: tuple[Symptom, ...] = ()
    """The symptoms, in the order of the anti-patterns."""
    passed_over: frozenset[Term] = frozenset()
    """Properties of elements that do not count, with all below them."""


@dataclass(frozen=True, slots=True)
class Shown:
    """A symptom in a document, with how many there are of each element or attribute showing it."""

    symptom: Symptom
    """The symptom."""
    counts: tuple[tuple[str, int], ...]
    """Names of elements and attributes that show it, with their numbers."""


@cache
def profile(form: str) -> FormatProfile:
    """Return the symptoms inherent in the format *form*; none if it has no table."""
    import pyoxigraph as ox  # noqa: PLC0415  a native module

    path = resources.data("shapes") / "profiles" / f"{form}.ttl"
    if not path.is_file():
        return FormatProfile()
    said: dict[str, dict[str, list[str]]] = {}
    for quad in ox.parse(path=path, format=ox.RdfFormat.TURTLE):
        name = quad.predicate.value.removeprefix(KL)
        said.setdefault(quad.subject.value, {}).setdefault(name, []).append(quad.object.value)
    found = [
        Symptom(each["symptom"][0], each[f"{RDFS}label"][0], frozenset(map(iri, each["counts"])))
        for each in said.values()
        if "symptom" in each
    ]
    over = (iri(name) for each in said.values() for name in each.get("passesOver", ()))
    found.sort(key=lambda one: _order(one.number))
    return FormatProfile(tuple(found), frozenset(over))


def _order(number: str) -> tuple[int, ...]:
    return tuple(map(int, number.removeprefix("AP").split(".")))


def shown(document: Document) -> Iterator[Shown]:
    """Yield the inherent symptoms that *document* shows."""
    known = profile(document.format.lifted_as)
    counts = _counts(document, known.passed_over)
    for symptom in known.symptoms:
        each = {_name(term): counts[term] for term in symptom.shown_by if counts[term]}
        if each:
            ordered = sorted(each.items(), key=lambda item: (-item[1], item[0]))
            yield Shown(symptom, tuple(ordered))


def _counts(document: Document, passed_over: frozenset[Term]) -> Counter[Term]:
    """Return how often each property is used, elements before those below them."""
    counts: Counter[Term] = Counter()
    below: set[Term] = set()
    for subject, predicate, value in document.statements:
        if subject in below:
            below.add(value)
            continue
        counts[predicate] += 1
        if predicate in passed_over:
            below.add(value)
    return counts


def _name(term: Term) -> str:
    """Return the tag or the attribute that a property is made of."""
    return _COMPONENT.sub("", term.rpartition("#")[2].rstrip(">"))


def lines(documents: Iterable[Document]) -> Iterator[str]:
    """Yield a line for each symptom of each of *documents*."""
    for document in documents:
        for each in shown(document):
            counted = ", ".join(f"{count} {name}" for name, count in each.counts)
            symptom = each.symptom
            yield f"{document.source.name}: {symptom.number}: {symptom.title}: {counted}"
