"""What there is to know about a rule, as text, Markdown and an object for JSON."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any
from urllib.parse import quote

from kinlint import resources
from kinlint.model import Example, Rule
from kinlint.reporters.antipatterns import ANTIPATTERNS
from kinlint.reporters.example import Marked, marked
from kinlint.reporters.repair import furthest, heading, repair_object
from kinlint.reporters.style import Style
from kinlint.reporters.symptoms import SYMPTOMS, symptom_table

_NAMES = {pattern.id: pattern.name for pattern in ANTIPATTERNS}
_FENCES = {"jsonld": "json", "turtle": "turtle", "urdf": "xml", "sdf": "xml", "mjcf": "xml"}
TEXT_WIDTH = 80
INTRODUCTION = """\
# The rules of kinlint

One Turtle file is one rule. It is a SHACL shape, and says in the same place what it finds and how
bad that is, why it matters, which anti-patterns (AP1 to AP6) it witnesses, and what a bad and a
good model look like. Carets below show what is flagged in the bad one.

This page is made from those files: `kinlint rule --all --output-format markdown`. One rule is
explained by `kinlint rule CODE`.

Some rules bring repairs, as SPARQL Updates. The index tells how far the best of them may be
trusted: `safe` ones `kinlint --fix` makes, `unsafe` ones only with `--unsafe-fixes`.

A rule needs no kinlint to run. Any SHACL engine that knows SPARQL constraints will do, with the
ontology and the units beside the model, such as pySHACL from the top of this repository:

```sh
pyshacl -im -s rules/units/missing-unit.ttl -i owlrl \\
    model.ttl shapes/ontology/*.ttl shapes/units/*.ttl
```

It tells which node is at fault, though not where in the file; and rules about what JSON-LD loses
find nothing there, since it is lost before.

A rule is ignored

- for one run: `--ignore CODE`
- for a project: `ignore = ["CODE"]` under `[tool.kinlint]` in `pyproject.toml`
- for one node of a model: `"https://w3id.org/kinlint/ns#ignore": "CODE"`

where CODE may be a name, the beginning of codes (`UNI`) or an anti-pattern (`AP3`), too.
"""
SYMPTOM_INTRODUCTION = """
## Symptoms

What the anti-patterns look like in a model, and which rules find them in each format. What is
*inherent* in a format, no author can avoid: `kinlint --profile` tells it.

