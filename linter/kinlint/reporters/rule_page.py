"""What there is to know about a rule, as text, Markdown and an object for JSON."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

from kinlint.model import Example, Rule
from kinlint.reporters.antipatterns import ANTIPATTERNS
from kinlint.reporters.example import Marked, marked
from kinlint.reporters.style import Style

_NAMES = {pattern.id: pattern.name for pattern in ANTIPATTERNS}
_FENCES = {"jsonld": "json", "turtle": "turtle", "urdf": "xml", "sdf": "xml", "mjcf": "xml"}
TEXT_WIDTH = 80


def text(rule: Rule, style: Style) -> Iterator[str]:
    """The page for a terminal: drawn where there are colours, plain otherwise."""
    if style.color:
        yield _drawn(rule, style)
        return
    yield f"{rule.code} {rule.name}: {rule.title}\n\n"
    yield f"Severity: {rule.severity.label}\n"
    for label, value in _facts(rule):
        yield f"{label}: {value}\n"
    for paragraph in paragraphs(rule.why):
        yield f"\n{textwrap.fill(paragraph, TEXT_WIDTH, break_long_words=False)}\n"
    for title, example in _cases(rule):
        yield f"\n{title}:\n\n{textwrap.indent(example.annotated(style), '    ')}\n"
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
    lines = [f"Severity: {rule.severity.label}  "]
    lines += [f"{label}: {value}  " for label, value in _facts(rule)]
    parts = ["\n".join(lines).rstrip(), *paragraphs(rule.why)]
    for title, example in _cases(rule):
        language = "text" if example.marks else _FENCES.get(example.format, "text")
        fence = "`" * max(3, example.longest_ticks + 1)
        parts.append(f"{title}:")
        parts.append(f"{fence}{language}\n{example.annotated(Style())}\n{fence}")
    parts.append("To ignore it:")
    parts.append("\n".join(f"- {way}" for way in _ignoring(rule)))
    if rule.links:
        parts.append("See also:")
        parts.append("\n".join(f"- <{link}>" for link in rule.links))
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
        "antipatterns": list(rule.antipatterns),
        "formats": list(rule.formats),
        "whole_model": rule.whole_model,
        "since": rule.since,
        "url": rule.iri,
        "links": list(rule.links),
        "messages": list(rule.messages),
        "examples": [_example_object(example) for example in rule.examples],
        "ignore": _ignoring(rule),
    }


def index(rules: Iterable[Rule]) -> str:
    """A Markdown table of rules by code, with links to their files below the rule directory."""
    rows = [
        "| Code | Name | Severity | Anti-patterns | What it finds |",
        "|---|---|---|---|---|",
    ]
    for rule in sorted(rules, key=lambda rule: rule.code):
        file = "/".join(Path(rule.path).parts[-2:])
        name = f"[{rule.name}]({file})" if file else rule.name
        cells = (
            rule.code,
            name,
            rule.severity.label,
            ", ".join(rule.antipatterns),
            rule.title.replace("|", "\\|"),
        )
        rows.append(f"| {' | '.join(cells)} |")
    return "\n".join(rows) + "\n"


def _facts(rule: Rule) -> Iterator[tuple[str, str]]:
    if rule.antipatterns:
        named = (f"{one} ({_NAMES[one]})" if one in _NAMES else one for one in rule.antipatterns)
        yield "Anti-patterns" if len(rule.antipatterns) > 1 else "Anti-pattern", ", ".join(named)
    if rule.formats:
        yield "Formats", ", ".join(rule.formats)
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
        if example.bad is not None:
            yield "Bad", marked(example.bad, example.format)
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
    }
