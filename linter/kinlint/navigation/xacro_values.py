"""Values of xacro properties that are defined once, outside of macros."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from kinlint.document import Document
from kinlint.formats.xacro.expansion_limits import LimitExceeded, Limits, Refused
from kinlint.formats.xacro.expression import evaluate
from kinlint.formats.xacro.expression_symbols import dotted, symbols, tokenize
from kinlint.formats.xml.unfinished_text import UnfinishedText

PROPERTY, MACRO = "xacro:property", "xacro:macro"
DEEPEST = 40


def property_value(document: Document, name: str) -> str:
    """Return the value of the property *name* of *document*; empty if it cannot be told."""
    written = _Written(document)
    try:
        value = written.value(name)
    except (ArithmeticError, AttributeError, LookupError, NameError, SyntaxError, TypeError):
        return ""
    except (ValueError, RecursionError, Refused, LimitExceeded):
        return ""
    return f"{value:.6g}" if isinstance(value, float) else str(value)


class _Written(dict[str, Any]):
    """Values of properties by name, worked out when they are asked for."""

    def __init__(self, document: Document) -> None:
        super().__init__()
        self._limits = Limits()
        own = {"load_yaml": _unknown, "abs_filename": _unknown, "dotify": dotted}
        self._symbols: Mapping[str, Any] = symbols(self._limits, {**own, "tokenize": tokenize})
        self._texts: dict[str, list[str]] = {}
        self._depth = 0
        for name, text in _properties(document):
            self._texts.setdefault(name, []).append(text)

    def value(self, name: str) -> Any:
        """Return the value of the property *name*; raises NameError if it has none or several."""
        texts = self._texts.get(name, ())
        self._depth += 1
        if len(texts) != 1 or self._depth > DEEPEST:
            raise NameError(name)
        text = texts[0]
        if text.startswith("${") and text.endswith("}") and text.count("$") == 1:
            return evaluate(text[2:-1], self, self._limits)
        if "$" in text:
            raise NameError(name)
        return _literal(text)

    def __missing__(self, name: str) -> Any:
        if name in self._texts:
            self[name] = self.value(name)
            return self[name]
        return self._symbols[name]


def _properties(document: Document) -> Iterator[tuple[str, str]]:
    for source in document.sources:
        for element in UnfinishedText(source.text).elements:
            given = element.attributes
            outside = all(each.tag != MACRO for each in element.ancestors)
            if element.tag == PROPERTY and "name" in given and outside:
                yield given["name"], given.get("value", given.get("default", "$"))


def _literal(text: str) -> Any:
    """Return *text* as the number that it is, or as it is."""
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    return text


def _unknown(*_: Any) -> Any:
    raise NameError("a file")
