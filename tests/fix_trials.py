"""Tries the fixes for public robots: each alone in a scratch copy, and all safe ones together."""

from __future__ import annotations

import shutil
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import chain
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

import real_models
from consumers import Motion, Reading, reading
from data import locate_data
from real_robots import FORMATS, paired
from support.linting import book

from kinlint.configuration.settings import FileSettings, Settings
from kinlint.edits import Edit, applied
from kinlint.files.packages import Packages
from kinlint.finding import Finding, Fix
from kinlint.fixes.rounds import fix_in_rounds, lint_texts
from kinlint.formats.decoding import decode, encode
from kinlint.formats.dependencies.file_groups import group_sources
from kinlint.rule import Applicability
from kinlint.text import SourceText

TOGETHER = "all safe fixes together"
TOLERANCE = 1e-6
"""How far a safe fix may move or weigh a robot otherwise."""
STATED = {"FRM010": 1e-3}
"""How far those of a rule may that says so: 0.00005 rad, at the length of an arm."""
SHARES = 24
"""In how many parts the files of a format are looked at, each spread over all of them."""
Words = Sequence[tuple[str, str]]
"""Pairs of a consumer and what it says."""


class Trial(NamedTuple):
    """What consumers said of a fix, and `faults` in it. `level` is how far it may be trusted."""

    form: str
    file: str
    code: str
    level: str
    title: str
    said: Words
    faults: Sequence[str]


@dataclass
class Outcome:
    """What there is to mend in some files of a format: by the codes of rules.

    `findings` are pairs of a code and whether there is a fix, `refused` codes and reasons.
    """

    form: str
    files: int = 0
    findings: list[tuple[str, bool]] = field(default_factory=list)
    refused: list[tuple[str, str]] = field(default_factory=list)
    trials: list[Trial] = field(default_factory=list)

    def add(self, other: Outcome) -> None:
        """Take *other*, of the same format, in."""
        self.files += other.files
        self.findings += other.findings
        self.refused += other.refused
        self.trials += other.trials


class Share(NamedTuple):
    """Files of a format that say nothing of others, below `home`."""

    form: str
    home: Path
    sources: Sequence[SourceText]


def shares(form: str) -> list[Share]:
    """The files of *form* in shares."""
    if form == "jsonld":
        return list(_models())
    home = locate_data("robots")
    files = sorted(each for each in (home / form).rglob("*") if each.suffix in FORMATS[form])
    texts = [_text(each) for each in files]
    groups = list(group_sources(paired(texts, home) if form == "srdf" else texts))
    parts = (list(chain.from_iterable(groups[at::SHARES])) for at in range(SHARES))
    return [Share(form, home / form, part) for part in map(list, parts) if part]


def _models() -> Iterator[Share]:
    for name, below in real_models.MODELS.items():
        home = locate_data("comp-rob2b") / below
        files = real_models.members(home, home / f"{name}.json")
        sources = [decode(each.relative_to(home).as_posix(), each.read_bytes()) for each in files]
        yield Share("jsonld", home, sources)


def _text(path: Path) -> SourceText:
    return decode(str(path), path.read_bytes())


def tried(share: Share) -> Outcome:
    """What becomes of the fixes for *share*."""
    settings = Settings(default=FileSettings(packages=tuple(packages(share.home).items())))
    given = [each for each in share.sources if not each.companion]
    offers = lint_texts(share.sources, (), settings, book())
    report, outcome = offers.report, Outcome(share.form, len(given))
    outcome.findings = [(each.rule.code, bool(each.fixes)) for each in report.findings]
    outcome.refused = [(each.rule.code, why) for each, _, why in report.unfixed]
    with TemporaryDirectory(prefix="kinlint-fixes-") as directory:
        scratch = Scratch(share, Path(directory))
        for finding in report.findings:
            outcome.trials += [_alone(scratch, finding, each) for each in finding.fixes]
        outcome.trials += _together(scratch, settings)
    return outcome


def packages(home: Path) -> Mapping[str, Path]:
    """The ROS packages among the robots in *home*, whose manifests are not among them."""
    moveit = home / "moveit_resources"
    inside = {f"moveit_resources_{each.name}": each for each in moveit.glob("*/")}
    return {**{each.name: each for each in home.glob("*/")}, **inside}


class Scratch:
    """A copy of the files of a share, in which some of them are changed for a moment."""

    def __init__(self, share: Share, directory: Path) -> None:
        self.share, self._directory = share, directory
        self._packages = Packages(environment={})
        self._before: dict[str, Reading] = {}
        if share.form == "xacro":
            shutil.copytree(share.home, directory, dirs_exist_ok=True)
            self._packages = Packages(packages(directory), environment={})

    def before(self, name: str) -> Reading:
        """What consumers make of a file as it is."""
        if name not in self._before:
            self._before[name] = self._read(name, self.data(name))
        return self._before[name]

    def data(self, name: str) -> bytes:
        """The bytes of a file as it is."""
        return (self.share.home / name).read_bytes()

    def judge(
        self, changed: Mapping[str, bytes], read: Iterable[str], most: float | None
    ) -> Iterator[tuple[str, Words, list[str]]]:
        """What consumers say of each file to *read*, while some are *changed*, and what is wrong.

        None may move the robot by more than *most*, where that is given.
        """
        before = {name: self.before(name) for name in read}
        for name, data in changed.items():
            self._write(name, data)
        for name, old in before.items():
            new = self._read(name, changed.get(name) or self.data(name))
            words = [(consumer, _word(old[consumer], new[consumer])) for consumer in old]
            faults = (_faults(each, old[each], new[each], most) for each in old)
            yield name, words, list(chain.from_iterable(faults))
        for name in changed:
            self._write(name, self.data(name))

    def _read(self, name: str, data: bytes) -> Reading:
        path = self._write(name, data)
        return reading(self.share.form, path, self._packages)

    def _write(self, name: str, data: bytes) -> Path:
        below = Path(name).relative_to(self.share.home) if Path(name).is_absolute() else name
        path = self._directory / below
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)
        return path


