"""What comes of expanding a file: the robot, and what there is to say on the way to it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from kinlint.formats.xacro.dom import Element
from kinlint.formats.xacro.expansion_error import Fault
from kinlint.formats.xacro.xacro_parser import Parsed
from kinlint.text import SourceText, Span


@dataclass(frozen=True)
class Remark:
    """What xacro warns of: `message`, at `span` of `source`.

    `symbol` is what was redefined of xacro's own names, if it is about that.
    """

    message: str
    source: SourceText
    span: Span
    symbol: str = ""


@dataclass
class Expansion:
    """What a file expands to: `parsed` is the robot, unless there is a `fault`.

    `files` are the files as they were before, the main one first. `includes` are the elements that
    had files included, each with one of them.
    """

    parsed: Parsed
    files: Mapping[int, Parsed]
    includes: list[tuple[Element, SourceText]] = field(default_factory=list)
    remarks: list[Remark] = field(default_factory=list)
    fault: Fault | None = None
