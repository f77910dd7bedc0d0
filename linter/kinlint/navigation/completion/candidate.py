"""Candidates of a completion."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from enum import Enum, auto
from typing import NamedTuple

from kinlint.light_dataclasses import dataclass
from kinlint.text import Span


class Kind(Enum):
    """Kind of a candidate."""

    NAME = auto()
    """Name of a link, a joint, a frame or another part of a robot."""
    ELEMENT = auto()
    """Tag of an element."""
    ATTRIBUTE = auto()
    """Name of an attribute, or key of an object."""
    WORD = auto()
    """One of the words that a value can be."""
    CLASS = auto()
    """Class of a metamodel."""
    UNIT = auto()
    """Unit, or kind of quantity."""
    VARIABLE = auto()
    """Property, parameter or argument of xacro."""
    FUNCTION = auto()
    """Macro of xacro, or function of its expressions."""
    FILE = auto()
    """File."""
    FOLDER = auto()
    """Directory, package or model."""
    RULE = auto()
    """Rule."""


class Candidate(NamedTuple):
    """Something that can be written."""

    label: str
    """Text that is shown, and written unless `text` is given."""
    kind: Kind
    """Kind of it."""
    detail: str = ""
    """Description in a few words."""
    rank: int = 1
    """Order among the candidates: those that are missing or fit best have the lowest."""
    text: str | None = None
    """Text to write in place of the label."""
    snippet: str | None = None
    """Text with `$1` and `$0` where the cursor goes, for editors that have snippets."""
    documentation: str = ""
    """More about it, in Markdown."""
    again: bool = False
    """True if what comes next can be completed as well, such as the rest of a path."""


@dataclass(frozen=True)
class Completions:
    """The candidates for a place."""

    candidates: Sequence[Candidate]
    """Candidates, best first."""
    span: Span
    """The text that they replace."""

    @classmethod
    def from_candidates(cls, found: Iterable[Candidate], span: Span) -> Completions:
        """Return the *found* candidates for *span* in their order, each label once."""
        every = sorted(found, key=lambda each: (each.rank, each.label.casefold(), each.label))
        best: dict[str, Candidate] = {}
        for each in every:
            best.setdefault(each.label, each)
        return cls(tuple(best.values()), span)


NOTHING = Completions((), Span(0, 0))
"""No candidate."""
