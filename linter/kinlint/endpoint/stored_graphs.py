"""The named graphs of a store: which there are, which of them make a model, what they state."""

from __future__ import annotations

import re
from collections.abc import Container, Iterable, Iterator, Mapping, Sequence
from itertools import groupby

from kinlint.endpoint.connection import Endpoint, EndpointError
from kinlint.endpoint.storable import unskolemised
from kinlint.errors import UsageError
from kinlint.light_dataclasses import dataclass, replace
from kinlint.terms import (
    RDF_TYPE,
    XSD,
    Term,
    Triple,
    iri,
    iri_value,
    literal,
    literal_datatype,
    literal_value,
)
from kinlint.vocabulary import KINLINT, STORE

FILE, FORMAT, MODEL, COMPANION, REVISION, LOADED, RECORD, SIZE, APART = (
    iri(f"{STORE}{name}")
    for name in (
        *("file", "format", "model", "companion", "revision", "loaded", "record", "size", "apart"),
    )
)
"""Properties of a graph that kinlint loaded: the names of its file and format; the model that it is
a part of, by the name of one graph of it; graphs that are only read along with it; the number and
the time of loading; what RDF loses of the file; how many statements it has, and how many no store
accepts.
"""
SCRATCH = iri(f"{STORE}Scratch")
"""Class of a graph in which a store infers for one run, also of one that a killed run left."""
COUNTER = iri(f"{KINLINT}store")
"""The named graph that holds the number of the newest loading, and nothing else."""
MODIFIED = "<http://purl.org/dc/terms/modified>"
"""Property of other graphs that tells when they changed."""
OWN = tuple(
    f"<{each}>"
    for each in (
        "http://www.openlinksw.com/schemas/virtrdf#",
        "http://localuriqaserver/sparql",
        "http://www.w3.org/ns/ldp#",
        "http://www.w3.org/2002/07/owl#",
        "urn:activitystreams-owl:map",
    )
)
"""Named graphs that Virtuoso makes for itself."""
DIGITS = '(IF(isNumeric(?o), STR(?o), "") AS ?digits)'
"""Numbers as their stores keep them: Virtuoso's results have doubles with six digits."""
IRI = re.compile(r"<[^\x00-\x20<>\"{}|^`\\]+>")
"""Form of an IRI (SPARQL 1.1, rule `IRIREF`)."""
PAGE = 10_000
"""Most solutions of one answer: stores cut off longer ones, some without a word."""


@dataclass(frozen=True, slots=True)
class StoredGraph:
    """A named graph of a store."""

    name: Term
    """The name."""
    model: Term
    """The model that it is a part of, if any; its own name if it was not loaded by kinlint."""
    file: str | None = None
    """The name of its file; None if it was not loaded by kinlint."""
    size: int = 0
    """Number of statements when it was loaded; 0 if unknown."""
    whole: bool = False
    """True if the graph has all that the document states."""
    companion: bool = False
    """True if it is only read along with others."""
    format: str = ""
    """The name of its format, if known."""


def graph_name(said: str, option: str) -> Term:
    """Return the name of a graph that *option* gives. Raises `UsageError` for what is no IRI."""
    name = iri(said)
    if not IRI.fullmatch(name) or ":" not in said:
        raise UsageError(f"{option}: expected an IRI, got '{said}'")
    return name


def models(endpoint: Endpoint, names: Sequence[Term], since: str | None) -> list[list[StoredGraph]]:
    """Return the graphs of *endpoint*, those of one model together, sorted by their files.

    With *names*, the models of these graphs only; *since* a revision, or a time as XML Schema
    writes it, those in which a graph is newer. Raises `UsageError` for a name of no graph.
    """
    known = {each.name: each for each in _loaded(endpoint)}
    beside = dict[Term, dict[Term, None]]()
    for row in pages(endpoint, "?g ?other", f"GRAPH ?g {{ ?g {COMPANION} ?other }}"):
        beside.setdefault(row["g"], {})[row["other"]] = None
    others = _named(endpoint, names, known) if names else _foreign(endpoint, since)
    changed = _changed(endpoint, since)
    every = [each for each in known.values() if each.model]
    every += (StoredGraph(each, each) for each in others if each not in known)
    every.sort(key=lambda each: (each.model, each.file or "", each.name))
    found = [list(group) for _, group in groupby(every, lambda each: each.model)]
    for model in found:
        meant = {other for one in model for other in beside.get(one.name, ())}
        own = {one.name for one in model}
        model.extend(replace(known[n], companion=True) for n in sorted(meant - own) if n in known)
    if names:
        found = [each for each in found if any(one.name in names for one in each)]
    if changed is not None:
        found = [each for each in found if any(one.name in changed or not one.file for one in each)]
    return sorted(found, key=lambda each: (each[0].file is None, each[0].file or each[0].name))


def _loaded(endpoint: Endpoint) -> Iterator[StoredGraph]:
    rarely = "".join(
        f"OPTIONAL {{ ?g {each} ?{name} }} "
        for each, name in ((MODEL, "model"), (APART, "apart"), (FORMAT, "format"))
    )
    pattern = f"?g {FILE} ?file ; {SIZE} ?size {rarely}"
    for row in pages(endpoint, "?g ?file ?model ?size ?apart ?format", f"GRAPH ?g {{ {pattern} }}"):
        size = literal_value(row["size"])
        yield StoredGraph(
            row["g"],
            row.get("model", ""),
            literal_value(row["file"]),
            int(size) if size.isdecimal() else 0,
            "apart" not in row,
            format=literal_value(row.get("format", '""')),
        )


