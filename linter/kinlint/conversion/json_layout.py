"""JSON as people write it: what fits on a line is on one."""

from __future__ import annotations

import json
from typing import Any

WIDTH = 100
INDENT = "  "


def format_json(value: Any, indent: str = "", used: int = 0) -> str:
    """Return *value* as JSON text.

    Its lines begin with *indent*, the first after *used* characters.
    """
    line = _line(value)
    if len(indent) + used + len(line) <= WIDTH or not isinstance(value, (dict, list)):
        return line
    inner = indent + INDENT
    if isinstance(value, dict):
        members = []
        for key, each in value.items():
            head = f"{json.dumps(key, ensure_ascii=False)}: "
            members.append(f"{inner}{head}{format_json(each, inner, len(head) + 1)}")
        return "{\n" + ",\n".join(members) + f"\n{indent}}}"
    if any(isinstance(each, (dict, list)) for each in value):
        items = [f"{inner}{format_json(each, inner, 1)}" for each in value]
        return "[\n" + ",\n".join(items) + f"\n{indent}]"
    return "[\n" + _filled(value, inner) + f"\n{indent}]"


def _line(value: Any) -> str:
    """*value* on one line, with blanks inside of brackets."""
    if isinstance(value, dict) and value:
        members = (f"{_line(key)}: {_line(each)}" for key, each in value.items())
        return "{ " + ", ".join(members) + " }"
    if isinstance(value, list) and value:
        return "[ " + ", ".join(map(_line, value)) + " ]"
    return json.dumps(value, ensure_ascii=False)


def _filled(values: list[Any], indent: str) -> str:
    """Scalars, as many on a line as fit."""
    lines: list[str] = []
    for number, value in enumerate(values):
        word = _line(value) + ("," if number < len(values) - 1 else "")
        if lines and len(lines[-1]) + 1 + len(word) <= WIDTH:
            lines[-1] += f" {word}"
        else:
            lines.append(indent + word)
    return "\n".join(lines)
