"""Values that change where they stand: all of them, or some of their components."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence

from kinlint.edits import Edit, NotExpressible
from kinlint.formats.xml.editing.spelling import lexical_form, tokens, unescaped
from kinlint.formats.xml.value_reading import UNEXPANDED
from kinlint.light_dataclasses import dataclass
from kinlint.terms import Term, literal_value
from kinlint.text import Span

NOT_LITERAL = "the value is not written there literally"
EDGES = " \t\r\n\"'<>"
WORD = re.compile(r"\S+")
Values = Mapping[int, Term]
"""The components of a value by their numbers, or the whole as number 0."""


Place = Callable[[int], "Span | None"]


def merged_values(old: Values, removed: Values, added: Values, name: str) -> dict[int, Term]:
    """Return *old* without *removed*, and with *added*."""
    left = {number: value for number, value in old.items() if number not in removed}
    mixed = added and left and (0 in added) != (0 in left)
    if mixed or any(left.get(number, value) != value for number, value in added.items()):
        raise NotExpressible(f"there is another {name} already")
    new = {**left, **added}
    if new and sorted(new) not in ([0], list(range(1, len(new) + 1))):
        raise NotExpressible(f"{name} would have no {_missing(new)}. component")
    return new


def _missing(values: Values) -> int:
    return next(number for number in range(1, len(values) + 2) if number not in values)


def formatted_values(values: Values, kept: frozenset[str]) -> str:
    """Return *values* as plain text; those spelled as in *kept* keep their spelling."""
    text = " ".join(lexical_form(values[number], kept) for number in sorted(values))
    if UNEXPANDED.search(text):
        raise NotExpressible("xacro would take the value for an expression")
    return text


def current_text(values: Values) -> str:
    """Return *values* as the file spells them."""
    return " ".join(literal_value(values[number]) for number in sorted(values))


def matches(raw: str, values: Values) -> bool:
    """Tell whether *values* were read from *raw* of the XML text."""
    return tokens(unescaped(raw)) == tokens(current_text(values))


@dataclass(frozen=True)
class Rewriting:
    """Change of a value in `text` from `old` to `new`."""

    text: str
    """Text of the value."""
    old: Values
    """Values that it has."""
    new: Values
    """Values that it is to have."""
    kept: frozenset[str]
    """Spellings that stay."""
    write: Callable[[str], str]
    """Function that escapes text."""
    place: Place
    """Function that returns the place that a component was read from."""

    def edits(self, spans: Sequence[Span]) -> list[Edit]:
        """Return the edits of a value that stands literally at *spans*.

        Of components that stay, nothing is touched, nor is the space between.
        """
        if 0 in self.old or 0 in self.new:
            first, *rest = spans
            whole = self.write(formatted_values(self.new, self.kept))
            return [Edit(first, whole), *(Edit(each, "") for each in rest)]
        words = [Span(*m.span()) for each in spans for m in WORD.finditer(self.text, *each)]
        if len(words) != len(self.old):
            raise NotExpressible(NOT_LITERAL)
        edits = [Edit(words[number - 1], new) for number, new in self._changed()]
        common = min(len(self.old), len(self.new))
        end = words[common - 1].end
        if len(self.new) > common:
            more = range(common + 1, len(self.new) + 1)
            edits.append(
                Edit(Span(end, end), "".join(f" {self._component(each)}" for each in more))
            )
        elif len(self.old) > common:
            edits.append(Edit(Span(end, words[-1].end), ""))
        return edits

    def edits_of_parts(self) -> list[Edit]:
        """Return the edits of a value of which other components are expressions of xacro."""
        if 0 in self.old or self.old.keys() != self.new.keys():
            raise NotExpressible(NOT_LITERAL)
        edits = []
        for number, new in self._changed():
            span = self.place(number)
            if span is None or not self._is_component(span, self.old[number]):
                raise NotExpressible(NOT_LITERAL)
            edits.append(Edit(span, new))
        return edits

    def _is_component(self, span: Span, value: Term) -> bool:
        around = self.text[span.start - 1], self.text[span.end : span.end + 1]
        apart = all(each in EDGES for each in around)
        return apart and self.text[slice(*span)] == literal_value(value)

    def _changed(self) -> list[tuple[int, str]]:
        return [
            (number, self._component(number))
            for number in sorted(self.new)
            if number in self.old and self.new[number] != self.old[number]
        ]

    def _component(self, number: int) -> str:
        return self.write(formatted_values({0: self.new[number]}, self.kept))
