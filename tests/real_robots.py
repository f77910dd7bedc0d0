"""What kinlint finds in public robots, rule by rule: `python tests/real_robots.py`.

Prints the section that is kept in rules/real-robots.md and stands in rules/README.md. The files
of a format are linted in one run, as those of a directory are.
"""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path
from statistics import median

from data import locate_data
from support.linting import book

from kinlint.configuration.settings import Settings
from kinlint.finding import Finding
from kinlint.formats.dependencies.companions import NONE
from kinlint.formats.registry import decode
from kinlint.parallel.runner import ParallelRunner
from kinlint.parallel.shard import Job
from kinlint.report import Report
from kinlint.rule import Rule, Severity
from kinlint.text import Pairing, SourceText

FORMATS = {
    "urdf": (".urdf",),
    "xacro": (".xacro",),
    "srdf": (".srdf",),
    "sdf": (".sdf", ".world"),
}
"""The formats of the robots in the data, with the suffixes of their files."""

OWN = {
    "srdf/moveit_resources/fanuc_moveit_config/config/fanuc.srdf": (
        "urdf/moveit_resources/fanuc_description/urdf/fanuc.urdf"
    )
}
"""The URDF of each SRDF whose own one is among the robots; the others are read without any."""
SUITES = (
    "kdl_parser/",
    "robot_state_publisher/",
    "sdformat/",
    "srdfdom/",
    "urdf-usd-converter/",
    "urdfdom/",
    "urdfdom_inline/",
    "xacro/",
)
"""The directories of input of tests, below that of a format: much of it is wrong on purpose."""
INTRODUCTION = """\
## In public robots

Number of files of each format in which a rule reports something. The files come from
example-robot-data, PyBullet, ROS-Industrial, MoveIt and franka_description, and from the
tests of urdfdom, kdl_parser, robot_state_publisher, urdf-usd-converter, srdfdom, xacro and
libsdformat, of which many are wrong on purpose. Their meshes and other
files that they name are absent.

| | {names} |
|---|{columns}|
| robots | {robots} |
| with an error | {wrong} |
| warnings in the median robot | {warnings} |
| test inputs | {inputs} |
| with an error | {errors} |

Made by `python tests/real_robots.py > rules/real-robots.md`; a test holds kinlint to it.
The fixes of these findings: [real-fixes.md](real-fixes.md).
"""


@cache
def report(form: str) -> Report:
    """What is found in the files of a format, named from the data's robots on."""
    root = locate_data("robots")
    files = sorted(each for each in (root / form).rglob("*") if each.suffix in FORMATS[form])
    sources = [decode(str(file), file.read_bytes()) for file in files]
    texts = paired(sources, root) if form == "srdf" else sources
    return ParallelRunner(Job(Settings(), book())).report(texts, ())


def paired(sources: Iterable[SourceText], root: Path) -> list[SourceText]:
    """Return *sources*, of files below *root*, in which each SRDF has its own URDF, with these.

    Names are those of files from *root* on, or absolute.
    """
    found = []
    for each in sources:
        name = str(each.name).removeprefix(f"{root}/")
        own = OWN.get(name)
        if own is None:
            found.append(replace(each, pairing=NONE))
            continue
        partner = each.name.removesuffix(name) + own
        text = decode(partner, (root / own).read_bytes())
        found.append(replace(each, pairing=Pairing(partner, "it is its own")))
        found.append(replace(text, companion=True))
    return found


def short(name: str) -> str:
    """The name of a file from the directory of its format on."""
    return Path(name).relative_to(locate_data("robots")).as_posix()


def is_robot(name: str) -> bool:
    """Whether a file describes a robot for its own sake, and not to test a reader with."""
    return not short(name).partition("/")[2].startswith(SUITES)


def files(form: str) -> list[str]:
    """The files of a format that were read."""
    return [name for name in report(form).files if short(name).startswith(f"{form}/")]


def findings(form: str) -> list[Finding]:
    """The findings in the files of a format."""
    return [each for each in report(form).findings if _home(each).startswith(f"{form}/")]


def _home(finding: Finding) -> str:
    return short(finding.location.source.name)


def with_error(form: str) -> set[str]:
    """The files of a format in which something is an error."""
    return {each.location.source.name for each in findings(form) if each.severity is Severity.ERROR}


def warnings(form: str) -> float:
    """How many warnings the median robot of a format has."""
    counts = Counter(
        each.location.source.name for each in findings(form) if each.severity is Severity.WARNING
    )
    return median([counts[name] for name in files(form) if is_robot(name)] or [0])


def page() -> Iterator[str]:
    """The section, line by line."""
    yield from _introduction().splitlines()
    yield ""
    yield f"| Rule | Severity | {' | '.join(FORMATS)} |"
    yield f"|---|---|{'---:|' * len(FORMATS)}"
    hits: Counter[tuple[str, str]] = Counter()
    rules: dict[str, Rule] = {}
    worst: dict[str, set[Severity]] = {}
    for form in FORMATS:
        every = findings(form)
        for code, _ in {(each.rule.code, each.location.source.name) for each in every}:
            hits[form, code] += 1
        for each in every:
            rules[each.rule.code] = each.rule
            worst.setdefault(each.rule.code, set()).add(each.severity)
    for code, rule in sorted(rules.items()):
        numbers = " | ".join(str(hits[form, code] or "") for form in FORMATS)
        levels = ", ".join(level.label for level in sorted(worst[code], reverse=True))
        yield f"| {code} {rule.name} | {levels} | {numbers} |"


def _introduction() -> str:
    rows: dict[str, list[str]] = {name: [] for name in ("robots", "wrong", "inputs", "errors")}
    for form in FORMATS:
        for names, which, errors in (
            ([name for name in files(form) if is_robot(name)], "robots", "wrong"),
            ([name for name in files(form) if not is_robot(name)], "inputs", "errors"),
        ):
            wrong = len(with_error(form).intersection(names))
            rows[which].append(str(len(names)))
            rows[errors].append(f"{wrong} ({wrong / len(names):.0%})" if names else "")
    return INTRODUCTION.format(
        names=" | ".join(FORMATS),
        columns="---:|" * (len(FORMATS) - 1) + "---:",
        warnings=" | ".join(f"{warnings(form):g}" for form in FORMATS),
        **{name: " | ".join(cells) for name, cells in rows.items()},
    )


if __name__ == "__main__":
    sys.stdout.writelines(f"{line}\n" for line in page())
