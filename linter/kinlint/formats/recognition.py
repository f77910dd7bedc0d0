"""Tells the format of a file, by the end of its name or else by its content."""

from __future__ import annotations

import re

from kinlint.file_format import Format
from kinlint.formats.records import BY_NAME, FORMATS, JSON, TREES, by_suffix
from kinlint.light_dataclasses import replace
from kinlint.text import SourceText

JSONLD, TURTLE, NQUADS = BY_NAME["jsonld"], BY_NAME["turtle"], BY_NAME["nquads"]
YAML, USD = BY_NAME["yaml"], BY_NAME["usd"]
HEAD = 1024
LAYER = "#usda "
"""Beginning of a text layer of USD."""
KEYWORDS = frozenset({'"@context"', '"@graph"', '"@id"', '"@type"'})
"""Keys by which JSON is JSON-LD."""
XML_SUFFIXES = tuple(suffix for each in TREES if each.fence == "xml" for suffix in each.suffixes)

_TOKEN = re.compile(r'("(?:[^"\\]|\\(?s:.))*+(?:"|\Z)|[\[\]{}]|[^\s",:\[\]{}]+)')
_VALUE = re.compile(r'[ \t\r\n]*:[ \t\r\n]*["\[{]')
_TURTLE = re.compile(r"(?im)^[ \t]*(?:@(?:prefix|base)[ \t]|(?:prefix|base)[ \t]+[\w.-]*:?[ \t]*<)")
_STATEMENT = re.compile(r"(?m)^[ \t]*(?:<[^<>\s]*>|_:\S+)[ \t]+<[^<>\s]*>[ \t]+[<\"_].*\.[ \t]*$")


def with_format(source: SourceText) -> SourceText:
    """Return *source* with its format: the same object if it has one already."""
    if source.format is not None:
        return source
    form = recognise(source.name, source.text)
    return source if form is None else replace(source, format=form)


def with_text(source: SourceText, text: str, *, bom: bool | None = None) -> SourceText:
    """Return the file of *source* with another *text*, whose format is recognised again."""
    bom = source.bom if bom is None else bom
    return with_format(replace(source, text=text, bom=bom, format=None))


def recognise(name: str, text: str) -> Format | None:
    """Return the format of a file, None if it is unknown.

    JSON is JSON-LD if there is a keyword of it at its top or in an element of a top-level array.
    """
    by_name = by_suffix(name)
    if by_name is not None and by_name.fence != "xml":
        return by_name
    head = text.lstrip()[:1]
    if head in ("{", "["):
        return JSONLD if _has_keyword(text) else None
    if name.lower().endswith(JSON):
        return None
    return _tree(name, text) or _by_lines(name, text)


def _by_lines(name: str, text: str) -> Format | None:
    """Return the format of *text*, which is neither JSON nor XML, by how its lines begin."""
    if text.startswith(LAYER):
        return USD
    if _TURTLE.search(text):
        return TURTLE
    if _STATEMENT.search(text):
        return NQUADS
    return YAML if "." not in name.rpartition("/")[2] and _is_configuration(text) else None


def _is_configuration(text: str) -> bool:
    """Tell whether *text*, in a file whose name tells nothing, is YAML that names robots' parts."""
    from kinlint.formats.yaml.ros_keys import NAMING  # noqa: PLC0415  few files have such names

    return NAMING.search(text.encode("utf-8", "replace")) is not None


def objection() -> str:
    """Say why a text, which is in no known format, is not read."""
    return f"kinlint reads {supported_formats()}"


def supported_formats() -> str:
    """Return the titles of all formats with the ends of the names of their files."""
    titles: dict[str, list[str]] = {}
    for each in FORMATS:
        titles.setdefault(each.lifted_as, []).extend(each.suffixes)
        if each == JSONLD:
            titles[each.name].append(f"{JSON} with an @context")
    return ", ".join(
        f"{each.title} ({', '.join(titles[each.name])})" for each in FORMATS if each.name in titles
    )


def _begins_with_tag(text: str) -> bool:
    head = text[:HEAD].lstrip()
    if head[:1] == "<" or "<" not in head:
        return head[:1] == "<"
    from kinlint.formats.xml.tag_scanner import LOST  # noqa: PLC0415  few files are XML

    return LOST.match(head) is not None


def _tree(name: str, text: str) -> Format | None:
    """Return the format of a robot in XML, by its root element or the end of its name."""
    if not _begins_with_tag(text) and not name.lower().endswith(XML_SUFFIXES):
        return None
    from kinlint.formats.xml.xml_recognition import recognise_xml  # noqa: PLC0415  few files are XML

    return recognise_xml(text, name)


def _has_keyword(text: str) -> bool:
    if not any(keyword in text for keyword in KEYWORDS):
        return False
    depth, top = 0, 1
    for match in _TOKEN.finditer(text):
        found = match.group(1)
        if depth == 0 and found == "[":
            top = 2
        if found in ("{", "["):
            depth += 1
        elif found in ("}", "]"):
            depth -= 1
        elif depth == top and found in KEYWORDS and _VALUE.match(text, match.end()):
            return True
    return False
