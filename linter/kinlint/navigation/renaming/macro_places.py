"""Places of the names of macros and their parameters in calls, which no expansion shows."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from kinlint.formats.xml.unfinished_text import TextElement, UnfinishedText
from kinlint.navigation.occurrence import Entity
from kinlint.navigation.renaming.renaming_error import NotRenamable
from kinlint.navigation.xacro_names import PREFIX, label
from kinlint.text import Location, SourceText, Span

MACRO = "xacro:macro"
_FORWARDED = r"(?:^|\s)\*{{0,2}}{name}:?=\^"


def call_places(entity: Entity, sources: Iterable[SourceText]) -> Iterator[Location]:
    """Yield where calls repeat the name of *entity*: end tags of a macro, attributes of parameters.

    Raises `NotRenamable` for a parameter whose value comes from one of the same name outside.
    """
    known = label(entity)
    if known is None or known[0] not in ("macro", "parameter"):
        return
    kind, name = known
    texts = [(each, UnfinishedText(each.text)) for each in sources if MACRO[:6] in each.text]
    if kind == "macro":
        for source, text in texts:
            yield from _end_tags(source, text, name)
        return
    home, _, offset = entity.partition("@")[2].rpartition(":")
    macro = next(
        (
            element
            for source, text in texts
            if source.name == home
            for element in text.elements
            if element.tag == MACRO and element.start < int(offset) < element.content
        ),
        None,
    )
    if macro is None:
        return
    if re.search(_FORWARDED.format(name=re.escape(name)), macro.attributes.get("params", "")):
        raise NotRenamable(f"parameter '{name}' takes its value from a name outside of the macro")
    called = f"{PREFIX}{macro.attributes.get('name', '').removeprefix(PREFIX)}"
    for source, text in texts:
        for element in text.elements:
            if element.tag == called:
                yield from _attribute(source, element, name)


def _end_tags(source: SourceText, text: UnfinishedText, name: str) -> Iterator[Location]:
    tag = f"</{PREFIX}{name}"
    for element in text.elements:
        if element.tag == f"{PREFIX}{name}" and not element.is_open:
            start = source.text.rfind(tag, element.content, element.end)
            if start >= 0 and source.text[start + len(tag) : element.end].strip() == ">":
                at = start + len(tag) - len(name)
                yield Location(source, Span(at, at + len(name)))


def _attribute(source: SourceText, element: TextElement, name: str) -> Iterator[Location]:
    start = element.start + 1 + len(element.tag)
    for match in re.finditer(r"""([^\s=]+)\s*=\s*("[^"]*"|'[^']*')""", element.written):
        if match[1] == name:
            at = start + match.start(1)
            yield Location(source, Span(at, at + len(name)))
