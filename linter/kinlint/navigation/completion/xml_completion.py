"""Completion in files of elements: tags, attributes and values, by the schema of the format."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinlint.formats.xml.documentation import documentation
from kinlint.formats.xml.element_types import ElementType, Slot
from kinlint.formats.xml.schema import TEXT, schema
from kinlint.formats.xml.unfinished_text import Cursor, Spot, TextElement, UnfinishedText
from kinlint.navigation.completion import addressed_names, ignored_rules, xacro_completion
from kinlint.navigation.completion.candidate import NOTHING, Candidate, Completions, Kind
from kinlint.navigation.completion.element_place import holders, is_in_macro, siblings, types_of
from kinlint.navigation.completion.file_names import file_names
from kinlint.navigation.completion.referred_names import ReferredNames
from kinlint.navigation.completion.situation import Situation
from kinlint.terms import iri
from kinlint.text import Span
from kinlint.vocabulary import ATTRIBUTE

MISSING, USUAL, LATER, ELSEWHERE = 0, 1, 2, 5
TRUTHS = ("true", "false")


def complete(situation: Situation) -> Completions:
    """Return what can be written at the place of *situation*, in a file of elements."""
    return _Completion(situation).completions()


class _Completion:
    def __init__(self, situation: Situation) -> None:
        self.situation = situation
        document = situation.document
        form = situation.format if document is None else document.format
        self.table = schema(form.lifted_as)
        self.meaning = documentation(form.lifted_as)
        self.macros = situation.format.expands_to is not None
        self.text = UnfinishedText(situation.source.text)
        self.cursor = self.text.cursor(situation.offset)
        self.names = ReferredNames(situation, self.text, self.table)

    def completions(self) -> Completions:
        cursor, situation = self.cursor, self.situation
        if cursor.spot is Spot.COMMENT:
            return ignored_rules.in_comment(situation, cursor.token)
        written = situation.source.text[cursor.token.start : situation.offset]
        if self.macros and cursor.spot in (Spot.VALUE, Spot.TEXT):
            found = xacro_completion.in_expression(situation, self.text, cursor, written)
            if found is not None:
                return found
        if cursor.spot is Spot.TEXT:
            return self._content(written)
        find = {
            Spot.TAG: self._tags,
            Spot.END_TAG: self._end_tags,
            Spot.ATTRIBUTE: self._attributes,
            Spot.VALUE: self._values,
        }[cursor.spot]
        return Completions.from_candidates(find(cursor), cursor.token)

    def _tags(self, cursor: Cursor) -> Iterator[Candidate]:
        outer = holders(cursor.parent, self.table)
        if cursor.parent is None:
            yield from (self._tag(each, MISSING) for each in self.table.roots.values())
            return
        start = cursor.token.start - len("<")
        present = {each.tag for each in siblings(cursor.parent) if each.start != start}
        for type_ in outer:
            for tag, child in type_.children.items():
                if tag in type_.once and tag in present:
                    continue
                needed = tag in (*type_.requires, *type_.expects) and tag not in present
                yield self._tag(child, MISSING if needed else USUAL)
        if self.macros:
            yield from xacro_completion.tags(self.situation, self.text, cursor)
            if is_in_macro(cursor.parent):
                for types in self.table.types.values():
                    yield self._tag(types[0], ELSEWHERE)

    def _tag(self, type_: ElementType, rank: int) -> Candidate:
        end = self.cursor.token.end
        rest = self.situation.source.text[end : end + 1]
        snippet = _snippet(type_) if rest in ("", "\n", "\r", "<", " ", "\t") else None
        if rest in (" ", "\t") and self._is_continued(end):
            snippet = None
        return Candidate(
            type_.tag,
            Kind.ELEMENT,
            _needs(type_),
            rank,
            snippet=snippet,
            documentation=self.meaning.element(type_.tag),
        )

    def _is_continued(self, at: int) -> bool:
        """Tell whether the tag that ends *at* has attributes, or an end."""
        rest = self.situation.source.text[at:].lstrip(" \t")[:1]
        return rest not in ("", "\n", "\r", "<")

    def _end_tags(self, cursor: Cursor) -> Iterator[Candidate]:
        if cursor.parent is not None:
            closed = self.situation.source.text[cursor.token.end :].lstrip()[:1] == ">"
            text = cursor.parent.tag if closed else f"{cursor.parent.tag}>"
            yield Candidate(cursor.parent.tag, Kind.ELEMENT, "end tag", text=text)

    def _attributes(self, cursor: Cursor) -> Iterator[Candidate]:
        assert cursor.element is not None
        present = cursor.element.attributes.keys()
        if ":" in cursor.element.tag:
            if self.macros:
                yield from xacro_completion.attributes(self.situation, self.text, cursor.element)
            return
        for type_ in types_of(cursor.element, self.table):
            for name, slot in type_.attributes.items():
                if name in present:
                    continue
                needed = name in type_.required
                lifetime = type_.lifetimes.get(name)
                old = lifetime is not None and lifetime.until is not None
                rank = LATER if old else MISSING if needed else USUAL
                detail = f"{slot.reading.expected}{', required' if needed else ''}"
                yield Candidate(
                    name,
                    Kind.ATTRIBUTE,
                    detail,
                    rank,
                    f'{name}=""',
                    f'{name}="$1"',
                    self.meaning.attribute(type_.tag, name),
                    again=True,
                )

    def _values(self, cursor: Cursor) -> Iterator[Candidate]:
        assert cursor.element is not None
        if ":" in cursor.element.tag:
            if self.macros:
                yield from xacro_completion.values(self.situation, self.text, cursor)
            return
        for type_ in types_of(cursor.element, self.table):
            slot = type_.attributes.get(cursor.attribute)
            place = iri(ATTRIBUTE + cursor.attribute)
            yield from self._of_slot(type_, cursor.attribute, slot, place, cursor.element)

    def _content(self, written: str) -> Completions:
        """Return what the text of an element can be, if its format says so."""
        element, offset = self.cursor.parent, self.situation.offset
        if element is None or self.cursor.element is not None:
            return NOTHING
        start = offset - len(written.lstrip())
        rest = self.situation.source.text[offset:].partition("<")[0]
        word = rest.split("\n")[0].rstrip()
        end = offset + (len(word) if "\n" not in written else 0)
        found = (
            each
            for type_ in types_of(element, self.table)
            for each in self._of_slot(type_, "", type_.content, TEXT, element)
        )
        return Completions.from_candidates(found, Span(start, end))

    def _of_slot(
        self, type_: ElementType, name: str, slot: Slot | None, place: str, user: TextElement
    ) -> Iterator[Candidate]:
        """Yield what the attribute *name* of an element of *type_* can be, or its text ("")."""
        if (reference := type_.references.get(place)) is not None:
            yield from self.names.candidates(reference, user)
        if (address := type_.addresses.get(place)) is not None:
            yield from addressed_names.candidates(address, self.text.elements)
        for rank, word in enumerate(type_.choices.get(name, ()) or self._usual(type_, name)):
            yield Candidate(word, Kind.WORD, name, rank)
        if place in type_.files:
            written = self.situation.source.text[self.cursor.token.start : self.situation.offset]
            yield from file_names(self.situation, written.lstrip())
        if slot is not None and _is_truth(slot):
            yield from (Candidate(word, Kind.WORD, "truth value") for word in TRUTHS)

    def _usual(self, type_: ElementType, name: str) -> Sequence[str]:
        return type_.usual.get(name, ())


def _is_truth(slot: Slot) -> bool:
    return slot.reading[TRUTHS[0]] is not None and slot.reading["a word"] is None


def _needs(type_: ElementType) -> str:
    """Return what an element of *type_* has to have, in a few words."""
    needed = [*(f"{each}=" for each in type_.required), *(f"<{each}>" for each in type_.requires)]
    return f"needs {', '.join(needed)}" if needed else ""


def _snippet(type_: ElementType) -> str:
    """Return an element of *type_* with its required attributes, as a snippet."""
    given = "".join(f' {name}="${n}"' for n, name in enumerate(type_.required, 1))
    if not type_.children and type_.content is None and not type_.open:
        first = "" if given or not type_.attributes else " $1"
        return f"{type_.tag}{given}{first}/>$0"
    return f"{type_.tag}{given}>$0</{type_.tag}>"
