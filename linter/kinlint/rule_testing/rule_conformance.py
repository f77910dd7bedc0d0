"""Holds rules to what their own files promise: form, examples, messages, engines, mutation."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import ExitStack, suppress
from functools import lru_cache
from pathlib import Path
from typing import Literal

from kinlint import lint, resources
from kinlint.catalogue.rulebook import PREFIXES, Rulebook
from kinlint.catalogue.scaffold import unfilled
from kinlint.configuration.settings import Choice, FileSettings, Settings
from kinlint.engine.constraint import Constraint
from kinlint.engine.evaluate import check
from kinlint.engine.store import Store
from kinlint.errors import SourceError
from kinlint.finding import Finding
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import decode, read
from kinlint.light_dataclasses import replace
from kinlint.rule import Example, Rule
from kinlint.rule_testing.example_texts import FORMATS, Texts, beside, source, texts_of, unmarked
from kinlint.rule_testing.mutation_harness import MutationHarness, closed, parts_needed
from kinlint.rule_testing.remarks import Remark, is_built_in, malformed, unused
from kinlint.rule_testing.unmatched_pattern import unmatched
from kinlint.sparql.tokens import tokens
from kinlint.targets.portability import departing_targets
from kinlint.text import Span
from kinlint.vocabulary import SH

UNQUOTED = re.compile(r"(?<!')\{[?$]this\}|\{[?$]this\}(?!')")
STRICT = FileSettings(choices=(Choice(select=("ALL",)),), require_reason=True)


def failures(rule: Rule, rulebook: Rulebook) -> Iterator[str]:
    """Yield what *rule* promises and does not keep, a sentence each.

    What is a duty of kinlint's own rules is a `Remark` of others.
    """
    if waiting := [*_unfilled(rule), *nonstandard_queries(rule)]:
        yield from waiting
        return
    found = [*broken_promises(rule, rulebook), *disagreements(rule, rulebook)]
    yield from found
    yield from repair_failures(rule, rulebook)
    if not is_built_in(rule):
        yield from unused(rule)
    if all(isinstance(each, Remark) for each in found):
        parts = untested_parts(rule, rulebook)
        yield from parts if is_built_in(rule) else map(Remark, parts)


def nonstandard_queries(rule: Rule) -> Iterator[str]:
    """Yield queries of *rule* that rdflib does not take for SPARQL 1.1."""
    from kinlint.rule_testing.sparql_conformance import nonstandard  # noqa: PLC0415  it loads rdflib

    yield from nonstandard(rule)


def _unfilled(rule: Rule) -> Iterator[str]:
    """Yield what `kinlint new` left to the author of *rule*."""
    text = Path(rule.path).read_text("utf-8-sig")
    for number, line in unfilled(text):
        yield f"line {number} is not filled in: {line}"


def _uncomputed(rule: Rule) -> Iterator[str]:
    """Yield the facts that *rule* asks for and nothing computes."""
    from kinlint.catalogue.asked_facts import uncomputed  # noqa: PLC0415  it loads all that computes
    from kinlint.catalogue.repair_file import prefixes  # noqa: PLC0415
    from kinlint.engine.compiler.shapes_graph import parse  # noqa: PLC0415

    yield from uncomputed(parse(Path(rule.path)), prefixes())


def broken_promises(rule: Rule, rulebook: Rulebook) -> Iterator[str]:
    """Yield faults of the form of *rule*, and examples that it gets wrong."""
    yield from _unfilled(rule)
    yield from _uncomputed(rule)
    yield from form(rule)
    yield from messages(rule)
    yield from grouping(rule, rulebook)
    if not rule.examples:
        yield "it has no example"
    for number, example in enumerate(rule.examples, 1):
        if example.format not in FORMATS:
            yield f"example {number} is in none of the formats {', '.join(FORMATS)}"
            continue
        try:
            yield from _judged(rule, rulebook, number, example)
        except SourceError as error:
            yield f"example {number} cannot be read: {error}"


def _judged(rule: Rule, rulebook: Rulebook, number: int, example: Example) -> Iterator[str]:
    with beside(example) as home:
        if example.bad is not None:
            text, expected = unmarked(example.bad)
            yield from _bad(rule, rulebook, number, source(example, text, home), expected)
        if example.good is not None:
            texts = source(example, example.good, home)
            if (flaw := malformed(read(texts[0], ReadOptions()))) and not is_built_in(rule):
                yield f"good example {number}: {flaw}"
            for finding in found(rule, rulebook, texts):
                yield f"good example {number} is flagged at {_place(finding)}: {finding.message}"


def disagreements(rule: Rule, rulebook: Rulebook) -> Iterator[str]:
    """Yield bad examples on which the two engines disagree."""
    for number, example in enumerate(rule.examples, 1):
        if example.bad is None or example.format not in FORMATS:
            continue
        with beside(example) as home, suppress(SourceError):
            texts = source(example, unmarked(example.bad)[0], home)
            judged = results(rule, rulebook, texts, "oxigraph")
            if judged != results(rule, rulebook, texts, "pyshacl"):
                yield f"bad example {number}: the engines disagree"


def untested_parts(rule: Rule, rulebook: Rulebook) -> Iterator[str]:
    """Yield the parts of queries of *rule* that no example needs."""
    for part, needed in query_parts(rule, rulebook):
        if not needed:
            yield f"no example shows why the query needs {part}"


def query_parts(rule: Rule, rulebook: Rulebook) -> Iterator[tuple[str, bool]]:
    """Yield the parts of queries of *rule*, and whether an example needs each."""
    examples = (each for example in rule.examples for each in texts_of(example))
    yield from parts_needed(MutationHarness.for_rule(rule, rulebook, examples))


def repair_failures(rule: Rule, rulebook: Rulebook) -> Iterator[str]:
    """Yield bad examples that the repairs of *rule* do not turn into what they promise."""
    if not rule.repairs:
        return
    from kinlint.rule_testing.repair_examples import shown  # noqa: PLC0415  few rules have repairs

    only, settings = alone(rule, rulebook, "oxigraph")
    with ExitStack() as stack:
        bad = [
            (number, each, source(each, unmarked(each.bad)[0], stack.enter_context(beside(each))))
            for number, each in enumerate(rule.examples, 1)
            if each.bad is not None and each.format in FORMATS
        ]
        yield from shown(rule, only, settings, bad)


def _bad(
    rule: Rule, rulebook: Rulebook, number: int, texts: Texts, expected: list[Span]
) -> Iterator[str]:
    if not expected:
        yield f"bad example {number} marks nothing"
    actual = found(rule, rulebook, texts)
    for span in expected:
        if span not in [finding.location.span for finding in actual]:
            documents, store = closed(texts, rulebook)
            why = malformed(documents[0]) or unmatched(rule, documents, store, span)
            because = f": {why}" if why else ""
            yield f"bad example {number}: {texts[0][span]} is marked and not found{because}"
    for finding in actual:
        if finding.location.span not in expected:
            where = f"{_place(finding)} without a mark"
            yield f"bad example {number}: found at {where}: {finding.message}"
        if "''" in finding.message:
            yield f"bad example {number}: a variable of the message is empty: {finding.message}"
        if "''" in finding.reason:
            yield f"bad example {number}: a variable of kl:because is empty: {finding.reason}"


def found(rule: Rule, rulebook: Rulebook, texts: Texts) -> list[Finding]:
    """Return the findings of *rule* in an example."""
    return _lint(rule, rulebook, texts, "oxigraph")


def results(
    rule: Rule, rulebook: Rulebook, texts: Texts, engine: Literal["oxigraph", "pyshacl"]
) -> set[tuple[Span, str | None]]:
    """Return the places where an engine finds *rule* broken in an example, each with its path."""
    every = _lint(rule, rulebook, texts, engine)
    apart = (each for finding in every for each in finding.members or (finding,))
    return {(finding.location.span, finding.path) for finding in apart}


def _lint(
    rule: Rule, rulebook: Rulebook, texts: Texts, engine: Literal["oxigraph", "pyshacl"]
) -> list[Finding]:
    only, settings = alone(rule, rulebook, engine)
    report = lint.run(texts, [], settings, only)
    if report.errors:
        raise report.errors[0]
    return [finding for finding in report.findings if finding.rule.iri == rule.iri]


def alone(
    rule: Rule, rulebook: Rulebook, engine: Literal["oxigraph", "pyshacl"]
) -> tuple[Rulebook, Settings]:
    """Return *rulebook* with the constraints of *rule* only, and settings under which it speaks."""
    own = rulebook.constraints_of(rule.iri)
    shapes = tuple(file for file in rulebook.shapes if file.name in (PREFIXES, f"{rule.name}.ttl"))
    only = replace(rulebook, constraints=own, shapes=shapes)
    consumers = {*rule.targets, *(name for each in own for name in each.consumers)}
    consumers.update(departing_targets(rule.features))
    if any("?targetUntil" in each.select for each in own):
        consumers |= {f"{name}@0" for name in consumers if "@" not in name}
    strict = replace(STRICT, targets=tuple(sorted(consumers)))
    return only, Settings(engine=engine, default=strict)


def _place(finding: Finding) -> str:
    start = finding.location.start
    return f"{start.line}:{start.column}"


def messages(rule: Rule) -> Iterator[str]:
    """Yield messages without a period at the end, or with the focus node outside single quotes."""
    for message in rule.messages:
        if not message.endswith("."):
            yield f"message does not end in a period: {message}"
        if UNQUOTED.search(message):
            yield f"message has {{$this}} outside single quotes: {message}"


def grouping(rule: Rule, rulebook: Rulebook) -> Iterator[str]:
    """Yield variables that a rule groups by, or orders a group by, and none of its queries has."""
    queries = [each.select for each in rulebook.constraints_of(rule.iri)]
    known = {"?file"}.union(*(tokens(query, {}) for query in queries))
    for name in rule.group_by:
        if queries and f"?{name}" not in known:
            yield f"it groups by ?{name}, which is in none of its queries"
    if rule.worst and f"?{rule.worst}" not in known:
        yield f"its kl:worst is ?{rule.worst}, which is in none of its queries"


def form(rule: Rule) -> Iterator[str]:
    """Yield violations of `shapes/rule.ttl` in the file of *rule*."""
    source = decode(rule.path, Path(rule.path).read_bytes())
    store = Store()
    store.load([read(source, ReadOptions())])
    for result in check(store, _form_shapes()):
        said = next(iter(result.constraint.messages), f"{result.path} has a wrong value")
        wish = result.constraint.severity == f"{SH}Info" and not is_built_in(rule)
        yield Remark(said) if wish else said


@lru_cache(maxsize=1)
def _form_shapes() -> tuple[Constraint, ...]:
    from kinlint.engine.compiler.shapes_compiler import compile_shapes  # noqa: PLC0415

    return compile_shapes([resources.data("shapes") / "rule.ttl"])
