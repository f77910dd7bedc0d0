"""Parses text layers of USD into syntax trees with the places of all names and values.

The grammar is that of usd-core 26.11; what types, schemas and paths mean is not looked at. Values
keep their spelling.
"""

from __future__ import annotations

from kinlint.formats.usd.usda_scanner import MalformedLayer, header
from kinlint.formats.usd.usda_syntax import Prim, Property, Variant
from kinlint.formats.usd.usda_values import OPERATIONS, ValueParser
from kinlint.text import SourceText, Span

JOINT = "Joint"
SPECIFIERS = frozenset({"def", "over", "class"})
VARIABILITIES = frozenset({"uniform", "config", "varying"})
SUFFIXES = frozenset({"connect", "timeSamples", "spline"})


def parse(source: SourceText) -> Prim:
    """Return the layer that *source* is, as a prim without a name.

    Raises MalformedLayer where it is not well-formed, and SourceError for what no scene is as
    large or as deep as.
    """
    return _Parser(source).layer()


class _Parser(ValueParser):
    def layer(self) -> Prim:
        """Return the whole layer."""
        self.stop = header(self.source).end()
        root = Prim("", "", Span(0, self.stop), Span(0, len(self.text)))
        self.advance()
        if self.word == "(":
            self.metadata(root.metadata)
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
        self.onward()
        type_name, type_span = "", None
        if self.kind == "name":
            type_name, type_span = self.word, Span(self.at, self.stop)
            if type_name.endswith(JOINT):
                self.joints += 1
                self.bound(self.joints, "the layer", "joints")
            self.onward()
        name, span = self.name("the name of a prim")
        if not name.isidentifier():
            raise MalformedLayer(span, f"'{name}' is no name: prims have letters, digits and _")
        prim = Prim(specifier, name, span, span, type_name, type_span)
        self._body(prim, start, f"the block of prim '{name}'")
        return prim

    def _body(self, prim: Prim, start: int, what: str) -> None:
        """Read metadata and block of *prim*, of which the text began at *start*."""
        if self.word == "(":
            self.metadata(prim.metadata)
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
        self.onward()
        if self.kind != "name":
            self.fail("expected what to reorder")
        self.advance()
        self.assigned()

    def _variant_set(self) -> Variant:
        self.enter()
        start = self.at
        self.onward()
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
        operation = self.taken(OPERATIONS)
        custom = bool(self.taken({"custom"}))
        variability = self.taken(VARIABILITIES)
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
            self.onward()
            if found.type_name == "rel" and self.kind != "path" and self.word not in ("[", "None"):
                self.fail("expected the path of a target, such as </robot/link>")
            found.value = self.value()
            names = found.type_name == "rel" or found.name == "xformOpOrder"
            if names:
                self.bound(len(found.value.items), f"'{found.name}'", "targets or operations")
        elif suffix or operation:
            self.fail("expected '='")
        if self.word == "(":
            self.unbroken()
            self.metadata(found.metadata)
        found.span = Span(start, self.end)
        self.depth -= 1
        return found