"""


def text(rule: Rule, style: Style) -> Iterator[str]:
    """The page for a terminal: drawn where there are colours, plain otherwise."""
    if style.color:
        yield _drawn(rule, style)
        return
    yield f"{rule.code} {rule.name}: {rule.title}\n\n"
    yield f"Severity: {_severity(rule)}\n"
    for label, value in _facts(rule):
        yield f"{label}: {value}\n"
    for paragraph in paragraphs(rule.why):
        yield f"\n{textwrap.fill(paragraph, TEXT_WIDTH, break_long_words=False)}\n"
    for title, example in _cases(rule):
        yield f"\n{title}:\n\n{textwrap.indent(example.annotated(style), '    ')}\n"
    for repair in rule.repairs:
        told = textwrap.fill(f"Fix: {heading(repair).replace('`', '')}", TEXT_WIDTH)
        yield f"\n{told}\n\n{textwrap.indent(repair.update, '    ')}\n"
    yield "\nTo ignore it:\n\n"
    for way in _ignoring(rule):
        yield f"  - {way.replace('`', '')}\n"
    if rule.links:
        yield "\nSee also:\n\n"
    for link in rule.links:
        yield f"  - {link}\n"


def _drawn(rule: Rule, style: Style) -> str:
    from rich.markdown import Markdown  # noqa: PLC0415

    from kinlint.reporters.drawing import drawn  # noqa: PLC0415

    page = Markdown(markdown(rule), code_theme="ansi_dark", hyperlinks=True)
    return drawn(page, style)


def markdown(rule: Rule) -> str:
    """The page as Markdown, with a heading."""
    return f"# {rule.code} {rule.name}\n\n**{rule.title}**\n\n{help_markdown(rule)}"


def help_markdown(rule: Rule) -> str:
    """The page as Markdown, without what SARIF viewers show above it."""
    ways = "\n".join(f"- {way}" for way in _ignoring(rule))
    return _joined(*_explained(rule), "To ignore it:", ways, *_links(rule))


def catalogue(rules: Iterable[Rule]) -> Iterator[str]:
    """All *rules* on one page of Markdown: how to read and run them, an index, and a section each.

    Links lead to files below the directory of the rules.
    """
    ordered = sorted(rules, key=lambda rule: rule.code)
    yield INTRODUCTION
    yield "\n## Index\n"
    families: dict[str, list[Rule]] = {}
    for rule in ordered:
        families.setdefault(Path(rule.path).parent.name, []).append(rule)
    for family, members in families.items():
        codes = ", ".join(sorted({rule.family for rule in members}))
        yield f"\n### {family or 'other'} ({codes})\n\n{_index(members)}"
    yield SYMPTOM_INTRODUCTION
    yield "\n".join(symptom_table(ordered)) + "\n"
    robots = resources.data("rules") / "real-robots.md"
    if robots.is_file():
        yield "\n" + robots.read_text("utf-8")
    for rule in ordered:
        file = "/".join(Path(rule.path).parts[-2:])
        source = f"Rule file: [{file}]({quote(file)})" if file else ""
        parts = *_explained(rule), *_links(rule), source
        yield f"\n## {_heading(rule)}\n\n**{rule.title}**\n\n{_joined(*parts)}"


def _explained(rule: Rule) -> Iterator[str]:
    lines = [f"Severity: {_severity(rule)}  "]
    lines += [f"{label}: {value}  " for label, value in _facts(rule)]
    yield "\n".join(lines).rstrip()
    yield from paragraphs(rule.why)
    for title, example in _cases(rule):
        language = "text" if example.marks else _FENCES.get(example.format, "text")
        fence = "`" * max(3, example.longest_ticks + 1)
        yield f"{title}:"
        yield f"{fence}{language}\n{example.annotated(Style())}\n{fence}"
    for repair in rule.repairs:
        yield f"Fix: {heading(repair)}"
        yield f"```sparql\n{repair.update}\n```"


def _links(rule: Rule) -> Iterator[str]:
    if rule.links:
        yield "See also:"
        yield "\n".join(f"- <{link}>" for link in rule.links)


def _joined(*parts: str) -> str:
    return "\n\n".join(part for part in parts if part) + "\n"


def help_text(rule: Rule) -> str:
    """The reason and where to read on, for viewers that know no Markdown."""
    return "\n\n".join([*paragraphs(rule.why), f"kinlint rule {rule.code}"])


def rule_object(rule: Rule) -> dict[str, Any]:
    """The page as an object for JSON."""
    return {
        "code": rule.code,
        "name": rule.name,
        "title": rule.title,
        "why": "\n\n".join(paragraphs(rule.why)),
        "severity": rule.severity.label,
        "severity_for_some": [each.label for each in rule.also],
        "severity_for": [
            {"severity": each.severity.label, "targets": each.targets, "formats": each.formats}
            for each in rule.severity_for
        ],
        "targets": list(rule.targets),
        "antipatterns": list(rule.antipatterns),
        "symptoms": list(rule.symptoms),
        "formats": list(rule.formats),
        "whole_model": rule.whole_model,
        "optional": rule.optional,
        "group_by": list(rule.group_by),
        "since": rule.since,
        "url": rule.iri,
        "links": list(rule.links),
        "messages": list(rule.messages),
        "examples": [_example_object(example) for example in rule.examples],
        "fixes": [repair_object(repair) for repair in rule.repairs],
        "ignore": _ignoring(rule),
    }


def _severity(rule: Rule) -> str:
    """What the rule counts as, and what else for whom."""
    parts = [rule.severity.label, *(f"{each.label} for some findings" for each in rule.also)]
    for each in rule.severity_for:
        where = f" in {' and '.join(each.formats)}" if each.formats else ""
        whom = f" with --target {' or '.join(each.targets)}" if each.targets else ""
        parts.append(each.severity.label + where + whom)
    return "; ".join(parts)


def _index(rules: Iterable[Rule]) -> str:
    """A Markdown table of *rules*, with links to their sections."""
    titles = ("Code", "Name", "Severity", "Anti-patterns", "Fix", "What it finds")
    rows = [f"| {' | '.join(titles)} |", "|---" * len(titles) + "|"]
    for rule in rules:
        anchor = re.sub(r"[^\w -]", "", _heading(rule).lower()).replace(" ", "-")
        cells = (
            rule.code,
            f"[{rule.name}](#{anchor})",
            rule.severity.label,
            ", ".join(rule.antipatterns),
            furthest(rule),
            rule.title.replace("|", "\\|"),
        )
        rows.append(f"| {' | '.join(cells)} |")
    return "\n".join(rows) + "\n"


def _heading(rule: Rule) -> str:
    return f"{rule.code} {rule.name}"


def _facts(rule: Rule) -> Iterator[tuple[str, str]]:
    if rule.antipatterns:
        named = (f"{one} ({_NAMES[one]})" if one in _NAMES else one for one in rule.antipatterns)
        yield "Anti-patterns" if len(rule.antipatterns) > 1 else "Anti-pattern", ", ".join(named)
    for symptom in rule.symptoms:
        yield f"Symptom {symptom}", SYMPTOMS.get(symptom, "")
    if rule.formats:
        yield "Formats", ", ".join(rule.formats)
    if rule.targets:
        yield "Needs", " or ".join(f"--target {target}" for target in rule.targets)
    if rule.optional:
        yield "Needs", f"to be selected, as by --extend-select {rule.code}"
    if rule.whole_model:
        yield "Needs", "the whole model, so it is silent with --partial"
    if rule.since:
        yield "Since", rule.since


def paragraphs(why: str) -> list[str]:
    """The paragraphs of a text, each on one line."""
    blocks = textwrap.dedent(why).strip().split("\n\n")
    return [" ".join(block.split()) for block in blocks if block.strip()]


def _cases(rule: Rule) -> Iterator[tuple[str, Marked]]:
    for example in rule.examples:
        beside = f" (beside it: {', '.join(example.beside)})" if example.beside else ""
        if example.bad is not None:
            yield f"Bad{beside}", marked(example.bad, example.format)
        if example.good is not None:
            yield "Good", marked(example.good, example.format)


def _ignoring(rule: Rule) -> list[str]:
    return [
        f"for one run: `--ignore {rule.code}`",
        f'for a project: `ignore = ["{rule.code}"]` under `[tool.kinlint]` in `pyproject.toml`',
        f'for one node of a model: `"https://w3id.org/kinlint/ns#ignore": "{rule.code}"`',
    ]


def _example_object(example: Example) -> dict[str, Any]:
    bad = None if example.bad is None else marked(example.bad, example.format)
    good = None if example.good is None else marked(example.good, example.format)
    return {
        "format": example.format,
        "bad": bad and bad.text,
        "marks": [] if bad is None else bad.places(),
        "good": good and good.text,
        "beside": list(example.beside),
    }
