"""JSON as a stream can take it."""

from __future__ import annotations

import json
from typing import Any

from kinlint.reporters.display_width import replace_surrogates
from kinlint.reporters.terminal_style import Style


def json_text(value: Any, style: Style, indent: int | None = None) -> str:
    """Return *value* as JSON without lone surrogates, which many parsers refuse even as escapes."""
    text = replace_surrogates(json.dumps(value, indent=indent, ensure_ascii=False))
    if style.unicode or text.isascii():
        return text
    return json.dumps(json.loads(text), indent=indent)
