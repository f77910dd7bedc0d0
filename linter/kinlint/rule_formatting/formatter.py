"""Formats rule files: prefixes sorted, one indentation, lines of at most 100 columns.

What examples say stays to the byte; so does every term. Of SPARQL and of the prose of
`rdfs:comment` and `sh:message` only the white space changes.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from textwrap import wrap

from kinlint.rule_formatting.sparql_layout import INDENT, laid_out
from kinlint.rule_formatting.turtle_tree import Branch, Leaf, Property, Statement, Turtle, Value
from kinlint.sparql.tokens import NotSparql

WIDTH = 100
QUERIES = frozenset({"sh:select", "sh:ask", "sh:construct", "sh:update"})
PROSE = frozenset({"rdfs:comment", "sh:message"})
"""Properties whose strings are read as one line, however many they stand on."""

NESTED = frozenset({"sh:sparql", "sh:rule", "kl:example", "dash:suggestionGenerator"})
"""Properties whose values have a line for each of their own properties."""

SHORT = re.compile(r'"((?:[^"\\]|\\.)*)"')
LONG = re.compile(r'"""(.*)"""', re.DOTALL)


def formatted(text: str) -> str:
    """Return *text*, which has to be valid Turtle, as the formatter writes it."""
    turtle = Turtle(text)
    lines = [*turtle.header, *_prefixes(turtle)]
    for statement in turtle.statements:
        if lines and (statement.spaced or statement.properties):
            lines.append("")
        lines += statement.comments
        lines += _statement(statement)
    return "\n".join([*lines, *turtle.trailer]).strip("\n") + "\n"


def _prefixes(turtle: Turtle) -> Iterator[str]:
    """Yield the declarations of the prefixes that are used, in the order of their names."""
    used = sorted(turtle.used & set(turtle.prefixes))
    width = max(map(len, used), default=0) + 1
    for name in used:
        yield f"@prefix {f'{name}:':<{width}} {turtle.prefixes[name]} ."


def _statement(statement: Statement) -> list[str]:
    subject = _value("", statement.subject, 0)
    if not statement.properties:
        return [*subject[:-1], f"{subject[-1]} ."]
    first, *others = statement.properties
    lines = _property(first, 0)
    lines[0] = f"{subject[-1]} {lines[0]}"
    body = _block(others, INDENT)
    if body:
        lines[-1] += " ;"
    body = [*subject[:-1], *lines, *body]
    body[-1] += " ."
    return body


def _block(properties: Sequence[Property], indent: int) -> list[str]:
    """Return the lines of *properties*, each but the last ended by a semicolon."""
    lines: list[str] = []
    for number, each in enumerate(properties):
        if each.spaced and number:
            lines.append("")
        elif each.spaced:
            lines += [""] * (indent == INDENT)
        lines += [" " * indent + comment for comment in each.comments]
        own = _property(each, indent)
        if number < len(properties) - 1:
            own[-1] += " ;"
        lines += [" " * indent + own[0], *own[1:]]
    return lines


def _property(each: Property, indent: int) -> list[str]:
    """Return the lines of a property that begins at *indent*; the first without it."""
    flat = [_flat(value) for value in each.objects]
    if each.verb not in NESTED and all(one is not None for one in flat):
        line = f"{each.verb} {', '.join(one or '' for one in flat)}"
        if indent + len(line) + 2 <= WIDTH:
            return [line]
    if all(isinstance(value, Branch) for value in each.objects) or len(each.objects) == 1:
        lines = [each.verb]
        for number, value in enumerate(each.objects):
            own = _value(each.verb, value, indent)
            if own[0] and indent + len(lines[-1]) + len(own[0]) + 3 > WIDTH and '"""' not in own[0]:
                own = _value(each.verb, value, indent + INDENT)
                lines += [" " * (indent + INDENT) + own[0], *own[1:]]
            else:
                lines[-1] += f" {own[0]}"
                lines += own[1:]
            if number < len(each.objects) - 1:
                lines[-1] += ","
        return lines
    lines = [each.verb]
    for number, value in enumerate(each.objects):
        own = _value(each.verb, value, indent + INDENT)
        if number < len(each.objects) - 1:
            own[-1] += ","
        lines += [" " * (indent + INDENT) + own[0], *own[1:]]
    return lines


def _value(verb: str, value: Value, indent: int) -> list[str]:
    """Return the lines of an object; the first one goes on the line where it begins."""
    if isinstance(value, Leaf):
        return _leaf(verb, value.text, indent)
    flat = _flat(value)
    if flat is not None and verb not in NESTED and indent + len(flat) + 4 <= WIDTH:
        return [flat]
    if value.is_collection:
        lines = ["("]
        for item in value.items:
            own = _value("", item, indent + INDENT)
            lines += [" " * (indent + INDENT) + own[0], *own[1:]]
        lines[-1] += " )"
        return lines
    lines = ["[", *_block(value.properties, indent + INDENT)]
    lines += [" " * (indent + INDENT) + comment for comment in value.comments]
    lines[-1] += " ]"
    return lines


def _leaf(verb: str, text: str, indent: int) -> list[str]:
    inner = " " * (indent + INDENT)
    long = LONG.fullmatch(text)
    if verb in PROSE and (content := long or _too_long(verb, text, indent)):
        lines = wrap(
            " ".join(content[1].split()),
            WIDTH - len(inner),
            break_on_hyphens=False,
            break_long_words=False,
        )
        return ['"""', *(inner + line for line in lines), f'{inner}"""']
    if verb in QUERIES and (query := long or _too_long(verb, text, indent)):
        try:
            lines = [line and inner + line for line in laid_out(query[1], WIDTH - len(inner))]
        except NotSparql:
            return text.split("\n")
        return ['"""', *lines, f'{inner}"""']
    return text.split("\n")


def _too_long(verb: str, text: str, indent: int) -> re.Match[str] | None:
    """Return the content of a string in single quotes that does not fit behind its *verb*."""
    room = WIDTH - indent - len(verb) - 3
    return SHORT.fullmatch(text) if len(text) > room and "\\" not in text else None


def _flat(value: Value) -> str | None:
    """Return *value* on one line; None for what holds comments or a text of several lines."""
    if isinstance(value, Leaf):
        return None if "\n" in value.text else value.text
    if value.comments or any(each.comments for each in value.properties):
        return None
    if value.is_collection:
        items = [_flat(item) for item in value.items]
        inner = None if None in items else " ".join(one or "" for one in items)
        return None if inner is None else f"( {inner} )" if inner else "()"
    parts = []
    for each in value.properties:
        objects = [_flat(one) for one in each.objects]
        if None in objects:
            return None
        parts.append(f"{each.verb} {', '.join(one or '' for one in objects)}")
    return f"[ {' ; '.join(parts)} ]" if parts else "[]"
