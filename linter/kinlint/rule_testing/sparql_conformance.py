"""Holds the SPARQL of a rule to the standard, by the grammar of rdflib.

What runs rules takes more than SPARQL 1.1: LATERAL, for example. Other SHACL engines do not.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path

from pyparsing import ParseException
from rdflib.plugins.sparql import prepareQuery, prepareUpdate

from kinlint.catalogue.repair_file import prefixes
from kinlint.engine.compiler.declared_prefixes import declared
from kinlint.engine.compiler.shacl_terms import sh
from kinlint.engine.compiler.shapes_graph import ShapesGraph, parse
from kinlint.resources import data
from kinlint.rule import Rule
from kinlint.terms import literal_value

PATH = re.compile(r"[$?]PATH\b")
PREPARED = {
    sh("select"): prepareQuery,
    sh("ask"): prepareQuery,
    sh("update"): prepareUpdate,
}


def nonstandard(rule: Rule) -> Iterator[str]:
    """Yield what rdflib has against the queries and updates of *rule*, a sentence each."""
    file = parse(Path(rule.path), rule.name)
    graph = ShapesGraph((parse(data("shapes") / "prefixes.ttl"), file))
    asked = {
        (prepare, _header(prefixes() if name == sh("update") else declared(graph, node)), text)
        for node, name, text in dict.fromkeys(file.triples)
        for prepare in (PREPARED.get(name),)
        if prepare is not None
    }
    for prepare, header, written in sorted(asked, key=lambda each: file.text.find(each[2])):
        yield from _problem(prepare, header, literal_value(written), file.text)


def _header(known: Mapping[str, str]) -> str:
    return "".join(f"PREFIX {prefix}: <{namespace}> " for prefix, namespace in known.items())


def _problem(prepare: Callable[[str], object], header: str, text: str, file: str) -> Iterator[str]:
    """Yield why *prepare* refuses *text*, with the line in *file*, unless it takes it."""
    whole = header + PATH.sub("<urn:path>", text)
    try:
        prepare(whole)
    except ParseException as error:
        near = whole[error.loc :].strip().split("\n")[0].strip()
        place = f"near '{near}'" if near else "at its end"
        start = max(file.find(text), 0) + max(error.loc - len(header), 0)
        line = file.count("\n", 0, start) + 1
        yield f"line {line}: not SPARQL 1.1 {place}"
    except Exception as error:  # noqa: BLE001  rdflib raises bare exceptions
        line = file.count("\n", 0, max(file.find(text), 0)) + 1
        yield f"line {line}: not SPARQL 1.1: {error}"
