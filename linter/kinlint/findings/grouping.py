"""Groups of findings: by `kl:groupBy`, or of one text that is used often."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable

from kinlint.addresses import is_address, split
from kinlint.finding import Finding, Related
from kinlint.light_dataclasses import replace
from kinlint.message_template import VARIABLE, counted, filled

COUNT = "count"
"""The placeholder in the message of such a rule that says how many places there are."""

WHOLE_FILE = ("file",)
"""Groups that make one finding of all in a file, whatever each says."""


def grouped(
    findings: Iterable[Finding],
    detailed: Callable[[Finding], Finding] | None = None,
    reused: Collection[str] = (),
) -> list[Finding]:
    """Return *findings* with each group as one, which has the others as related.

    That is the worst (`Rule.worst`) of the most severe ones, the first by place of equals.

    A group lies in one model and is what one rule finds there with the same values of the variables
    that the rule groups by. Suppressed places make groups of their own. What is reported goes
    through *detailed*, if that is given; the others are spared.

    *reused* are the names of texts that may stand in a robot several times, such as macros: what a
    rule finds at one place of them is reported once, too.
    """
    groups: dict[tuple[object, ...], list[Finding]] = {}
    for finding in findings:
        groups.setdefault(_sameness(finding, reused), []).append(finding)
    tell = detailed or _brief
    told = [
        tell(group[0]) if len(group) == 1 else _merged(group, tell) for group in groups.values()
    ]
    return _once_each(told, reused) if reused else told


def _once_each(findings: Iterable[Finding], reused: Collection[str]) -> list[Finding]:
    """Return *findings* with all groups of one rule at one place of a reused text as one."""
    groups: dict[tuple[object, ...], list[Finding]] = {}
    for finding in findings:
        text = finding.location.source.name
        key: tuple[object, ...] = (id(finding),)
        if text in reused and finding.rule.group_by:
            key = finding.rule.code, finding.suppressed, *_text_place(finding)
        groups.setdefault(key, []).append(finding)
    return [group[0] if len(group) == 1 else _of_one_text(group) for group in groups.values()]


def _of_one_text(group: Collection[Finding]) -> Finding:
    first = min(group, key=lambda each: (each.sort_key, each.message))
    return replace(
        _used(first, len(group)),
        members=tuple(member for each in group for member in each.members or (each,)),
        consequences=tuple(one for each in group for one in each.consequences),
    )


def _used(finding: Finding, count: int) -> Finding:
    """Return *finding* with a word on how often its text is used."""
    said = f"{finding.message} This text is used {count} times."
    return replace(finding, message=said, template="")


def _brief(finding: Finding) -> Finding:
    return finding


def _sameness(finding: Finding, reused: Collection[str]) -> tuple[object, ...]:
    silence = finding.suppressed, finding.severity
    if by := finding.rule.group_by:
        # A constraint that lacks some of these variables groups by what it says instead.
        shared = by == WHOLE_FILE or len(finding.group) == len(by)
        said = "" if shared else finding.template
        return finding.rule.code, said, finding.group, finding.suppressed, model_of(finding)
    text = finding.location.source.name
    if text not in reused:
        return (id(finding),)
    return finding.rule.code, *silence, *_text_place(finding)


def _text_place(finding: Finding) -> tuple[object, ...]:
    """Return the place of *finding* in a text that may stand in several models."""
    return model_of(finding), finding.location.source.name, finding.location.span


def model_of(finding: Finding) -> str:
    """Return the model that *finding* is about: a document of several texts is one."""
    return split(finding.iri)[0] if is_address(finding.iri) else finding.location.source.name


def _merged(group: Iterable[Finding], detailed: Callable[[Finding], Finding]) -> Finding:
    members = sorted(group, key=lambda each: (-each.severity, -each.extent, each.sort_key))
    consequences = tuple(one for each in members for one in each.consequences)
    first, others = detailed(members[0]), members[1:]
    first = replace(first, members=tuple(members), consequences=consequences)
    count = 1 + len(others)
    if not first.rule.group_by:
        return _used(first, count)
    known = {first.location, *(related.location for related in first.related)}
    places = dict.fromkeys(other.location for other in others if other.location not in known)
    names = dict.fromkeys(match[3] for match in VARIABLE.finditer(first.template))
    shown = dict(zip(names, first.arguments, strict=False))
    if COUNT in shown:
        message = filled(first.template, shown := shown | {COUNT: str(count)})
    else:
        message = counted(first.message, count)
    return replace(
        first,
        message=message,
        arguments=tuple(shown.values()),
        related=(*first.related, *(Related(place, "") for place in places)),
    )
