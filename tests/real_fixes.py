"""Trial of the fixes for public robots, rule by rule: `python tests/real_fixes.py`.

Prints the page that is kept in rules/real-fixes.md. Each fix that is offered is made in a scratch
copy, alone, and all safe ones of a file together; what natively reads the format says before and
after whether it accepts the file. Packages of the robots are at hand, other files are not.
"""

from __future__ import annotations

import os
import sys
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from concurrent.futures import ProcessPoolExecutor
from functools import cache

from fix_trials import TOGETHER, Outcome, Trial, faults, shares, tried
from real_robots import FORMATS
from support.linting import book

from kinlint.rule import Applicability

LEVELS = tuple(each.label for each in sorted(Applicability, reverse=True))
INTRODUCTION = """\
# Fixes in public robots

The fixes that kinlint offers for the robots of rules/real-robots.md and the models of
tests/real_models.md. Each fix is applied to a copy of its file, which consumers of the format then
read: check_urdf of urdfdom and Pinocchio read URDF and expanded xacro, PyLD reads JSON-LD. PyPI has
no reader of SDF and SRDF, so an XML parser reads these.

Of {findings} findings {mended} ({share:.0%}) have a fix. Of {fixes} fixes {safe} ({proved:.0%})
are safe. After {lost} of them a consumer refuses a file that it read before.

Made by `python tests/real_fixes.py > rules/real-fixes.md`.
"""


@cache
def outcomes() -> Mapping[str, Outcome]:
    """What becomes of all fixes, by format. Several processes share the work."""
    book()
    work = [each for form in ("jsonld", *FORMATS) for each in shares(form)]
    found = {form: Outcome(form) for form in ("jsonld", *FORMATS)}
    with ProcessPoolExecutor(os.cpu_count()) as pool:
        for outcome in pool.map(tried, work):
            found[outcome.form].add(outcome)
    return found


def page(found: Mapping[str, Outcome]) -> Iterator[str]:
    """The page of what was *found*, line by line."""
    every = Outcome("")
    for outcome in found.values():
        every.add(outcome)
    alone = [each for each in every.trials if each.code != TOGETHER]
    mends = sum(mends for _, mends in every.findings)
    safe = sum(each.level == "safe" for each in alone)
    lost = sum(any(word == "refused now" for _, word in each.said) for each in every.trials)
    yield from INTRODUCTION.format(
        findings=len(every.findings),
        mended=mends,
        share=mends / len(every.findings),
        fixes=len(alone),
        safe=safe,
        proved=safe / len(alone),
        lost=lost or "none",
    ).splitlines()
    columns = ("findings", "with a fix", *LEVELS, "refused")
    yield from ["", f"| | files | {' | '.join(columns)} | consumers, of each fix alone |"]
    yield f"|---|{'---:|' * (len(columns) + 1)}---|"
    for form, outcome in found.items():
        yield f"| {form} | {outcome.files} | {_row(outcome)} | {_consumers(outcome.trials)} |"
    yield from ["", f"| Rule | {' | '.join(columns)} | why most are refused | consumers |"]
    yield f"|---|{'---:|' * len(columns)}---|---|"
    rules = {rule.code: rule for rule in book().rules}
    for code in sorted({code for code, _ in every.findings if rules[code].repairs}):
        own = Outcome(
            "",
            findings=[each for each in every.findings if each[0] == code],
            refused=[each for each in every.refused if each[0] == code],
            trials=[each for each in alone if each.code == code],
        )
        reasons = Counter(why for _, why in own.refused)
        why = min(reasons, key=lambda each: (-reasons[each], each), default="")
        said = _said(own.trials)
        yield f"| {code} {rules[code].name} | {_row(own)} | {why} | {said} |"
    together = [each for each in every.trials if each.code == TOGETHER]
    yield from ["", f"{TOGETHER.capitalize()}, in {len(together)} files: {_said(together)}."]


def _row(outcome: Outcome) -> str:
    levels = Counter(each.level for each in outcome.trials if each.code != TOGETHER)
    numbers = [
        len(outcome.findings),
        sum(mends for _, mends in outcome.findings),
        *(levels[each] for each in LEVELS),
        len(outcome.refused),
    ]
    return " | ".join(str(number or "") for number in numbers)


def _consumers(trials: Iterable[Trial]) -> str:
    """What each consumer said."""
    said: dict[str, list[tuple[str, str]]] = {}
    for each in trials:
        for pair in each.said if each.code != TOGETHER else ():
            said.setdefault(pair[0], []).append(pair)
    return "; ".join(f"{name}: {_counted(pairs)}" for name, pairs in said.items())


def _said(trials: Iterable[Trial]) -> str:
    """What all consumers said."""
    return _counted(pair for each in trials for pair in each.said)


def _counted(pairs: Iterable[tuple[str, str]]) -> str:
    counts = Counter(word for _, word in pairs)
    return ", ".join(f"{number} {word}" for word, number in sorted(counts.items()))


if __name__ == "__main__":
    every = outcomes()
    sys.stdout.writelines(f"{line}\n" for line in page(every))
    sys.stderr.writelines(f"{line}\n" for line in faults(every.values()))
