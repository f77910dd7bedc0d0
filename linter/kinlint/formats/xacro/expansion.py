"""Result of expanding a file: the robot, and remarks about the expansion."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from kinlint.formats.xacro.dom import Element
from kinlint.formats.xacro.expansion_error import Fault
from kinlint.formats.xacro.xacro_parser import Parsed
from kinlint.text import SourceText, Span


@dataclass(frozen=True)
class Remark:
    """Warning of xacro: `message`, at `span` of `source`.

    `symbol` is the name of xacro's own that was redefined, if it is about that.
    """

    message: str
    source: SourceText
    span: Span
    symbol: str = ""


@dataclass
class Expansion:
    """Expansion of a file: `parsed` is the robot, unless there is a `fault`.

    `files` are the files before the expansion, the main one first. `includes` are the elements that
    had files included, each with one of them.
    """

    parsed: Parsed
    files: Mapping[int, Parsed]
    includes: list[tuple[Element, SourceText]] = field(default_factory=list)
    remarks: list[Remark] = field(default_factory=list)
    fault: Fault | None = None
