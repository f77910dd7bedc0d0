"""What kinlint finds in the published models, rule by rule: `python tests/real_models.py`.

Prints the page that is kept in tests/real_models.md. A model is linted as a whole, because its
files refer to each other.
"""

from __future__ import annotations

import json
import sys
from collections import Counter, defaultdict
from collections.abc import Iterator
from itertools import groupby
from pathlib import Path

from data import locate_data
from support.linting import lint

from kinlint.finding import Finding

MODELS = {
    "tutorial": "modelling-tutorial/models",
    "Kinova": "robot-models",
    "sc1": "motion-spec-ral/models",
    "sc2": "motion-spec-ral/models",
}
"""Where each model is. Of motion-spec-ral, a model is what a file of its name imports."""

INTRODUCTION = """\
# What kinlint finds in the published models

Made by `python tests/real_models.py > tests/real_models.md`; a test holds kinlint to it. Each
finding was looked at and is a fault, or a choice that the rule's page calls one.

"""


def findings(name: str) -> tuple[Finding, ...]:
    """All findings in a model of `MODELS`, named by files below its directory."""
    root = locate_data() / "comp-rob2b" / MODELS[name]
    files = list(members(root, root / f"{name}.json"))
    return lint({each.relative_to(root).as_posix(): each.read_bytes() for each in files}).findings


def members(root: Path, manifest: Path) -> Iterator[Path]:
    """The files of a model: those that *manifest* imports, with itself, or all below *root*."""
    if not manifest.exists():
        yield from sorted(root.rglob("*.json"))
        return
    yield manifest
    (listed,) = json.loads(manifest.read_text("utf-8"))["@graph"]
    yield from sorted({root / each for each in listed["import"]})


def page() -> Iterator[str]:
    """The page, line by line."""
    found = {name: findings(name) for name in MODELS}
    yield from INTRODUCTION.splitlines()
    yield f"| Rule | Severity | {' | '.join(MODELS)} |"
    yield f"|---|---|{'---:|' * len(MODELS)}"
    counts = {name: Counter(each.rule.code for each in found[name]) for name in MODELS}
    rules = {each.rule.code: each.rule for every in found.values() for each in every}
    for code, rule in sorted(rules.items()):
        numbers = " | ".join(str(counts[name][code] or "") for name in MODELS)
        yield f"| {code} {rule.name} | {rule.severity.label} | {numbers} |"
    for name, every in found.items():
        yield from ["", f"## {name}: {MODELS[name]}", ""]
        yield from places(every)


def places(every: tuple[Finding, ...]) -> Iterator[str]:
    """The lines of each file at which each rule speaks."""
    by_file: dict[str, list[Finding]] = defaultdict(list)
    for each in every:
        by_file[each.location.source.name].append(each)
    for file, here in sorted(by_file.items()):
        yield f"- `{file}`"
        ordered = sorted(here, key=lambda one: (one.rule.code, one.location.start.line))
        for code, group in groupby(ordered, key=lambda one: one.rule.code):
            lines = Counter(one.location.start.line for one in group)
            shown = (f"{line}" if n == 1 else f"{line} (x{n})" for line, n in lines.items())
            yield f"  - {code}: {', '.join(shown)}"


if __name__ == "__main__":
    sys.stdout.writelines(f"{line}\n" for line in page())
