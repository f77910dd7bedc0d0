"""Parses values and metadata of text layers of USD, which may hold each other.

Values keep their spelling.
"""

from __future__ import annotations

from collections.abc import Callable, Collection

from kinlint.formats.usd.usda_scanner import Scanner, unquoted
from kinlint.formats.usd.usda_syntax import Field, Value
from kinlint.text import Span

BODY = "PhysicsRigidBodyAPI"
OPERATIONS = frozenset({"add", "prepend", "append", "delete", "reorder"})


class ValueParser(Scanner):
    """Values and metadata, each from the current token on."""

    def assigned(self) -> Value:
        """Return the value behind a '=', both on the line of what they are for."""
        self.unbroken()
        self.expect("=")
        self.unbroken()
        return self.value()

    def taken(self, words: Collection[str]) -> str:
        """Return the current token and go on in its line, if it is one of *words*; else nothing."""
        found = self.word if self.word in words else ""
        if found:
            self.onward()
        return found

    def metadata(self, into: list[Field]) -> None:
        """Read what stands in parentheses, and append it to *into*."""
        self.enter()
        self.expect("(")
        while self.word != ")" or self.kind != "mark":
            self.bound(len(into), "a prim or property", "metadata")
            if not self.kind:
                self.fail("expected ')'")
            if self.kind == "string":
                value = self.value()
                into.append(Field("documentation", value.span, value))
            else:
                into.append(self._field())
            last = into[-1]
            self.bound(len(last.value.items), f"'{last.name}'", "entries")
            if last.name == "apiSchemas" and BODY in [each.text for each in last.value.items]:
                self.bodies += 1
                self.bound(self.bodies, "the layer", "rigid bodies")
            self.separate(")")
        self.advance()
        self.depth -= 1

    def _field(self) -> Field:
        operation = "" if self.follows("=") else self.taken(OPERATIONS)
        if self.kind != "name":
            self.fail("expected the name of metadata")
        name, span = self.word, Span(self.at, self.stop)
        self.advance()
        return Field(name, span, self.assigned(), operation)

    def value(self) -> Value:
        """Return the value."""
        start, kind = self.at, self.kind
        is_cut = kind == "bulk" and self.word[-1] != "]"
        if is_cut or (kind == "mark" and self.word in _BRACKETS):
            self.enter()
            reader: Callable[[ValueParser], Value] = _BRACKETS[self.word[0]]
            found = reader(self)
            found.span = Span(start, self.end)
            if is_cut:
                found = Value("bulk", "", found.span)
            self.depth -= 1
            return found
        if not kind or kind == "mark":
            self.fail("expected a value")
        text = unquoted(self.word) if kind in ("string", "asset", "path") else self.word
        found = Value(kind, "" if kind == "bulk" else text, Span(start, self.stop))
        self.advance()
        if kind == "asset" or (kind == "path" and self.word == "("):
            self._reference(found)
        return found

    def _reference(self, value: Value) -> None:
        """Add the path and the layer offset that stand behind an asset or a path to *value*."""
        if self.kind == "path" and value.kind == "asset" and not self.fresh:
            value.items.append(Value("path", self.word[1:-1], Span(self.at, self.stop)))
            self.advance()
        if self.word == "(" and not self.fresh:
            self.metadata(value.fields)

    def _sequence(self, kind: str, closing: str) -> Value:
        found = Value(kind, "", Span(self.at, self.at))
        is_cut = self.kind == "bulk"
        self.advance()
        if kind == "tuple" and self.word == closing:
            self.fail("expected a number")
        while self.word != closing or self.kind != "mark":
            if is_cut and self.kind not in ("number", "mark"):
                self.fail("expected a number")
            found.items.append(self.value())
            self.bound(len(found.items), "a list", "members other than numbers")
            if self.word == ",":
                self.unbroken()
                self.advance()
            elif self.word != closing:
                self.fail(f"expected ',' or '{closing}'")
        self.advance()
        return found

    def _dictionary(self) -> Value:
        """Return a dictionary, whose entries have types and names, or samples by their times."""
        found = Value("dictionary", "", Span(self.at, self.at))
        self.advance()
        while self.word != "}" or self.kind != "mark":
            if self.kind in ("number", "path") or (self.kind == "string" and self.follows(":")):
                found.kind = "samples"
                type_name, name, span = "", self.word, Span(self.at, self.stop)
                self.onward()
                self.expect(":")
                self.unbroken()
                value = self.value()
            else:
                type_name, name, span = self._entry()
                value = self.assigned()
            found.fields.append(Field(name, span, value, type_name=type_name))
            if found.kind == "dictionary":
                self.separate("}")
                continue
            self.bound(len(found.fields), "an attribute", "samples")
            if self.word == ",":
                self.unbroken()
                self.advance()
            elif self.word != "}":
                self.fail("expected ',' or '}'")
        self.advance()
        return found

    def _entry(self) -> tuple[str, str, Span]:
        """Read an entry of a dictionary; return its type, and its name with the place."""
        if self.kind != "name":
            self.fail("expected an entry of a dictionary")
        type_name = self.word
        self.advance()
        if self.word == "[":
            self.advance()
            self.expect("]")
            type_name += "[]"
        if self.kind not in ("name", "string"):
            self.fail("expected the name of an entry")
        self.unbroken()
        name = unquoted(self.word) if self.kind == "string" else self.word
        span = Span(self.at, self.stop)
        self.advance()
        return type_name, name, span


_BRACKETS: dict[str, Callable[[ValueParser], Value]] = {
    "(": lambda parser: parser._sequence("tuple", ")"),  # noqa: SLF001  of its own class
    "[": lambda parser: parser._sequence("list", "]"),  # noqa: SLF001
    "{": lambda parser: parser._dictionary(),  # noqa: SLF001
}
