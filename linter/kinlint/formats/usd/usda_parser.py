"""Parses text layers of USD into syntax trees with the places of all names and values.

The grammar is that of usd-core 26.11; what types, schemas and paths mean is not looked at. Values
keep their spelling.
"""

from __future__ import annotations

from collections.abc import Callable, Collection

from kinlint.formats.usd.usda_scanner import MalformedLayer, Scanner, header, unquoted
from kinlint.formats.usd.usda_syntax import Field, Prim, Property, Value, Variant
from kinlint.text import SourceText, Span

BODY = "PhysicsRigidBodyAPI"
JOINT = "Joint"
SPECIFIERS = frozenset({"def", "over", "class"})
OPERATIONS = frozenset({"add", "prepend", "append", "delete", "reorder"})
VARIABILITIES = frozenset({"uniform", "config", "varying"})
SUFFIXES = frozenset({"connect", "timeSamples", "spline"})


def parse(source: SourceText) -> Prim:
    """Return the layer that *source* is, as a prim without a name.

    Raises MalformedLayer where it is not well-formed, and SourceError for what no scene is as
    large or as deep as.
    """
    return _Parser(source).layer()


class _Parser(Scanner):
    def layer(self) -> Prim:
        """Return the whole layer."""
        self.stop = header(self.source).end()
        root = Prim("", "", Span(0, self.stop), Span(0, len(self.text)))
        self.advance()
        if self.word == "(":
            self._metadata(root.metadata)
        while self.kind:
            block = self.word in SPECIFIERS
            if self.word == "reorder":
                self._skip_reorder()
            elif block:
                root.children.append(self._prim())
            else:
                self.fail("expected 'def', 'over' or 'class'")
            self.separate("", block=block)
        return root

    def _prim(self) -> Prim:
        self.enter()
        self.prims += 1
        self.bound(self.prims, "the layer", "prims")
        start, specifier = self.at, self.word
        self.advance()
        self.unbroken()
        type_name, type_span = "", None
        if self.kind == "name":
            type_name, type_span = self.word, Span(self.at, self.stop)
            if type_name.endswith(JOINT):
                self.joints += 1
                self.bound(self.joints, "the layer", "joints")
            self.advance()
            self.unbroken()
        name, span = self.name("the name of a prim")
        if not name.isidentifier():
            raise MalformedLayer(span, f"'{name}' is no name: prims have letters, digits and _")
        prim = Prim(specifier, name, span, span, type_name, type_span)
        self._body(prim, start, f"the block of prim '{name}'")
        return prim

    def _body(self, prim: Prim, start: int, what: str) -> None:
        """Read metadata and block of *prim*, of which the text began at *start*."""
        if self.word == "(":
            self._metadata(prim.metadata)
        self.expect("{", f"'{{' of {what}")
        while self.word != "}" or self.kind != "mark":
            if not self.kind:
                self.fail("expected '}'")
            block = self.word in SPECIFIERS or self.word == "variantSet"
            self._statement(prim)
            self.separate("", block=block)
        prim.span = Span(start, self.stop)
        self.advance()
        self.depth -= 1

    def _statement(self, prim: Prim) -> None:
        if self.kind != "name":
            self.fail("expected a prim or a property")
        if self.word in SPECIFIERS:
            prim.children.append(self._prim())
        elif self.word == "variantSet":
            prim.variant_sets.append(self._variant_set())
        elif self.word == "reorder" and self.follows("nameChildren", "properties"):
            self._skip_reorder()
        else:
            prim.properties.append(self._property())
            self.bound(len(prim.properties), "a prim", "properties")

    def _skip_reorder(self) -> None:
        self.advance()
        self.unbroken()
        if self.kind != "name":
            self.fail("expected what to reorder")
        self.advance()
        self._assigned()

    def _assigned(self) -> Value:
        """Return the value behind a '=', both on the line of what they are for."""
        self.unbroken()
        self.expect("=")
        self.unbroken()
        return self._value()

    def _variant_set(self) -> Variant:
        self.enter()
        start = self.at
        self.advance()
        self.unbroken()
        name, span = self.name("the name of a variant set")
        found = Variant(name, span, span)
        self.unbroken()
        self.expect("=")
        self.expect("{")
        while self.word != "}":
            self.enter()
            first = self.at
            own, place = self.name("the name of a variant")
            variant = Prim("variant", own, place, place)
            self._body(variant, first, f"variant '{own}'")
            found.variants.append(variant)
            self.bound(len(found.variants), "a variant set", "variants")
        found.span = Span(start, self.stop)
        self.advance()
        self.depth -= 1
        return found

    def _property(self) -> Property:
        self.enter()
        start = self.at
        operation = self._taken(OPERATIONS)
        custom = bool(self._taken({"custom"}))
        variability = self._taken(VARIABILITIES)
        if self.kind != "name":
            self.fail("expected the type of a property")
        type_name, type_start, type_end = self.word, self.at, self.stop
        self.advance()
        if self.word == "[":
            self.advance()
            type_end = self.stop
            self.expect("]")
            type_name += "[]"
        if self.kind != "name":
            self.fail("expected the name of a property")
        self.unbroken()
        name, _, suffix = self.word.partition(".")
        if suffix and suffix not in SUFFIXES:
            self.fail(f"expected one of {', '.join(sorted(SUFFIXES))} behind the '.'")
        found = Property(
            name, Span(self.at, self.at + len(name)), Span(start, self.stop),
            type_name, Span(type_start, type_end), suffix, custom, variability, operation,
        )  # fmt: skip
        self.advance()
        if self.word == "=":
            self.unbroken()
            self.advance()
            self.unbroken()
            if found.type_name == "rel" and self.kind != "path" and self.word not in ("[", "None"):
                self.fail("expected the path of a target, such as </robot/link>")
            found.value = self._value()
            names = found.type_name == "rel" or found.name == "xformOpOrder"
            if names:
                self.bound(len(found.value.items), f"'{found.name}'", "targets or operations")
        elif suffix or operation:
            self.fail("expected '='")
        if self.word == "(":
            self.unbroken()
            self._metadata(found.metadata)
        found.span = Span(start, self.end)
        self.depth -= 1
        return found

    def _taken(self, words: Collection[str]) -> str:
        """Return the current token and go on in its line, if it is one of *words*; else nothing."""
        found = self.word if self.word in words else ""
        if found:
            self.advance()
            self.unbroken()
        return found

    def _metadata(self, into: list[Field]) -> None:
        """Read what stands in parentheses, and append it to *into*."""
        self.enter()
        self.expect("(")
        while self.word != ")" or self.kind != "mark":
            self.bound(len(into), "a prim or property", "metadata")
            if not self.kind:
                self.fail("expected ')'")
            if self.kind == "string":
                value = self._value()
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
        operation = "" if self.follows("=") else self._taken(OPERATIONS)
        if self.kind != "name":
            self.fail("expected the name of metadata")
        name, span = self.word, Span(self.at, self.stop)
        self.advance()
        return Field(name, span, self._assigned(), operation)

    def _value(self) -> Value:
        start, kind = self.at, self.kind
        is_cut = kind == "bulk" and self.word[-1] != "]"
        if is_cut or (kind == "mark" and self.word in _BRACKETS):
            self.enter()
            reader: Callable[[_Parser], Value] = _BRACKETS[self.word[0]]
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
            self._metadata(value.fields)

    def _sequence(self, kind: str, closing: str) -> Value:
        found = Value(kind, "", Span(self.at, self.at))
        is_cut = self.kind == "bulk"
        self.advance()
        if kind == "tuple" and self.word == closing:
            self.fail("expected a number")
        while self.word != closing or self.kind != "mark":
            if is_cut and self.kind not in ("number", "mark"):
                self.fail("expected a number")
            found.items.append(self._value())
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
                self.advance()
                self.unbroken()
                self.expect(":")
                self.unbroken()
                value = self._value()
            else:
                type_name, name, span = self._entry()
                value = self._assigned()
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


_BRACKETS: dict[str, Callable[[_Parser], Value]] = {
    "(": lambda parser: parser._sequence("tuple", ")"),  # noqa: SLF001  of its own class
    "[": lambda parser: parser._sequence("list", "]"),  # noqa: SLF001
    "{": lambda parser: parser._dictionary(),  # noqa: SLF001
}
