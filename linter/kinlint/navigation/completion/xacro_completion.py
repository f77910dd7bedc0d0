"""Completion of what xacro adds to a format: its elements, macros, and names in expressions."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from typing import NamedTuple

from kinlint.formats.xacro.definitions import OWN
from kinlint.formats.xacro.expression_symbols import PLAIN
from kinlint.formats.xml.unfinished_text import Cursor, TextElement, UnfinishedText
from kinlint.navigation.completion.candidate import Candidate, Completions, Kind
from kinlint.navigation.completion.file_names import entries, file_names, packages
from kinlint.navigation.completion.situation import Situation
from kinlint.navigation.xacro_names import DEFINED_BY, PREFIX
from kinlint.text import Span

MACRO = "xacro:macro"
ATTRIBUTES = {
    "xacro:arg": ("name", "default"),
    "xacro:property": ("name", "value", "default", "scope"),
    "xacro:macro": ("name", "params"),
    "xacro:include": ("filename", "ns"),
    "xacro:if": ("value",),
    "xacro:unless": ("value",),
    "xacro:insert_block": ("name",),
    "xacro:element": ("xacro:name",),
    "xacro:attribute": ("name", "value"),
    "xacro:call": ("macro",),
}
SCOPES = ("parent", "global")
SUBSTITUTIONS = ("find", "arg", "env", "optenv", "eval", "cwd", "dirname")
"""The words that `$(` begins with (https://github.com/ros/xacro/wiki)."""
FUNCTIONS = sorted({*PLAIN, *(each for each in vars(math) if not each.startswith("_"))} - {"e"})
"""The functions and constants that expressions know."""
_OPEN = re.compile(r"\$\{(?P<expression>[^{}]*)\Z|\$\((?P<substitution>[^()]*)\Z")
_FIND = re.compile(r"\$\(find ([^)\s]+)\)/")
_NAME = re.compile(r"[^\W\d]\w*\Z")
_REST = re.compile(r"\w*")
_PARAMETER = re.compile(r"(?:^|(?<=\s))([*]{0,2})([^\W\d]\w*)(?::?=(\S*))?")


class Definition(NamedTuple):
    """Something that a file of macros defines."""

    kind: str
    """`macro`, `property` or `argument`."""
    name: str
    """Its name."""
    value: str
    """Its value, default or parameters as they are written."""
    element: TextElement
    """Element that defines it."""


def in_expression(
    situation: Situation, text: UnfinishedText, cursor: Cursor, written: str
) -> Completions | None:
    """Return the names for an expression that *written*, before the cursor, has open, if any."""
    match = _OPEN.search(written)
    if match is None:
        return None
    offset = situation.offset
    if (inside := match["substitution"]) is not None:
        start = offset - len(inside)
        command, space, rest = inside.partition(" ")
        found = _substitutions(situation, text, command, known=bool(space))
        return Completions.from_candidates(
            found, _word(situation, start if not space else offset - len(rest.lstrip()))
        )
    name = _NAME.search(match["expression"])
    start = offset - (len(name[0]) if name else 0)
    before = match["expression"][: len(match["expression"]) - (offset - start)]
    if before.count("'") % 2 or before.rstrip().endswith("."):
        return Completions.from_candidates((), Span(start, offset))
    found = _expression(situation, text, cursor)
    return Completions.from_candidates(found, _word(situation, start))


def tags(situation: Situation, text: UnfinishedText, cursor: Cursor) -> Iterator[Candidate]:
    """Yield the elements of xacro itself, and the macros as elements that call them."""
    written = situation.source.text[cursor.token.start : situation.offset]
    for tag in sorted(OWN):
        yield Candidate(tag, Kind.ELEMENT, "xacro", 3)
    for each in _definitions(situation, text):
        if each.kind == "macro":
            plain = [
                name for name, stars, default in _parameters(each.value) if not (stars or default)
            ]
            given = "".join(f' {name}="${n}"' for n, name in enumerate(plain, 1))
            blocks = any(stars for _, stars, _ in _parameters(each.value))
            tag = f"{PREFIX}{each.name}"
            end = f">$0</{tag}>" if blocks else "/>$0"
            rank = 1 if written.startswith(PREFIX[:1]) else 2
            yield Candidate(
                tag, Kind.FUNCTION, f"macro {each.value}", rank, snippet=f"{tag}{given}{end}"
            )


def attributes(
    situation: Situation, text: UnfinishedText, element: TextElement
) -> Iterator[Candidate]:
    """Yield the attributes that *element* of xacro, or a call of a macro, does not have yet."""
    present = element.attributes.keys()
    names = [(name, "") for name in ATTRIBUTES.get(element.tag, ())]
    for each in _definitions(situation, text):
        if each.kind == "macro" and element.tag == f"{PREFIX}{each.name}":
            names += [
                (name, default) for name, stars, default in _parameters(each.value) if not stars
            ]
    for name, default in names:
        if name not in present:
            detail = f"default {default}" if default else "required"
            rank = 1 if default else 0
            yield Candidate(
                name, Kind.ATTRIBUTE, detail, rank, f'{name}=""', f'{name}="$1"', again=True
            )


def values(situation: Situation, text: UnfinishedText, cursor: Cursor) -> Iterator[Candidate]:
    """Yield what an attribute of an element of xacro can be."""
    element = cursor.element
    assert element is not None
    place = element.tag, cursor.attribute
    if place == ("xacro:include", "filename"):
        yield from _included(situation, cursor)
    elif place == ("xacro:property", "scope"):
        yield from (Candidate(word, Kind.WORD) for word in SCOPES)
    elif place == ("xacro:insert_block", "name"):
        for name, stars, _ in _in_scope(element):
            if stars:
                yield Candidate(name, Kind.VARIABLE, "block of the macro")
    elif place == ("xacro:call", "macro"):
        for each in _definitions(situation, text):
            if each.kind == "macro":
                yield Candidate(each.name, Kind.FUNCTION, f"macro {each.value}")


def _included(situation: Situation, cursor: Cursor) -> Iterator[Candidate]:
    """Yield the next step of the name of a file that is included."""
    written = situation.source.text[cursor.token.start : situation.offset]
    found = _FIND.match(written)
    if found is None:
        yield from packages(situation, "$(find ", ")/")
        yield from (each for each in file_names(situation, written) if "://" not in each.label)
        return
    home = situation.packages.find(found[1], situation.directory)
    folder = written[found.end() :].rpartition("/")[0]
    if home is not None:
        yield from entries(home / folder, f"{found[0]}{folder}{'/' if folder else ''}")


def _in_scope(element: TextElement) -> Iterator[tuple[str, str, str]]:
    """Yield the parameters of the macros around *element*, or that it is."""
    for each in (element, *element.ancestors):
        if each.tag == MACRO:
            yield from _parameters(each.attributes.get("params", ""))


def _substitutions(
    situation: Situation, text: UnfinishedText, command: str, *, known: bool
) -> Iterator[Candidate]:
    """Yield the commands of `$(…)`, or if the *command* is *known*, what comes behind it."""
    if not known:
        yield from (Candidate(each, Kind.WORD, again=True) for each in SUBSTITUTIONS)
    elif command == "find":
        yield from packages(situation, "", "")
    elif command in ("arg", "eval"):
        for each in _definitions(situation, text):
            if each.kind == "argument":
                yield Candidate(each.name, Kind.VARIABLE, f"argument {each.value}".rstrip())


def _expression(situation: Situation, text: UnfinishedText, cursor: Cursor) -> Iterator[Candidate]:
    """Yield what is known in an expression: parameters first, then properties and functions."""
    user = cursor.element or cursor.parent
    around = [] if user is None else [user, *user.ancestors]
    for name, stars, default in () if user is None else _in_scope(user):
        if not stars:
            detail = f"parameter, default {default}" if default else "parameter"
            yield Candidate(name, Kind.VARIABLE, detail, 0)
    for each in _definitions(situation, text):
        home = next((one for one in each.element.ancestors if one.tag == MACRO), None)
        if each.kind == "property" and (home is None or home in around):
            yield Candidate(each.name, Kind.VARIABLE, f"property {each.value}".rstrip(), 1)
    yield from (Candidate(name, Kind.FUNCTION, rank=3) for name in FUNCTIONS)


def _definitions(situation: Situation, text: UnfinishedText) -> Iterator[Definition]:
    """Yield what the text defines, and what the other files do that it was expanded with last."""
    texts = [text]
    if situation.document is not None:
        others = (each for each in situation.document.sources if "xacro" in each.text)
        texts += [UnfinishedText(one.text) for one in others if one.name != situation.source.name]
    for each in texts:
        for element in each.elements:
            kind, name = DEFINED_BY.get(element.tag), element.attributes.get("name", "")
            if kind is not None and name and "$" not in name:
                given = element.attributes
                value = given.get("params") or given.get("value") or given.get("default") or ""
                yield Definition(kind, name.removeprefix(PREFIX), value, element)


def _parameters(written: str) -> list[tuple[str, str, str]]:
    """Return the parameters of a macro: the name, the stars of a block, and the default."""
    return [(match[2], match[1], match[3] or "") for match in _PARAMETER.finditer(written)]


def _word(situation: Situation, start: int) -> Span:
    rest = _REST.match(situation.source.text, situation.offset)
    return Span(start, rest.end() if rest else situation.offset)
