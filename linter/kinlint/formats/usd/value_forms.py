"""Forms of values by their types: quotes, brackets, parentheses, and how many numbers.

OpenUSD rejects a layer in which a value has another form than its type.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from kinlint.formats.usd.prim_paths import absolute_path
from kinlint.formats.usd.usda_syntax import Property, Value
from kinlint.formats.usd.value_types import MATRICES, TRUTHS, value_type
from kinlint.light_dataclasses import dataclass
from kinlint.text import Span

LONGEST = 80
"""Most characters of a value that are told."""
_TEXT = "a text in quotes"
_WORDS: Mapping[str, tuple[frozenset[str], str]] = {
    "string": (frozenset({"string", "path"}), _TEXT),
    "token": (frozenset({"string", "path"}), _TEXT),
    "pathExpression": (frozenset({"string", "path"}), _TEXT),
    "asset": (frozenset({"asset", "string", "path"}), "a path between @"),
    "layer": (frozenset({"asset"}), "a path between @"),
    "reference": (frozenset({"asset", "path"}), "a path between @, or between < and >"),
    "path": (frozenset({"path"}), "a path between < and >"),
    "dictionary": (frozenset({"dictionary"}), "entries in braces"),
}
"""Types that are no numbers: kinds of their values, and what they are called."""
_METADATA = {
    **dict.fromkeys(
        ("metersPerUnit", "kilogramsPerUnit", "timeCodesPerSecond", "framesPerSecond"), "double"
    ),
    **dict.fromkeys(("startTimeCode", "endTimeCode", "startFrame", "endFrame"), "double"),
    **dict.fromkeys(("active", "hidden", "instanceable"), "bool"),
    **dict.fromkeys(("doc", "documentation", "comment", "displayName", "owner"), "string"),
    **dict.fromkeys(("upAxis", "defaultPrim", "kind"), "token"),
    **dict.fromkeys(("assetInfo", "customData", "customLayerData", "variants"), "dictionary"),
    "framePrecision": "int",
    "apiSchemas": "token[]",
    "subLayers": "layer[]",
}
"""Types of metadata."""
_LISTED = {
    **dict.fromkeys(("references", "payload", "payloads"), "reference"),
    **dict.fromkeys(("inherits", "specializes"), "path"),
    "variantSets": "string",
}
"""Types of the members of metadata that are lists, or one member without brackets."""
_KINDS = {
    "name": "a word without quotes",
    "number": "a number",
    "string": "a text",
    "asset": "a path between @",
    "path": "a path between < and >",
    "tuple": "in parentheses",
    "list": "in brackets",
    "bulk": "in brackets",
    "dictionary": "in braces",
    "samples": "in braces",
}
_ONCE = frozenset({"references", "payload", "payloads", "inherits", "specializes", "variantSets"})
"""Metadata whose lists have each item once."""


@dataclass(frozen=True, slots=True)
class Flaw:
    """Value that is none of its type."""

    span: Span
    """Place."""
    written: str
    """Text."""
    expected: str
    """Clause that says what values of the type are."""
    reason: str
    """Clause that says why this is none."""


def metadata_flaws(name: str, value: Value, around: str) -> Iterator[Flaw]:
    """Yield how *value* departs from the form of the metadata *name* of the prim at *around*."""
    if name in _ONCE:
        yield from repeated_items(value, around)
    listed = _LISTED.get(name)
    yield from (
        flaws(value, _METADATA.get(name, "")) if listed is None else _listed_flaws(value, listed)
    )


def relationship_flaws(given: Property) -> Iterator[Flaw]:
    """Yield the targets of *given* that are no paths; nothing for an attribute."""
    if given.is_relationship and given.value is not None:
        yield from _listed_flaws(given.value, "path")


def repeated_items(value: Value, around: str) -> Iterator[Flaw]:
    """Yield the paths and files in the list *value*, of the prim at *around*, that stand before.

    OpenUSD rejects a layer with such a list.
    """
    before = set[tuple[str, ...]]()
    for each in value.items if value.kind == "list" else ():
        text = absolute_path(each.text, around) if each.kind == "path" else each.text
        key = each.kind, text, *(item.text for item in each.items)
        if key in before and not each.fields:
            yield Flaw(each.span, _written(each), "each item once", "it is listed before")
        before.add(key)


def _listed_flaws(value: Value, base: str) -> Iterator[Flaw]:
    return flaws(value, f"{base}[]" if value.kind == "list" else base)


def flaws(value: Value, type_name: str) -> Iterator[Flaw]:
    """Yield how *value* departs from the form of the type *type_name*; nothing for unknown types.

    Entries of dictionaries are compared with their own types.
    """
    base = type_name.removesuffix("[]")
    if value.kind == "dictionary" and base in ("", "dictionary"):
        for entry in value.fields:
            yield from flaws(entry.value, entry.type_name)
        return
    if value.kind == "samples" or (value.kind == "name" and value.text == "None"):
        return
    if base == type_name:
        if (found := _flaw(value, base)) is not None:
            yield found
        return
    if value.kind not in ("list", "bulk"):
        yield _departing(value, "a list in brackets")
        return
    for each in value.items:
        if each.kind != "list" and (found := _flaw(each, base)) is not None:
            yield found


def _flaw(value: Value, base: str) -> Flaw | None:
    """Return how *value*, which is no array, departs from the form of the type *base*."""
    if base in _WORDS:
        kinds, expected = _WORDS[base]
        return None if value.kind in kinds else _departing(value, expected)
    known = value_type(base)
    if known is None:
        return None
    if known.count > 1:
        return _tuple_flaw(value, known.count, MATRICES.get(base))
    is_truth = known.scalar == "bool" and value.text.lower() in TRUTHS
    is_right = value.kind == "number" or (is_truth and value.kind in ("name", "string"))
    expected = "true or false" if known.scalar == "bool" else "a number"
    return None if is_right else _departing(value, expected)


def _tuple_flaw(value: Value, count: int, rows: int | None) -> Flaw | None:
    """Return how *value* departs from the form of *count* numbers, in *rows* if it is a matrix."""
    if value.kind != "tuple":
        return _departing(value, f"{count} numbers")
    there = sum(1 for _ in value.scalars())
    if there != count:
        reason = f"{there} values" if there != 1 else "one value"
        return Flaw(value.span, _written(value), f"{count} numbers", reason)
    members = value.items if rows else [value]
    if rows and any(each.kind != "tuple" or len(each.items) != rows for each in members):
        return _departing(value, f"{rows} rows of {rows} numbers, each in parentheses")
    inner = next((e for m in members for e in m.items if e.kind in ("tuple", "list")), None)
    return _departing(inner, "a number") if inner is not None else None


def _departing(value: Value, expected: str) -> Flaw:
    return Flaw(value.span, _written(value), expected, f"it is {_KINDS[value.kind]}")


def _written(value: Value) -> str:
    return " ".join(each.text for each in value.scalars())[:LONGEST]
