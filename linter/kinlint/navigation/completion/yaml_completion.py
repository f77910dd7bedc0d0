"""Completion in YAML of ROS: joints, links and planning groups, by the key they are under."""

from __future__ import annotations

import re
from collections.abc import Iterator

from kinlint.addresses import document_iri
from kinlint.formats.yaml.ros_keys import (
    DISPLAYED,
    FRAME,
    GROUP,
    IN_RVIZ,
    JOINT,
    KINDS,
    LIMITS,
    LINK,
    PER_JOINT,
    POSITIONS,
)
from kinlint.navigation.completion import ignored_rules
from kinlint.navigation.completion.candidate import NOTHING, Candidate, Completions, Kind
from kinlint.navigation.completion.situation import Situation
from kinlint.text import Span
from kinlint.vocabulary import SRDF, URDF

TARGETS = {JOINT: (URDF, "joint"), LINK: (URDF, "link"), FRAME: (URDF, "link"),
           GROUP: (SRDF, "group")}  # fmt: skip
TABLES = {**dict.fromkeys((LIMITS, POSITIONS, *PER_JOINT), JOINT), DISPLAYED: LINK}
"""Kinds of what the keys of a table are names of, by the key of the table."""
_KEY = re.compile(r"[ \t]*(?:-[ \t]+)*[\"']?([\w. -]*?)[\"']?[ \t]*:(?:[ \t]+|$)")
_ITEM = re.compile(r"([ \t]*)((?:-[ \t]+)*)")
_COMMENT = re.compile(r"(?:^|[ \t])#")
_BEFORE, _BEHIND = re.compile(r"[\w./-]*\Z"), re.compile(r"[\w./-]*")
FARTHEST, LONGEST = 2_000, 1_000
"""Most lines that are looked back for the key of a list, and most letters of one."""


def complete(situation: Situation) -> Completions:
    """Return what can be written at the place of *situation*, in a file of YAML."""
    text, offset = situation.source.text, situation.offset
    start = max(text.rfind("\n", 0, offset), text.rfind("\r", 0, offset)) + 1
    if comment := _COMMENT.search(text, start, offset):
        return ignored_rules.in_comment(situation, Span(comment.end(), offset))
    kind = _kind(text, start, offset)
    if kind is None:
        return NOTHING
    before, behind = _BEFORE.search(text, start, offset), _BEHIND.match(text, offset)
    assert before is not None
    assert behind is not None
    return Completions.from_candidates(_names(situation, kind), Span(before.start(), behind.end()))


def _names(situation: Situation, kind: str) -> Iterator[Candidate]:
    pairing = situation.source.pairing
    named = () if pairing is None else (pairing.partner, *pairing.others, *pairing.annotations)
    homes = {document_iri(name) for name in named}
    for part in situation.names.outermost(*TARGETS[kind]):
        if not homes or part.document in homes:
            yield Candidate(part.name, Kind.NAME, part.tag)


def _kind(text: str, start: int, offset: int) -> str | None:
    """Return the kind of what is named at *offset*, on the line that begins at *start*."""
    line = text[max(start, offset - LONGEST) : offset]
    opened = line.rfind("[") > line.rfind("]")
    key = _KEY.match(line)
    if key and (opened or " " not in line[key.end() :].strip()):
        return _of_key(key[1])
    above = _above(text, start, line)
    if above is None:
        return None
    item = _ITEM.match(line)
    if opened or "," in line or (item and item[2]):
        return _of_key(above)
    return TABLES.get(above.rpartition(".")[2])


def _of_key(key: str) -> str | None:
    return KINDS.get(key.rpartition(".")[2]) or IN_RVIZ.get(key)


def _above(text: str, start: int, line: str) -> str | None:
    """Return the key of the list or table that the *line* at *start* belongs to."""
    here = _ITEM.match(line)
    assert here is not None
    indentation, is_item = len(here[1]), bool(here[2])
    for _ in range(FARTHEST):
        if start == 0:
            return None
        end = start - 1
        start = max(text.rfind("\n", 0, end), text.rfind("\r", 0, end)) + 1
        other = text[start : min(end, start + LONGEST)]
        if not other.strip() or other.lstrip().startswith("#"):
            continue
        key, item = _KEY.match(other), _ITEM.match(other)
        depth = len(item[1]) if item else 0
        unclosed = other.count("[") > other.count("]")
        if key and (unclosed or depth < indentation or (is_item and depth == indentation)):
            return key[1]
    return None
