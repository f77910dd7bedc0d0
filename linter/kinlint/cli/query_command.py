"""`kinlint query`: asks the graph that rules see."""

from __future__ import annotations

import csv
import io
import json
import sys
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from kinlint.cli.argument_parser import Parser, one_of
from kinlint.cli.model_inputs import add_input_options, find_inputs
from kinlint.cli.xacro_arguments import take_arguments
from kinlint.errors import UsageError
from kinlint.reporters.display_width import printable
from kinlint.reporters.reporter_registry import put
from kinlint.terms import Term, is_blank, is_iri, literal_datatype, literal_value

if TYPE_CHECKING:
    from kinlint.cli.model_graph import ModelGraph, TermWriter

FORMATS = ("table", "csv", "json")
FORMULA = ("=", "+", "-", "@", "\t", "\r")
"""Beginnings of a cell that spreadsheets evaluate (https://owasp.org/www-community/attacks/CSV_Injection)."""
DESCRIPTION = """\
Query the graph that rules see with SPARQL: SELECT, ASK or CONSTRUCT. The prefixes of rules need no
declaration. Each row has the place of its first node that a file describes; `kinlint graph
--output-format turtle` shows the whole graph."""
EPILOG = """\
Example: kinlint query 'SELECT ?joint ?type { ?joint at:type ?type }' robot.urdf
Exit code: 0 answered; 2 if the query is wrong or a file cannot be read."""


def parser() -> Parser:
    """The parser of `kinlint query`."""
    made = Parser(
        prog="kinlint query",
        description=DESCRIPTION,
        epilog=EPILOG,
        usage="kinlint query QUERY FILE... [options]",
    )
    made.add_positionals("paths", "QUERY FILE", "the query, and the models; - is standard input")
    add = made.add_argument
    add(
        "--output-format",
        type=one_of(FORMATS),
        metavar="|".join(FORMATS),
        default=FORMATS[0],
        help="the format of rows (default: table); CONSTRUCT gives Turtle",
    )
    add_input_options(add, "add the vocabulary of the rules in DIR")
    return made


def run(arguments: Sequence[str]) -> int:
    """Answer the query that *arguments* hold; the exit code."""
    options = parser().read(arguments)
    take_arguments(options)
    if len(options.paths) + bool(options.stdin_filename) < 2:  # noqa: PLR2004  query and file
        raise UsageError(
            "expected a query and a file, such as 'SELECT * { ?a urdf:joint ?b }' a.urdf"
        )
    text, *options.paths = options.paths

    from kinlint.catalogue.query_checks import checked_query  # noqa: PLC0415  engines are slow
    from kinlint.cli.model_graph import TermWriter, read_graph  # noqa: PLC0415

    query = checked_query(text)
    found, settings = find_inputs(options)
    if not found.inputs and not found.errors:
        raise UsageError(f"no robot found in '{found.barren[0]}'")
    graph = read_graph(found, settings, options)
    put(_answer(graph, query, options.output_format, TermWriter()), sys.stdout)
    return 0


def _answer(graph: ModelGraph, query: str, form: str, writer: TermWriter) -> Iterator[str]:
    """Yield the answer of *graph* to *query* in the format *form*."""
    import pyoxigraph as ox  # noqa: PLC0415  a native module

    from kinlint.engine.store import token  # noqa: PLC0415

    answer = graph.store.query(query)
    if isinstance(answer, ox.QueryBoolean):
        said = "true" if answer else "false"
        yield f'{{"head": {{}}, "boolean": {said}}}\n' if form == "json" else f"{said}\n"
    elif isinstance(answer, ox.QueryTriples):
        lines = [
            f"{writer.term(s)} {writer.term(p)} {writer.term(o)} ."
            for s, p, o in sorted({tuple(map(token, each)) for each in answer})
        ]
        yield from (f"@prefix {name}: <{space}> .\n" for name, space in sorted(writer.used.items()))
        yield from (f"{line}\n" for line in lines)
    else:
        names = [each.value for each in answer.variables]
        rows = [tuple(None if each is None else token(each) for each in row) for row in answer]
        if "ORDER" not in query.upper().split():
            rows.sort(key=lambda row: [each or "" for each in row])
        yield from _rows(graph, names, rows, form, writer)


Row = Sequence["Term | None"]


def _rows(
    graph: ModelGraph, names: Sequence[str], rows: Sequence[Row], form: str, writer: TermWriter
) -> Iterator[str]:
    """Yield the solutions *rows* of the variables *names*."""
    if form == "json":
        bindings = [
            {n: _json(graph, each) for n, each in zip(names, row, strict=True) if each is not None}
            for row in rows
        ]
        whole = {"head": {"vars": list(names)}, "results": {"bindings": bindings}}
        yield json.dumps(whole, indent=2, ensure_ascii=False) + "\n"
        return
    places = [next((p for each in row if each and (p := graph.place(each))), "") for row in rows]
    if form == "csv":
        stream = io.StringIO()
        table = csv.writer(stream, lineterminator="\r\n")
        table.writerow([*names, "place"])
        for row, place in zip(rows, places, strict=True):
            table.writerow(
                [*("" if each is None else _cell(_plain(each)) for each in row), _cell(place)]
            )
        yield stream.getvalue()
        return
    cells = [
        [*("" if each is None else _short(each, writer, graph) for each in row), printable(place)]
        for row, place in zip(rows, places, strict=True)
    ]
    heads = [*(f"?{name}" for name in names), "place"]
    widths = [max(map(len, column)) for column in zip(heads, *cells, strict=True)]
    for line in (heads, *cells):
        padded = (each.ljust(width) for each, width in zip(line, widths, strict=True))
        yield "  ".join(padded).rstrip() + "\n"
    yield f"{len(rows)} row{'s' * (len(rows) != 1)}\n"


def _short(term: Term, writer: TermWriter, graph: ModelGraph) -> str:
    """Return *term* as short as a table can have it: nodes of files by what follows the `#`."""
    for document in graph.documents:
        if is_iri(term) and term[1:].startswith(document.graph[1:-1] + "#"):
            return printable(term[len(document.graph) - 1 : -1])
    return printable(_plain(term) if term.startswith('"') else writer.term(term))


def _cell(text: str) -> str:
    """Return *text* as a cell of CSV: one that spreadsheets take for a formula is quoted."""
    if not text.startswith(FORMULA):
        return text
    try:
        float(text)
    except ValueError:
        return f"'{text}"
    return text


def _plain(term: Term) -> str:
    if is_iri(term):
        return term[1:-1]
    return literal_value(term) if term.startswith('"') else term


def _json(graph: ModelGraph, term: Term) -> dict[str, Any]:
    """Return *term* as SPARQL 1.1 Query Results JSON has it, with the `place` of a node."""
    kind = "uri" if is_iri(term) else "bnode" if is_blank(term) else "literal"
    found = {
        "type": kind,
        "value": _plain(term).removeprefix("_:") if kind == "bnode" else _plain(term),
    }
    if kind == "literal" and "^^<" in term:
        found["datatype"] = literal_datatype(term)
    elif kind == "literal" and (tag := term.rpartition('"')[2]).startswith("@"):
        found["xml:lang"] = tag[1:]
    place = graph.place(term)
    return {**found, "place": place} if place else found
