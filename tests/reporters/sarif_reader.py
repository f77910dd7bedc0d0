"""A reader of SARIF that trusts nothing: what a log says of its texts, worked out anew."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import pairwise
from typing import Any
from urllib.parse import unquote

from kinlint.text import SourceText

LINE_END = re.compile("\r\n|\n|\r")
INDENTATION = re.compile(
    "[\t\n\v\f\r \xa0\u1680\u2000-\u200a\u2028\u2029\u202f\u205f\u3000\ufeff]*"
)
"""What JavaScript's `\\s*` matches."""
LINK = re.compile(r"(?<!\\)(?:\\\\)*\[(?:\\.|[^\[\]\\])*\]\((\d+)\)")


def results(log: dict[str, Any]) -> list[dict[str, Any]]:
    (run,) = log["runs"]
    found: list[dict[str, Any]] = run["results"]
    return found


def rules(log: dict[str, Any]) -> list[dict[str, Any]]:
    descriptors: list[dict[str, Any]] = log["runs"][0]["tool"]["driver"]["rules"]
    return descriptors


def objects(value: Any) -> Iterator[dict[str, Any]]:
    """Every object inside *value*."""
    if isinstance(value, dict):
        yield value
        for inner in value.values():
            yield from objects(inner)
    elif isinstance(value, list):
        for inner in value:
            yield from objects(inner)


def places(value: Any) -> Iterator[dict[str, Any]]:
    """Every `physicalLocation` with a region inside *value*."""
    for one in objects(value):
        physical = one.get("physicalLocation")
        if physical is not None and "region" in physical:
            yield physical


def units(text: str) -> bytes:
    return text.encode("utf-16-le", "surrogatepass")


def by_offset(source: SourceText, region: dict[str, Any]) -> str:
    start = 2 * region["charOffset"]
    part = units(source.text)[start : start + 2 * region["charLength"]]
    return part.decode("utf-16-le", "surrogatepass")


def by_column(source: SourceText, region: dict[str, Any]) -> str:
    """The text between line and column, lines ending as `newlineSequences` says."""
    ends = [match.end() for match in re.finditer("\r\n|\n|\r", source.text)]
    starts = [len(units(source.text[:end])) // 2 for end in (0, *ends)]
    first = starts[region["startLine"] - 1] + region["startColumn"] - 1
    last = starts[region["endLine"] - 1] + region["endColumn"] - 1
    for line, column in (("startLine", "startColumn"), ("endLine", "endColumn")):
        following = [*starts[1:], len(units(source.text)) // 2 + 1][region[line] - 1]
        assert starts[region[line] - 1] + region[column] - 1 < following
    return units(source.text)[2 * first : 2 * last].decode("utf-16-le", "surrogatepass")


def filled(template: str, arguments: list[str]) -> str:
    return re.sub(
        r"\{\{|\}\}|\{(\d+)\}",
        lambda match: match[0][0] if match[1] is None else arguments[int(match[1])],
        template,
    )


def file_name(location: dict[str, str]) -> str:
    """The end of the path that an `artifactLocation` names."""
    return unquote(location["uri"])


def overlapping(replacements: list[dict[str, Any]]) -> bool:
    regions = [one["deletedRegion"] for one in replacements]
    spans = sorted((r["charOffset"], r["charOffset"] + r["charLength"]) for r in regions)
    return any(end > start for (_, end), (start, _) in pairwise(spans))


def by_specification(source: SourceText, change: dict[str, Any]) -> str:
    """The text after *change*, by offset and length in UTF-16 units (SARIF 2.1.0, 3.56, 3.57)."""
    pieces, at = [], 0
    for one in change["replacements"]:
        region = one["deletedRegion"]
        pieces += [units(source.text)[2 * at : 2 * region["charOffset"]]]
        pieces += [units(one["insertedContent"]["text"])]
        at = region["charOffset"] + region["charLength"]
    joined = b"".join([*pieces, units(source.text)[2 * at :]])
    return joined.decode("utf-16-le", "surrogatepass")


def by_viewer(source: SourceText, change: dict[str, Any]) -> str:
    """The text after *change* as the viewer of VS Code makes it.

    It goes by lines and columns, and begins no earlier than the first character of a line that is
    no blank.
    """
    lines = [units(line) for line in LINE_END.split(source.text)]
    ends = [0, *(len(units(source.text[: one.end()])) for one in LINE_END.finditer(source.text))]

    def offset(line: int, column: int) -> int:
        return ends[line] + 2 * min(column, len(lines[line]) // 2)

    pieces, at = [], 0
    for one in change["replacements"]:
        region = one["deletedRegion"]
        line = region["startLine"] - 1
        match = INDENTATION.match(lines[line].decode("utf-16-le", "surrogatepass"))
        assert match
        start = offset(line, max(match.end(), region["startColumn"] - 1))
        pieces += [units(source.text)[at:start], units(one["insertedContent"]["text"])]
        at = offset(region["endLine"] - 1, region["endColumn"] - 1)
    joined = b"".join([*pieces, units(source.text)[at:]])
    return joined.decode("utf-16-le", "surrogatepass")
