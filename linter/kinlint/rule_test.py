"""Holds rules to what their own files promise: form, examples, messages, engines, mutation."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Literal

from kinlint import lint, resources
from kinlint.configuration.settings import FileSettings, Settings
from kinlint.engine.check import check
from kinlint.engine.store import Store
from kinlint.errors import SourceError
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import decode, read
from kinlint.model import Example, Finding, Rule
from kinlint.rule_mutation import Bench, idle
from kinlint.rulebook import PREFIXES, Rulebook
from kinlint.text import SourceText, Span

MARK = re.compile(r"\[\|(.*?)\|\]", re.DOTALL)
PLACEHOLDER = re.compile(r"\{[?$](\w+)\}")
STRICT = FileSettings(require_reason=True)
SUFFIXES = {"jsonld": ".jsonld", "turtle": ".ttl"}


def unmarked(text: str) -> tuple[str, list[Span]]:
    """*text* without its `[|…|]` marks, and the spans they stood round."""
    spans, shift = [], 0
    for match in MARK.finditer(text):
        start = match.start() - shift
        spans.append(Span(start, start + len(match[1])))
        shift += 4
    return MARK.sub(lambda match: match[1], text), spans


def failures(rule: Rule, rulebook: Rulebook) -> Iterator[str]:
    """What *rule* promises and does not keep, a sentence each. Nothing if all is well."""
    found = list(_broken(rule, rulebook))
    yield from found
    if not found:
        examples = (each for example in rule.examples for each in _texts(example))
        yield from idle(Bench.of(rule, rulebook, examples))


def _broken(rule: Rule, rulebook: Rulebook) -> Iterator[str]:
    yield from form(rule)
    yield from messages(rule)
    if not rule.examples:
        yield "it has no example"
    for number, example in enumerate(rule.examples, 1):
        if example.format not in SUFFIXES:
            yield f"example {number} is neither ^^kl:jsonld nor ^^kl:turtle"
            continue
        try:
            yield from _judged(rule, rulebook, number, example)
        except SourceError as error:
            yield f"example {number} cannot be read: {error}"


def _judged(rule: Rule, rulebook: Rulebook, number: int, example: Example) -> Iterator[str]:
    if example.bad is not None:
        yield from _bad(rule, rulebook, number, example.format, example.bad)
    if example.good is not None:
        for finding in found(rule, rulebook, example.format, example.good):
            yield f"good example {number} is flagged at {_place(finding)}: {finding.message}"


def _texts(example: Example) -> Iterator[SourceText]:
    for text in (example.bad, example.good):
        if text is not None:
            yield _source(example.format, unmarked(text)[0])


def _source(language: str, text: str) -> SourceText:
    return SourceText("example" + SUFFIXES[language], text)


def _bad(rule: Rule, rulebook: Rulebook, number: int, language: str, marked: str) -> Iterator[str]:
    text, expected = unmarked(marked)
    if not expected:
        yield f"bad example {number} marks nothing"
    actual = found(rule, rulebook, language, text)
    for span in expected:
        if span not in [finding.location.span for finding in actual]:
            yield f"bad example {number}: {text[span.start : span.end]} is marked and not found"
    for finding in actual:
        if finding.location.span not in expected:
            where = f"{_place(finding)} without a mark"
            yield f"bad example {number}: found at {where}: {finding.message}"
        if "''" in finding.message:
            yield f"bad example {number}: a variable of the message is empty: {finding.message}"
    judged = results(rule, rulebook, language, text, "oxigraph")
    if judged != results(rule, rulebook, language, text, "pyshacl"):
        yield f"bad example {number}: the engines disagree"


def found(rule: Rule, rulebook: Rulebook, language: str, text: str) -> list[Finding]:
    """The findings of *rule* in an example."""
    return _lint(rule, rulebook, language, text, "oxigraph")


def results(
    rule: Rule,
    rulebook: Rulebook,
    language: str,
    text: str,
    engine: Literal["oxigraph", "pyshacl"],
) -> set[tuple[Span, str | None]]:
    """Where an engine finds *rule* broken in an example, and by which path."""
    every = _lint(rule, rulebook, language, text, engine)
    return {(finding.location.span, finding.path) for finding in every}


def _lint(
    rule: Rule,
    rulebook: Rulebook,
    language: str,
    text: str,
    engine: Literal["oxigraph", "pyshacl"],
) -> list[Finding]:
    source = _source(language, text)
    own = tuple(each for each in rulebook.constraints if each.owner == rule.iri)
    shapes = tuple(file for file in rulebook.shapes if file.name in (PREFIXES, f"{rule.name}.ttl"))
    only = replace(rulebook, constraints=own, shapes=shapes)
    report = lint.run([source], [], Settings(engine=engine, default=STRICT), only)
    if report.errors:
        raise report.errors[0]
    return [finding for finding in report.findings if finding.rule.iri == rule.iri]


def _place(finding: Finding) -> str:
    start = finding.location.start
    return f"{start.line}:{start.column}"


def messages(rule: Rule) -> Iterator[str]:
    """Messages end in a period and put what they fill in into single quotes."""
    for message in rule.messages:
        if not message.endswith("."):
            yield f"message does not end in a period: {message}"
        for match in PLACEHOLDER.finditer(message):
            if message[match.start() - 1 : match.end() + 1] != f"'{match[0]}'":
                yield f"message has {match[0]} outside single quotes: {message}"


def form(rule: Rule) -> Iterator[str]:
    """What the rule's file says against `shapes/rule.ttl`."""
    from kinlint.engine.compiler.compile import compile_shapes  # noqa: PLC0415

    shapes = compile_shapes([resources.data("shapes") / "rule.ttl"])
    source = decode(rule.path, Path(rule.path).read_bytes())
    store = Store()
    store.load([read(source, ReadOptions())])
    for result in check(store, shapes):
        yield next(iter(result.constraint.messages), f"{result.path} has a wrong value")
