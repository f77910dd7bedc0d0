"""Parse and unfold the lifting queries of `shapes/lifting`, to JSON that a catalogue keeps."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

from kinlint import resources
from kinlint.contexts.model_prefixes import model_prefixes
from kinlint.engine.construct_template import Made, made_by, trimmed, variables_of
from kinlint.engine.unfolding import is_reading, unfolded
from kinlint.errors import RuleInvalid
from kinlint.formats.records import ELEMENTS
from kinlint.sparql.ast import Construct, Group
from kinlint.sparql.ast_json import to_json
from kinlint.sparql.parser import parse_construct
from kinlint.sparql.tokens import NotSparql
from kinlint.sparql.variables import words
from kinlint.terms import Term
from kinlint.vocabulary import ATTRIBUTE, EXTENSION, INTERMEDIATE, QUANTITY_KIND, SRC, UNIT

SHARED = "shared"
"""The directory of the queries that make the composable model of what readings make."""
READ = (*ELEMENTS, ATTRIBUTE, EXTENSION, SRC)
"""The namespaces that queries match; a name of another one below the template is chosen for it."""
_IRI = re.compile(r"<[^<>]+>")


def compile_queries(form: str) -> list[Any]:
    """Return the queries for the format *form*, by name, as `Lifting.from_json` takes them.

    In place of a reading come the shared queries that make something of its records. Raises
    `RuleInvalid` for a query that cannot be parsed or unfolded.
    """
    return [
        [name, made, sorted(_terms(made, group)), to_json(group)]
        for file in _files(form)
        for name, made, group in _unfolded(file)
    ]


def _unfolded(file: Path) -> Iterator[tuple[str, tuple[Made, ...], Group]]:
    """Yield the name, the template and the WHERE of each query that *file* comes to."""
    query = _parsed(file)
    if not is_reading(query):
        yield file.stem, made_by(query.template), query.group
        return
    for shared in _files(SHARED):
        if (whole := unfolded(_parsed(shared), query)) is not None:
            made = made_by(whole.template)
            yield f"{file.stem}/{shared.stem}", made, trimmed(whole.group, variables_of(made))


def _files(directory: str) -> list[Path]:
    return sorted(resources.data("shapes").glob(f"lifting/{directory}/*.rq"))


@cache
def _parsed(file: Path) -> Construct:
    prefixes = {**model_prefixes(), "ir": INTERMEDIATE}
    try:
        return parse_construct(file.read_text(encoding="utf-8"), prefixes)
    except NotSparql as error:
        raise RuleInvalid(f"{file}: {error}") from error


def _terms(made: tuple[Made, ...], group: Group) -> set[Term]:
    """Return the properties and classes that a query states, units and quantity kinds left out."""
    stated = {term for each in made for term in (each.predicate, each.term) if term}
    chosen = {
        each for each in words(group) if _IRI.fullmatch(each) and not each[1:].startswith(READ)
    }
    return {each for each in stated | chosen if not each[1:].startswith((UNIT, QUANTITY_KIND))}
