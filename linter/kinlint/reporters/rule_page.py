"""The page of a rule as text, Markdown and an object for JSON."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any
from urllib.parse import quote

from kinlint.formats.records import FORMATS
from kinlint.light_dataclasses import replace
from kinlint.reporters.antipatterns import ANTIPATTERNS
from kinlint.reporters.rule_example import MarkedText, parse_marks
from kinlint.reporters.rule_fix_section import heading, repair_object
from kinlint.reporters.rule_summary import summary
from kinlint.reporters.symptoms import SYMPTOMS
from kinlint.reporters.terminal_style import Style
from kinlint.rule import PROGRAMS, Example, Rule

_NAMES = {pattern.id: pattern.name for pattern in ANTIPATTERNS}
_FENCES = {each.name: each.fence for each in FORMATS}
TEXT_WIDTH = 80


def text(rule: Rule, style: Style, *, full: bool) -> Iterator[str]:
    """The page for a terminal: drawn where there are colours, plain otherwise.

    Examples in formats of elements come first, those in URDF before all others.
    """
    rule = replace(rule, examples=sorted(rule.examples, key=_familiar)) if full else brief(rule)
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
        yield f"\n{told}\n"
        if repair.update:
            yield f"\n{textwrap.indent(repair.update, '    ')}\n"
    yield from _listed("To ignore it", _ignoring(rule))
    yield from _listed("Facts that it asks for", _asked(rule))
    yield from _listed("See also", rule.links)


def brief(rule: Rule) -> Rule:
    """Return *rule* with one short example, and without queries and facts."""
    return summary(rule, sorted(rule.examples, key=_familiar))


def _familiar(example: Example) -> tuple[bool, int]:
    at = next((at for at, form in enumerate(FORMATS) if form.name == example.format), len(FORMATS))
    return at == len(FORMATS) or not FORMATS[at].is_tree, at


def _listed(title: str, items: Iterable[str]) -> Iterator[str]:
    lines = [f"  - {each.replace('`', '')}\n" for each in items]
    if lines:
        yield f"\n{title}:\n\n"
    yield from lines


def _drawn(rule: Rule, style: Style) -> str:
    from rich.markdown import Markdown  # noqa: PLC0415

    from kinlint.reporters.rich_render import rich_text  # noqa: PLC0415

    page = Markdown(markdown(rule), code_theme="ansi_dark", hyperlinks=True)
    return rich_text(page, style)


def markdown(rule: Rule) -> str:
    """The page as Markdown, with a heading."""
    asked = "\n".join(["\nFacts that it asks for:\n", *(f"- {each}" for each in _asked(rule)), ""])
    title = f"# {rule.code} {rule.name}\n\n**{rule.title}**\n\n"
    return f"{title}{help_markdown(rule)}{asked if rule.facts else ''}"


def help_markdown(rule: Rule) -> str:
    """The page as Markdown, without what SARIF viewers show above it."""
    ways = "\n".join(f"- {way}" for way in _ignoring(rule))
    return _joined(*_explained(rule), *(("To ignore it:", ways) if ways else ()), *_links(rule))


def section(rule: Rule, directory: str = "") -> str:
    """The section of *rule* in a page about several, in the *directory* of its family or above."""
    file = Path(rule.path)
    shown = file.name if directory else "/".join(file.parts[-2:])
    source = f"Rule file: [{shown}]({quote(shown)})" if shown else ""
    parts = *_explained(rule), *_links(rule), source
    return f"## {section_title(rule)}\n\n**{rule.title}**\n\n{_joined(*parts)}"


def section_title(rule: Rule) -> str:
    """The heading of the section of *rule*."""
    return f"{rule.code} {rule.name}"


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
        if repair.update:
            yield f"```sparql\n{repair.update}\n```"


def _asked(rule: Rule) -> Iterator[str]:
    """Yield the facts that *rule* asks for, with the modules that compute them."""
    return (f"`fact:{name}`, computed by `{module}`" for name, module in rule.facts)


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
        "constraint_severity_for": [
            {"severity": each.severity.label, "targets": each.targets, "formats": each.formats}
            for each in rule.also_for
        ],
        "targets": list(rule.targets),
        "features": list(rule.features),
        "antipatterns": list(rule.antipatterns),
        "symptoms": list(rule.symptoms),
        "formats": list(rule.formats),
        "whole_model": rule.whole_model,
        "preview": rule.preview,
        "optional": rule.optional,
        "group_by": list(rule.group_by),
        "worst": rule.worst or None,
        "since": rule.since,
        "url": rule.iri,
        "links": list(rule.links),
        "facts": [{"name": name, "module": module} for name, module in rule.facts],
        "messages": list(rule.messages),
        "examples": [_example_object(example) for example in rule.examples],
        "fixes": [repair_object(repair) for repair in rule.repairs],
        "ignore": _ignoring(rule),
    }


def _severity(rule: Rule) -> str:
    """Return the severity of the rule, with those for certain targets and formats."""
    parts = [rule.severity.label, *(f"{each.label} for some findings" for each in rule.also)]
    for each in (*rule.severity_for, *rule.also_for):
        some = " for some findings" if each in rule.also_for else ""
        where = f" in {' and '.join(each.formats)}" if each.formats else ""
        whom = f" with --target {' or '.join(each.targets)}" if each.targets else ""
        parts.append(each.severity.label + some + where + whom)
    return "; ".join(parts)


def _facts(rule: Rule) -> Iterator[tuple[str, str]]:
    if rule.antipatterns:
        named = (f"{one} ({_NAMES[one]})" if one in _NAMES else one for one in rule.antipatterns)
        yield "Anti-patterns" if len(rule.antipatterns) > 1 else "Anti-pattern", ", ".join(named)
    for symptom in rule.symptoms:
        yield f"Symptom {symptom}", SYMPTOMS.get(symptom, "")
    if rule.formats:
        yield "Formats", ", ".join(rule.formats)
    yield from _needed_targets(rule)
    if rule.preview:
        yield "Preview", f"off without --preview or --extend-select {rule.code}"
    if rule.unparsable:
        yield "Exit code", "2, as for all files that cannot be parsed"
    if rule.optional:
        yield "Needs", f"to be selected, as by --extend-select {rule.code}"
    if rule.whole_model:
        yield "Needs", "the whole model, so it is off with --partial"
    if rule.since:
        yield "Since", rule.since


def _needed_targets(rule: Rule) -> Iterator[tuple[str, str]]:
    if rule.targets:
        yield "Needs", " or ".join(f"--target {target}" for target in rule.targets)
    if rule.speaks_of == "chosen":
        yield "Needs", "a --target that departs from what is written; kinlint targets lists them"


def paragraphs(why: str) -> list[str]:
    """The paragraphs of a text, each on one line."""
    blocks = textwrap.dedent(why).strip().split("\n\n")
    return [" ".join(block.split()) for block in blocks if block.strip()]


def _cases(rule: Rule) -> Iterator[tuple[str, MarkedText]]:
    for example in rule.examples:
        beside = f" (beside it: {', '.join(example.beside)})" if example.beside else ""
        if example.bad is not None:
            yield f"Bad{beside}", parse_marks(example.bad, example.format)
        if example.good is not None:
            yield "Good", parse_marks(example.good, example.format)


def _ignoring(rule: Rule) -> list[str]:
    """Return the ways to ignore *rule*, by where they are written."""
    if rule.family == PROGRAMS:
        return []  # nothing turns off what the program would do wrong
    ways = [
        f"for one run: `--ignore {rule.code}`",
        f'for a project: `ignore = ["{rule.code}"]` in `kinlint.toml`',
    ]
    meant = [form for form in FORMATS if not rule.formats or form.name in rule.formats]
    if any(form.block_comment for form in meant):
        ways.append(
            f"for one element of XML: `<!-- kinlint: ignore[{rule.code}] -->` on the line before"
        )
    if any(form.line_comments for form in meant):
        ways.append(f"for one entry of YAML: `# kinlint: ignore[{rule.code}]` on the line before")
    if not all(form.block_comment or form.line_comments for form in meant):
        ways.append(
            f'for one node of a model: `"https://w3id.org/kinlint/ns#ignore": "{rule.code}"`'
        )
    return ways


def _example_object(example: Example) -> dict[str, Any]:
    bad = None if example.bad is None else parse_marks(example.bad, example.format)
    good = None if example.good is None else parse_marks(example.good, example.format)
    return {
        "format": example.format,
        "bad": bad and bad.text,
        "marks": [] if bad is None else bad.places(),
        "good": good and good.text,
        "beside": list(example.beside),
    }