def _word(old: Motion | bool, new: Motion | bool) -> str:  # noqa: FBT001
    if not old:
        return "read now" if new else "refused as before"
    return "read as before" if new else "refused now"


def _faults(
    consumer: str,
    old: Motion | bool,  # noqa: FBT001
    new: Motion | bool,  # noqa: FBT001
    most: float | None,
) -> Iterator[str]:
    if old and not new:
        yield f"{consumer} refuses what it read"
    if most is not None and isinstance(old, Motion) and isinstance(new, Motion):
        apart = old.apart(new)
        if not apart <= most:
            yield f"{consumer} moves or weighs it otherwise, by {apart:.3g}"


def _alone(scratch: Scratch, finding: Finding, fix: Fix) -> Trial:
    changed, faults = {}, list[str]()
    for source in fix.sources:
        edits = [
            Edit(each.location.span, each.text)
            for each in fix.edits
            if each.location.source is source
        ]
        changed[source.name] = encode(replace(source, text=applied(source.text, edits)))
        if changed[source.name] != spliced(scratch.data(source.name), source, edits):
            faults.append("bytes outside of the edits changed")
    safe = fix.applicability is Applicability.SAFE
    most = STATED.get(finding.rule.code, TOLERANCE) if safe else None
    words: list[tuple[str, str]] = []
    for _, said, wrong in scratch.judge(changed, changed, most):
        words += said
        faults += wrong
    name = finding.location.source.name
    code, level = finding.rule.code, fix.applicability.label
    return Trial(scratch.share.form, name, code, level, fix.title, words, faults)


def spliced(data: bytes, source: SourceText, edits: Sequence[Edit]) -> bytes:
    """*data*, of which *source* was read, with the bytes that *edits* are about exchanged."""

    def offset(at: int) -> int:
        return len(encode(replace(source, text=source.text[:at])))

    pieces, at = [], 0
    for span, text in sorted(edits, key=lambda each: each.span):
        bare = encode(replace(source, text=text, bom=False))
        pieces += [data[at : offset(span.start)], bare]
        at = offset(span.end) if span.end else at
    return b"".join([*pieces, data[at:]])


def _together(scratch: Scratch, settings: Settings) -> Iterator[Trial]:
    """The trial of each file in which something is safe to mend, and of mending again.

    Files of xacro include others, so all of them are read again.
    """
    sources = scratch.share.sources
    made = fix_in_rounds(sources, (), settings, book(), Applicability.SAFE)
    texts = {before.name: encode(after) for before, after in made.changed}
    if not texts:
        return
    unsteady = _unsteady(made.texts, texts, settings) if texts.keys() <= _names(sources) else set()
    wrong = {name: list[str]() for name in {**texts, **dict.fromkeys(unsteady)}}
    for before, after in made.changed:
        if _by_rounds(scratch.data(before.name), before, made.report.fixed) != encode(after):
            wrong[before.name].append("bytes outside of the edits changed")
    for name in unsteady:
        wrong[name].append("mending again changes it again")
    read = _names(sources) if scratch.share.form == "xacro" else texts
    most = max(STATED.get(each.rule.code, TOLERANCE) for each in made.report.fixed)
    for name, words, faults in scratch.judge(texts, sorted(read), most):
        every = [*wrong.get(name, ()), *faults]
        yield Trial(scratch.share.form, name, TOGETHER, "safe", TOGETHER, words, every)


def _unsteady(texts: Sequence[SourceText], changed: Iterable[str], settings: Settings) -> set[str]:
    """The names of those of *texts* that change again; they are mended, and some are *changed*."""
    apart = not any(each.companion for each in texts)
    groups = list(group_sources(texts)) if apart else [list(texts)]
    touched = [each for each in groups if not _names(each).isdisjoint(changed)]
    every = list(chain.from_iterable(touched))
    again = fix_in_rounds(every, (), settings, book(), Applicability.SAFE)
    return {before.name for before, _ in again.changed}


def _names(sources: Iterable[SourceText]) -> set[str]:
    return {each.name for each in sources}


def _by_rounds(data: bytes, source: SourceText, fixed: Iterable[Finding]) -> bytes:
    """*data* with the edits of all of *fixed* in the file of *source*, round by round."""
    rounds: dict[str, tuple[SourceText, dict[Edit, None]]] = {}
    for finding in fixed:
        for each in finding.fixes[0].edits:
            text = each.location.source
            if text.name == source.name:
                _, edits = rounds.setdefault(text.text, (text, {}))
                edits[Edit(each.location.span, each.text)] = None
    for text, edits in rounds.values():
        data = spliced(data, text, list(edits))
    return data


def faults(every: Iterable[Outcome]) -> list[str]:
    """What is wrong with fixes, in a line each."""
    return [
        f"{each.code} in {each.file}, {each.level}: {each.title}: {fault}"
        for outcome in every
        for each in outcome.trials
        for fault in each.faults
    ]
