"""All rules as Markdown: an index, and a section for each rule, on one page or one for a family."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path

from kinlint import resources
from kinlint.reporters.antipatterns import ANTIPATTERNS
from kinlint.reporters.rule_fix_section import highest_applicability
from kinlint.reporters.rule_page import section, section_title
from kinlint.reporters.symptoms import symptom_table
from kinlint.rule import Rule

INTRODUCTION = """\
# The rules of kinlint

Each rule is one Turtle file: a SHACL shape with its severity, the reason why it matters, the
anti-patterns (AP1 to AP6) that it detects, and examples of bad and good models. Carets mark the
reported place in a bad example.

The index links to the section of each rule. The index and the sections are generated from the rule
files by `kinlint rule --all --output-directory rules`; `kinlint rule CODE` explains one rule.

Some rules have repairs, written as SPARQL Updates. The index shows the applicability of the best
one: `kinlint --fix` applies `safe` ones, `--unsafe-fixes` also `unsafe` ones.

Rules also run without kinlint, in any SHACL engine that supports SPARQL constraints, such as
pySHACL, together with the ontology and the units. From the top of this repository:

```sh
pyshacl -im -s rules/units/missing-unit.ttl -i owlrl \\
    model.ttl shapes/ontology/*.ttl shapes/units/*.ttl
```

The result has the node of each violation, but no place in the file. Rules about content that
JSON-LD drops find nothing there, since the graph no longer contains it.

To ignore a rule

- in one run: `--ignore CODE`
- in a project: `ignore = ["CODE"]` in `kinlint.toml`, or under `[tool.kinlint]` in `pyproject.toml`
- on one element of an XML file: `<!-- kinlint: ignore[CODE] -->` before it
- on one node of a model: `"https://w3id.org/kinlint/ns#ignore": "CODE"`

CODE may also be a name, the beginning of codes (`UNI`) or an anti-pattern (`AP3`).
"""
ANTIPATTERN_INTRODUCTION = """
## Anti-patterns

| | name | what it means |
|---|---|---|
"""
SYMPTOM_INTRODUCTION = """
## Symptoms

The symptoms of the anti-patterns in a model, and the rules that find them in each format. Symptoms
that are *inherent* in a format cannot be avoided by the author: `kinlint --profile` lists them.

"""
_COLUMNS = ("Code", "Name", "Severity", "Formats", "Anti-patterns", "Fix", "Title")


def catalogue(rules: Iterable[Rule]) -> Iterator[str]:
    """All *rules* on one page: how to read and run them, an index, and a section each.

    Links lead to files below the directory of the rules.
    """
    ordered = _ordered(rules)
    yield from _front(ordered, dict.fromkeys(_families(ordered), ""))
    for rule in ordered:
        yield f"\n{section(rule)}"


def pages(rules: Iterable[Rule]) -> Mapping[str, str]:
    """The page of *rules* and those of their families, by their paths in a directory of rules."""
    ordered = _ordered(rules)
    families = _families(ordered)
    files = {family: f"{family}/README.md" if family else "" for family in families}
    made = {files[family]: _page(family, families[family]) for family in families if family}
    here = "".join(f"\n{section(rule)}" for rule in families.get("", ()))
    return {"README.md": "".join(_front(ordered, files)) + here, **made}


def _front(rules: Sequence[Rule], files: Mapping[str, str]) -> Iterator[str]:
    """Yield the text before the sections, which are in the *files* of their families."""
    yield INTRODUCTION
    yield "\n## Index\n"
    for family, members in _families(rules).items():
        yield f"\n### {family or 'other'} ({_codes(members)})\n\n{_index(members, files[family])}"
    yield ANTIPATTERN_INTRODUCTION
    yield from (f"| {each.id} | {each.name} | {each.description} |\n" for each in ANTIPATTERNS)
    yield SYMPTOM_INTRODUCTION
    yield "\n".join(symptom_table(rules)) + "\n"
    robots = resources.data("rules") / "real-robots.md"
    if robots.is_file():
        yield "\n" + robots.read_text("utf-8")


def _page(family: str, rules: Sequence[Rule]) -> str:
    sections = "\n".join(section(rule, family) for rule in rules)
    return (
        f"# {family} ({_codes(rules)})\n\nMade from the rule files beside this page; "
        f"[all families](../README.md).\n\n{_index(rules)}\n{sections}"
    )


def _ordered(rules: Iterable[Rule]) -> list[Rule]:
    return sorted(rules, key=lambda rule: rule.code)


def _families(rules: Iterable[Rule]) -> Mapping[str, list[Rule]]:
    """*rules* by the folders that they lie in."""
    families: dict[str, list[Rule]] = {}
    for rule in rules:
        families.setdefault(Path(rule.path).parent.name, []).append(rule)
    return families


def _codes(rules: Iterable[Rule]) -> str:
    return ", ".join(sorted({rule.family for rule in rules}))


def _index(rules: Iterable[Rule], file: str = "") -> str:
    """A table of *rules*, with links to their sections in *file*, by default the same."""
    rows = [f"| {' | '.join(_COLUMNS)} |", "|---" * len(_COLUMNS) + "|"]
    for rule in rules:
        anchor = re.sub(r"[^\w -]", "", section_title(rule).lower()).replace(" ", "-")
        cells = (
            rule.code,
            f"[{rule.name}]({file}#{anchor})",
            rule.severity.label,
            ", ".join(rule.formats),
            ", ".join(rule.antipatterns),
            highest_applicability(rule),
            rule.title.replace("|", "\\|"),
        )
        rows.append(f"| {' | '.join(cells)} |")
    return "\n".join(rows) + "\n"
