"""The facts that a rule asks for, and where its file does so."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from kinlint.engine.compiler.shacl_terms import sh
from kinlint.engine.compiler.shapes_graph import ShapesFile
from kinlint.facts.computation import computed, computed_by
from kinlint.sparql.tokens import prologue, split
from kinlint.suggestion import did_you_mean
from kinlint.terms import Term, literal_value
from kinlint.vocabulary import FACT

QUERIES = frozenset({sh("select"), sh("ask"), sh("update")})
SPACE = f"<{FACT}"


class AskedFact(NamedTuple):
    """A fact that a rule file names."""

    name: str
    """Name of the fact, without its prefix."""
    line: int
    """Line in the rule file, counted from one."""
    for_repairs: bool
    """The fact stands in a repair, for which more facts are computed."""


def asked_facts(file: ShapesFile, prefixes: Mapping[str, str]) -> Iterator[AskedFact]:
    """Yield the facts that the shapes and queries of *file* name, in the order of its triples.

    *prefixes* are those that its queries may use besides their own.
    """
    for _, predicate, value in file.triples:
        if predicate in QUERIES:
            text = literal_value(value)
            start = max(file.text.find(text), 0)
            for name, offset in _named(text, prefixes):
                line = file.text.count("\n", 0, start + offset) + 1
                yield AskedFact(name, line, predicate == sh("update"))
        else:
            for term in (predicate, value):
                if term.startswith(SPACE):
                    name = _name(term)
                    at = max(file.text.find(f":{name}"), file.text.find(f"#{name}>"), 0)
                    yield AskedFact(name, file.text.count("\n", 0, at) + 1, for_repairs=False)


def uncomputed(file: ShapesFile, prefixes: Mapping[str, str]) -> Iterator[str]:
    """Yield the facts that *file* asks for and nothing computes, a sentence each."""
    for name, line, for_repairs in dict.fromkeys(asked_facts(file, prefixes)):
        known = computed(for_repairs=for_repairs)
        if name in known:
            continue
        if name in computed(for_repairs=True):
            yield f"line {line}: fact:{name} is computed for repairs only"
        else:
            yield f"line {line}: nothing computes fact:{name}{did_you_mean(name, known)}"


def modules(file: ShapesFile, prefixes: Mapping[str, str]) -> tuple[tuple[str, str], ...]:
    """Return the facts that *file* asks for, each with the module that computes it."""
    asked = {each.name for each in asked_facts(file, prefixes)}
    found = ((name, computed_by(name, for_repairs=True)) for name in sorted(asked))
    return tuple((name, f"kinlint.facts.{module}") for name, module in found if module)


def _named(text: str, prefixes: Mapping[str, str]) -> Iterator[tuple[str, int]]:
    """Yield the facts that the query *text* names, with their offsets."""
    known = {**prefixes, **prologue(text)}
    for kind, token, start in split(text):
        prefix, _, local = token.partition(":")
        if kind == "name" and known.get(prefix) == FACT and local:
            yield local, start
        elif kind == "iri" and token.startswith(SPACE) and token != f"{SPACE}>":
            yield _name(token), start


def _name(term: Term) -> str:
    return term.removeprefix(SPACE)[:-1]
