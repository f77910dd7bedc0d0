"""The formats of pictures by name; each writer is imported when it is asked for."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from importlib import import_module
from typing import Protocol, TypeAlias, cast

from kinlint.report import Report
from kinlint.reporters.picture.finding_badges import Marks, paired
from kinlint.reporters.terminal_style import Style
from kinlint.structure import Structure

Pairs: TypeAlias = Sequence[tuple[Structure, Marks]]
"""Robots, each with what is found of its parts."""

FORMATS: Mapping[str, str] = {"svg": "svg", "mermaid": "mermaid", "dot": "dot", "text": "text_tree"}
"""The module of each format."""
SUFFIXES: Mapping[str, str] = {
    "": "text",
    ".txt": "text",
    ".svg": "svg",
    ".mmd": "mermaid",
    ".mermaid": "mermaid",
    ".dot": "dot",
    ".gv": "dot",
}
"""The format that the end of the name of a file stands for."""


class Painter(Protocol):
    """A function that draws robots, piece by piece."""

    def __call__(self, pairs: Pairs, style: Style, *, frames: bool = False) -> Iterator[str]:
        """The pieces of the picture; joined they are complete."""
        ...


def pieces(report: Report, form: str, style: Style, *, frames: bool = False) -> Iterator[str]:
    """The robots of *report* as a picture in the format called *form*."""
    module = import_module(f"kinlint.reporters.picture.{FORMATS[form]}")
    pairs = list(paired(report.structures, report.findings))
    yield from cast("Painter", module.render)(pairs, style, frames=frames)
