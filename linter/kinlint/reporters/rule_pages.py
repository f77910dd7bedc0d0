"""All rules as Markdown: an index, and a section for each rule, on one page or one for a family."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path

from kinlint import resources
from kinlint.reporters.rule_fix_section import highest_applicability
from kinlint.reporters.rule_page import section, section_title
from kinlint.reporters.symptoms import symptom_table
from kinlint.rule import Rule

INTRODUCTION = """\
# The rules of kinlint

One Turtle file is one rule. It is a SHACL shape, and says in the same place what it finds and how
bad that is, why it matters, which anti-patterns (AP1 to AP6) it witnesses, and what a bad and a
good model look like. Carets show what is flagged in the bad one.

The index leads to the section of each rule. Index and sections are made from those files, by
`kinlint rule --all --output-directory rules`; `kinlint rule CODE` explains one rule.

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
_COLUMNS = ("Code", "Name", "Severity", "Anti-patterns", "Fix", "What it finds")


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
            ", ".join(rule.antipatterns),
            highest_applicability(rule),
            rule.title.replace("|", "\\|"),
        )
        rows.append(f"| {' | '.join(cells)} |")
    return "\n".join(rows) + "\n"
