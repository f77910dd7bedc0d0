"""Hover text of elements and attributes: what the format means by them."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.file_format import Format
from kinlint.formats.xml.documentation import documentation
from kinlint.formats.xml.element_types import ElementType
from kinlint.formats.xml.schema import schema
from kinlint.formats.xml.unfinished_text import Cursor, Spot, TextElement, UnfinishedText
from kinlint.navigation.completion.element_place import types_of
from kinlint.text import SourceText


def meaning(source: SourceText, form: Format, offset: int) -> str:
    """Return what the element at *offset* of *source*, and its attribute there, mean; or nothing.

    The text is of the format *form*.
    """
    text = UnfinishedText(source.text)
    cursor = text.cursor(offset)
    element = _element(text, cursor)
    if element is None:
        return ""
    types = types_of(element, schema(form.lifted_as))
    if not types:
        return ""
    return "  \n".join(_lines(form, types[0], _attribute(source, cursor)))


def _element(text: UnfinishedText, cursor: Cursor) -> TextElement | None:
    """Return the element that *cursor* is in the tag or in the text of."""
    if cursor.element is not None:
        return cursor.element
    if cursor.spot is Spot.TAG:
        start = cursor.token.start - len("<")
        return next((each for each in text.elements if each.start == start), None)
    in_text = cursor.spot in (Spot.END_TAG, Spot.TEXT)
    return cursor.parent if in_text else None


def _attribute(source: SourceText, cursor: Cursor) -> str:
    if cursor.spot is not Spot.ATTRIBUTE:
        return cursor.attribute
    return source[cursor.token] + _rest(source.text, cursor.token.end)


def _rest(text: str, at: int) -> str:
    """Return the rest of the name that goes on *at*."""
    end = at
    while end < len(text) and (text[end].isalnum() or text[end] in "_-:"):
        end += 1
    return text[at:end]


def _lines(form: Format, type_: ElementType, attribute: str) -> Iterator[str]:
    known = documentation(form.lifted_as)
    if words := known.element(type_.tag):
        yield f"`<{type_.tag}>` {words}{_lifetime(type_)}"
    slot = type_.attributes.get(attribute)
    if slot is not None and (words := known.attribute(type_.tag, attribute)):
        needed = ", required" if attribute in type_.required else ""
        yield f"`{attribute}` {words} ({slot.reading.expected}{needed})"
    elif not attribute and (choices := type_.choices.get("") or type_.usual.get("")):
        yield f"one of {', '.join(f'`{each}`' for each in choices if each)}"


def _lifetime(type_: ElementType) -> str:
    """Return the versions that have an element, if not all have it."""
    lifetime = type_.lifetime
    if lifetime is None:
        return ""
    since = f"from {lifetime.since} on" if lifetime.since else ""
    until = f"until {lifetime.until}" if lifetime.until else ""
    return f" ({', '.join(filter(None, (since, until)))})"
