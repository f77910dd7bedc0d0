"""Changes of a start tag: its attributes, each written as its neighbours are."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from functools import partial
from itertools import groupby

from kinlint.edits import Edit, NotExpressible
from kinlint.formats.xml.editing import rewriting, spelling
from kinlint.formats.xml.editing.element_delta import Slots, ValueChange
from kinlint.formats.xml.editing.element_layout import Attribute, ElementLayout
from kinlint.light_dataclasses import dataclass
from kinlint.terms import Term
from kinlint.text import Span

NAME = re.compile(r"[^\W\d][\w.:-]*")
FIRST = "name"


def listed(slots: Slots, quote: str, layout: ElementLayout, kept: frozenset[str]) -> Iterator[str]:
    """Yield the attributes of a new element, as they are written."""
    for name, value in sorted(slots.items(), key=lambda each: each[0] != FIRST):
        if name:
            text = rewriting.formatted_values(rewriting.merged_values({}, {}, value, name), kept)
            yield assignment(name, text, quote, layout)


def assignment(name: str, value: str, quote: str, layout: ElementLayout) -> str:
    """Return an attribute as it is written."""
    if not NAME.fullmatch(name):
        raise NotExpressible(f"{name} is not a name in XML")
    return f"{name}={quote}{spelling.escaped_attribute(value, quote, layout.source)}{quote}"


@dataclass
class StartTag:
    """Start tag of an element."""

    layout: ElementLayout
    """Layout of the text."""
    number: int
    """Number of the element, in document order."""
    slots: Slots
    """Values of its attributes."""
    kept: frozenset[str]
    """Spellings that stay."""
    place: Callable[[str, int], Span | None]
    """Function that returns the place that a component of an attribute was read from."""

    def edits(self, change: ValueChange) -> Iterator[Edit]:
        """Yield the edits that make *change* of the attributes."""
        layout = self.layout
        self._all = layout.attributes(self.number)
        self._first = {each.name: each for each in reversed(self._all)}
        gone: list[str] = []
        come: dict[str, dict[int, Term]] = {}
        for name in (each for each in {**change.removed, **change.added} if each):
            old, removed = self.slots.get(name, {}), change.removed.get(name, {})
            new = rewriting.merged_values(old, removed, change.added.get(name, {}), name)
            if old and name not in self._first:
                raise NotExpressible(rewriting.NOT_LITERAL)
            literal = not old or rewriting.matches(layout.source[self._first[name].value], old)
            if old and new:
                yield from self._changed(name, new, literal=literal)
            elif not literal:
                raise NotExpressible(rewriting.NOT_LITERAL)
            elif old:
                gone.append(name)
            else:
                come[name] = new
        for name in [each for each in come if each in self._first]:
            raise NotExpressible(f"there is another {name} already")
        texts = {name: rewriting.formatted_values(new, self.kept) for name, new in come.items()}
        for old_name, new_name in list(self._pairs(gone, texts)):
            gone.remove(old_name)
            yield from self._renamed(old_name, new_name, texts.pop(new_name))
        yield from deletions(layout, self.number, lambda each: each.name in gone)
        yield from self._inserted(texts)

    def _write(self, attribute: Attribute, value: str) -> str:
        quote = self.layout.text[attribute.value.end]
        return spelling.escaped_attribute(value, quote, self.layout.source)

    def _changed(self, name: str, new: rewriting.Values, *, literal: bool) -> list[Edit]:
        attribute, old = self._first[name], self.slots[name]
        write, place = partial(self._write, attribute), partial(self.place, name)
        value = rewriting.Rewriting(self.layout.text, old, new, self.kept, write, place)
        if not literal:
            return value.edits_of_parts()
        is_string = old.get(0, "").endswith('"')
        span = attribute.value
        return value.edits([span if is_string else self.layout.places.stripped(span)])

    def _pairs(self, gone: list[str], come: dict[str, str]) -> Iterator[tuple[str, str]]:
        """Yield each old attribute with its replacement: the one of the same value, or the next."""
        left, free = list(come), list(gone)
        for name in gone:
            said = spelling.tokens(rewriting.current_text(self.slots[name]))
            same = next((each for each in left if spelling.tokens(come[each]) == said), None)
            if same is not None:
                left.remove(same)
                free.remove(name)
                yield name, same
        yield from zip(free, left, strict=False)

    def _renamed(self, old: str, new: str, value: str) -> Iterator[Edit]:
        attribute = self._first[old]
        if not NAME.fullmatch(new):
            raise NotExpressible(f"{new} is not a name in XML")
        self._once(old)
        yield Edit(attribute.key, new)
        if spelling.tokens(rewriting.current_text(self.slots[old])) != spelling.tokens(value):
            yield Edit(attribute.value, self._write(attribute, value))

    def _once(self, name: str) -> None:
        if sum(1 for each in self._all if each.name == name) > 1:
            raise NotExpressible(f"{name} is given twice")

    def _inserted(self, texts: dict[str, str]) -> Iterator[Edit]:
        """Put attributes behind the last one, or a name before the first."""
        layout, tag = self.layout, self.layout.tag(self.number)
        quote = layout.quote(self.number)
        space, end = " ", tag.name.end
        if self._all:
            last = self._all[-1]
            before = self._all[-2].end if len(self._all) > 1 else tag.name.end
            space, end = layout.text[before : last.key.start] or " ", last.end
        first = [each for each in texts if each == FIRST and self._all]
        for name in first:
            at = self._all[0].key.start
            written = assignment(name, texts.pop(name), quote, layout)
            yield Edit(Span(at, at), f"{written}{space}")
        if texts:
            more = (assignment(name, text, quote, layout) for name, text in texts.items())
            yield Edit(Span(end, end), "".join(f"{space}{each}" for each in more))


def deletions(
    layout: ElementLayout, number: int, leaves: Callable[[Attribute], bool]
) -> Iterator[Edit]:
    """Yield edits that delete attributes with the space before them, or behind the first ones."""
    text, written = layout.text, layout.attributes(number)
    behind, following = layout.tag(number).name.end, 0
    for gone, group in groupby(written, leaves):
        run = list(group)
        following += len(run)
        start, end = run[0].key.start, run[-1].end
        if gone:
            left = written[following].key.start if following < len(written) else end
            if left > end and _breaks(text[end:left]) and not _breaks(text[behind:start]):
                yield Edit(Span(start, left), "")
            else:
                glued = following < len(written) and left == end
                yield Edit(Span(start if glued else behind, end), "")
        behind = end


def _breaks(space: str) -> bool:
    return "\n" in space or "\r" in space
