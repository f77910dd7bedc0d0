"""Reads what a rule file says about its rule: everything but the check itself."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator
from dataclasses import astuple
from pathlib import Path
from textwrap import dedent
from typing import TYPE_CHECKING

import pyoxigraph as ox

from kinlint.catalogue.repair_file import read_repairs
from kinlint.errors import RuleInvalid
from kinlint.model import Example, Rule, Severity, SeverityFor
from kinlint.vocabulary import KL, SH

if TYPE_CHECKING:
    from rdflib import Graph
    from rdflib.term import Node

SEVERITIES = {
    f"{SH}Violation": Severity.ERROR,
    f"{SH}Warning": Severity.WARNING,
    f"{SH}Info": Severity.INFO,
}


def read_rules(file: Path) -> tuple[Rule, ...]:
    """The rules that *file* states: one for a rule file, none for plain shapes.

    Raises `RuleInvalid` if it is no Turtle, states several rules, or leaves out what tells a
    rule apart: its code and its name.
    """
    from rdflib import RDF, Graph, URIRef  # noqa: PLC0415

    graph = Graph().parse(data=_turtle(file), format="turtle", publicID=file.absolute().as_uri())
    rules = sorted(graph.subjects(RDF.type, URIRef(f"{KL}Rule")), key=str)
    if len(rules) > 1:
        raise RuleInvalid(f"{file}: {len(rules)} rules in one file; a rule file holds one")
    return tuple(_rule(graph, rule, file) for rule in rules)


def _turtle(file: Path) -> str:
    """The text of *file*, once Oxigraph has parsed it: its errors say line and cause."""
    try:
        text = file.read_text("utf-8-sig")
        deque(ox.parse(text, ox.RdfFormat.TURTLE, base_iri=file.absolute().as_uri()), maxlen=0)
    except UnicodeDecodeError as error:
        raise RuleInvalid(f"{file}: not UTF-8, from byte {error.start} on") from error
    except SyntaxError as error:
        cause = str(error.msg).split(": ", 1)[-1]
        raise RuleInvalid(f"{file}:{error.lineno}: {cause}") from error
    return text


def _rule(graph: Graph, subject: Node, file: Path) -> Rule:
    from rdflib import RDFS, URIRef  # noqa: PLC0415

    def values(predicate: str) -> tuple[str, ...]:
        return tuple(sorted(str(value) for value in graph.objects(subject, URIRef(predicate))))

    def value(predicate: str) -> str:
        return next(iter(values(predicate)), "")

    name = str(subject).rpartition("/")[2]
    code = value(f"{KL}code")
    if not code:
        raise RuleInvalid(f"{file}: rule {name} has no kl:code")
    if name != file.stem:
        raise RuleInvalid(f"{file}: the rule is called {name}, so its file must be {name}.ttl")
    return Rule(
        iri=str(subject),
        code=code,
        name=name,
        title=value(str(RDFS.label)) or name,
        why=_prose(value(str(RDFS.comment))),
        severity=_severity(value(f"{SH}severity") or f"{SH}Violation", file),
        antipatterns=tuple(tag.removeprefix(KL) for tag in values(f"{KL}antiPattern")),
        symptoms=values(f"{KL}symptom"),
        formats=values(f"{KL}format"),
        links=values(str(RDFS.seeAlso)),
        messages=tuple(sorted({str(text) for text in graph.objects(None, URIRef(f"{SH}message"))})),
        examples=tuple(_examples(graph, subject)),
        since=value(f"{KL}since"),
        path=str(file),
        whole_model=value(f"{KL}wholeModel") == "true",
        targets=values(f"{KL}target"),
        severity_for=tuple(sorted(_severity_for(graph, subject, file), key=astuple)),
        group_by=values(f"{KL}groupBy"),
        optional=value(f"{KL}optional") == "true",
        also=tuple(sorted(_also(graph, subject, file), reverse=True)),
        repairs=read_repairs(graph, subject, file),
    )


def _severity(said: str, file: Path) -> Severity:
    if said not in SEVERITIES:
        raise RuleInvalid(f"{file}: {said} is no severity that kinlint knows")
    return SEVERITIES[said]


def _also(graph: Graph, subject: Node, file: Path) -> set[Severity]:
    """What single constraints of the rule count as, where they say so themselves."""
    from rdflib import URIRef  # noqa: PLC0415

    return {
        _severity(str(said), file)
        for each in graph.objects(subject, URIRef(f"{SH}sparql"))
        for said in graph.objects(each, URIRef(f"{SH}severity"))
    }


def _severity_for(graph: Graph, subject: Node, file: Path) -> Iterator[SeverityFor]:
    """What the rule counts as where `kl:severityFor` says that it is something else."""
    from rdflib import URIRef  # noqa: PLC0415

    for each in graph.objects(subject, URIRef(f"{KL}severityFor")):
        targets, formats = (
            tuple(sorted(map(str, graph.objects(each, URIRef(f"{KL}{name}")))))
            for name in ("target", "format")
        )
        severity = _severity(str(graph.value(each, URIRef(f"{SH}severity"))), file)
        yield SeverityFor(severity, targets, formats)


def _examples(graph: Graph, subject: Node) -> list[Example]:
    from rdflib import Literal, URIRef  # noqa: PLC0415

    def text(example: Node, which: str) -> Literal | None:
        found = graph.value(example, URIRef(f"{KL}{which}"))
        return found if isinstance(found, Literal) else None

    examples = []
    for example in graph.objects(subject, URIRef(f"{KL}example")):
        bad, good = text(example, "bad"), text(example, "good")
        written = next((each for each in (bad, good) if each is not None), None)
        format_ = str(written.datatype or "").removeprefix(KL) if written is not None else ""
        beside = sorted(str(path) for path in graph.objects(example, URIRef(f"{KL}beside")))
        companions = tuple(_companions(graph, example))
        unfixable = text(example, "unfixable")
        examples.append(
            Example(
                format_,
                _source(bad),
                _source(good),
                tuple(beside),
                companions,
                _source(text(example, "fixed")),
                unfixable is not None and unfixable.toPython() is True,
            )
        )
    return sorted(examples, key=lambda each: (each.bad or "", each.good or ""))


def _companions(graph: Graph, example: Node) -> Iterator[tuple[str, str]]:
    """The files that are read with *example*: the format and the text of each."""
    from rdflib import Literal, URIRef  # noqa: PLC0415

    for each in sorted(graph.objects(example, URIRef(f"{KL}with")), key=str):
        text = _source(each)
        if isinstance(each, Literal) and text is not None:
            yield str(each.datatype or "").removeprefix(KL), text


def _source(text: Node | None) -> str | None:
    return None if text is None else dedent(str(text)).strip("\n") + "\n"


def _prose(text: str) -> str:
    return " ".join(text.split())