def _named(endpoint: Endpoint, names: Sequence[Term], known: Container[Term]) -> list[Term]:
    """Return those of *names* that are not *known*. Raises `UsageError` if there is no such graph.

    A graph without statements is none (SPARQL 1.1 Update, section 3.2).
    """
    asked = [each for each in names if each not in known]
    where = f"VALUES ?g {{ {' '.join(asked)} }} GRAPH ?g {{ ?s ?p ?o }}"
    there = {row["g"] for row in pages(endpoint, "DISTINCT ?g", where)} if asked else set()
    for each in asked:
        if each not in there:
            raise UsageError(f"--graph: the store has no graph {each}")
    return asked


def _foreign(endpoint: Endpoint, since: str | None) -> Iterator[Term]:
    """Yield the graphs that kinlint did not load; since a time, unless they say they are older."""
    old = ""
    if since is not None and not since.isdecimal():
        old = (
            f" FILTER NOT EXISTS {{ GRAPH ?g {{ ?g {MODIFIED} ?time }}"
            f' FILTER(?time <= "{since}"^^<{XSD}dateTime>) }}'
        )
    not_ours = f"FILTER NOT EXISTS {{ GRAPH ?g {{ ?g {RECORD} ?record }} }}"
    not_these = f"FILTER(?g NOT IN ({', '.join((COUNTER, *OWN))}))"
    where = f"GRAPH ?g {{ ?s ?p ?o }} {not_ours}{old} {not_these}"
    scratch = {row["g"] for row in pages(endpoint, "?g", f"GRAPH ?g {{ ?g {RDF_TYPE} {SCRATCH} }}")}
    found = (row["g"] for row in pages(endpoint, "DISTINCT ?g", where))
    return (each for each in found if each not in scratch)


def _changed(endpoint: Endpoint, since: str | None) -> frozenset[Term] | None:
    """Return the graphs that were loaded *since* then; None for all."""
    if since is None:
        return None
    if since.isdecimal():
        condition = f"?g {REVISION} ?r FILTER(?r > {since})"
    else:
        condition = f'?g {LOADED} ?t FILTER(?t > "{since}"^^<{XSD}dateTime>)'
    return frozenset(row["g"] for row in pages(endpoint, "?g", f"GRAPH ?g {{ {condition} }}"))


def pages(endpoint: Endpoint, head: str, where: str) -> Iterator[dict[str, Term]]:
    """Yield the solutions of `SELECT head WHERE { where }`, in pages by `?g`.

    A page begins with the graph that the last one ended with, which may have more solutions. None
    has as many as a page.
    """
    last, known = "", list[dict[str, Term]]()
    while True:
        after = f" FILTER(STR(?g) >= {last})" if last else ""
        query = f"SELECT {head} WHERE {{ {where}{after} }} ORDER BY ?g LIMIT {PAGE}"
        rows = list(endpoint.select(query))
        if wrong := next((row["g"] for row in rows if not IRI.fullmatch(row["g"])), None):
            raise EndpointError(f"the name of a graph in the store is no IRI: {wrong!r}")
        new = [row for row in rows if row not in known]
        yield from new
        if len(rows) < PAGE or not new:
            return
        last = f'"{iri_value(rows[-1]["g"])}"'
        known = [row for row in rows if row["g"] == rows[-1]["g"]]


def homes(endpoint: Endpoint, graphs: Iterable[Term]) -> dict[Term, Term]:
    """Return which model each of *graphs* is a part of, as far as they were loaded as one."""
    where = f"VALUES ?g {{ {' '.join(graphs)} }} GRAPH ?g {{ ?g {MODEL} ?model }}"
    return {row["g"]: row["model"] for row in pages(endpoint, "?g ?model", where)}


def statements(endpoint: Endpoint, graphs: Iterable[StoredGraph]) -> dict[Term, list[Triple]]:
    """Return what each of *graphs* states. Together they should have at most `PAGE` statements."""
    asked = list(graphs)
    found: dict[Term, list[Triple]] = {each.name: [] for each in asked}
    named = " ".join(found)
    where = f"VALUES ?g {{ {named} }} GRAPH ?g {{ ?s ?p ?o }}"
    rows = list(endpoint.select(f"SELECT ?g ?s ?p ?o {DIGITS} WHERE {{ {where} }} LIMIT {PAGE}"))
    if len(rows) >= PAGE:
        if len(asked) > 1:
            parts = (statements(endpoint, [each]) for each in asked)
            return {name: said for part in parts for name, said in part.items()}
        rows = list(_large(endpoint, asked[0].name))
    for row in rows:
        found[row.get("g", asked[0].name)].append((row["s"], row["p"], _exact(row)))
    return {
        name: [(unskolemised(s), p, unskolemised(o)) for s, p, o in said]
        for name, said in found.items()
    }


def _exact(row: Mapping[str, Term]) -> Term:
    """Return the object of the statement in *row*, with all digits of a number."""
    digits = literal_value(row["digits"]) if "digits" in row else ""
    return literal(digits, literal_datatype(row["o"])) if digits else row["o"]


def _large(endpoint: Endpoint, name: Term) -> Iterator[dict[str, Term]]:
    """Yield the statements of a graph page by page, in an order that stays the same."""
    offset = 0
    while True:
        count, inner = 0, f"SELECT ?s ?p ?o {DIGITS} WHERE {{ GRAPH {name} {{ ?s ?p ?o }} }}"
        ordered = f"{inner} ORDER BY ?s ?p ?o LIMIT {PAGE} OFFSET {offset}"
        for row in endpoint.select(ordered):
            count += 1
            yield row
        if count < PAGE:
            return
        offset += PAGE
