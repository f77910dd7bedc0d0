"""Unused and repeated definitions of xacro files.

Unused parameters, properties that hide others.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from functools import cached_property

from kinlint.formats.source_layer import SourceLayer
from kinlint.formats.xacro.dom import Element, Text
from kinlint.formats.xacro.xacro_parser import ParsedXacro
from kinlint.light_dataclasses import dataclass, field
from kinlint.terms import literal
from kinlint.text import SourceText, Span

At = Callable[[SourceText, Span], Span]
_EVALUATED = re.compile(r"\$\{([^}]*)\}|\$\(([^)]*)\)")
_NAME = re.compile(r"[^\W\d]\w*")
_PARAMETER = re.compile(
    r"\s*([^\s:=]+?)\s*:?=\s*(\^\|?)?(\$\{.*?\}|\$\(.*?\)|(?:'.*?'|\".*?\"|[^\s'\"]+)+|)(?:\s+|$)"
)
_WORD = re.compile(r"\s*(\S+)")
OWN = frozenset(
    f"xacro:{name}"
    for name in (
        "arg attribute element if include insert_block macro property unless".split()  # noqa: SIM905
    )
)
"""`xacro:` elements that call no macro."""
OPEN = frozenset({"xacro:include", "xacro:call"})
"""Elements that bring into a macro what its text does not show."""


@dataclass
class Macro:
    """A macro as it is written: its parameters with their places, and what its body names."""

    element: Element
    """Element that defines the macro."""
    parameters: Mapping[str, Span]
    """Places of its parameters by name."""
    defaults: str
    """Default values, as they are written."""
    inside: list[Element] = field(default_factory=list)
    """All elements of its body."""

    @cached_property
    def used_names(self) -> frozenset[str]:
        """The names in what the body evaluates, and in its defaults, and the blocks it inserts."""
        return frozenset(_names_in(self.inside)) | frozenset(_names(self.defaults))

    @cached_property
    def calls(self) -> frozenset[str]:
        """The macros that the body calls."""
        tags = {each.tagName for each in self.inside if each.tagName.startswith("xacro:")}
        return frozenset(tag.removeprefix("xacro:").rpartition(".")[2] for tag in tags - OWN)

    @cached_property
    def is_open(self) -> bool:
        """Tell whether the body may use names that are not in its text."""
        return any(each.tagName in OPEN for each in self.inside)


def state_definitions(layer: SourceLayer, files: Mapping[int, ParsedXacro], at: At) -> None:
    """State in *layer* what is wrong with the definitions in *files*, the main one first."""
    roots = [parsed.root for parsed in files.values() if parsed.root is not None]
    macros = [macro for root in roots for macro in _macros(root)]
    by_name: dict[str, list[Macro]] = {}
    for macro in macros:
        by_name.setdefault(macro.element.getAttribute("name"), []).append(macro)
    for macro in macros:
        _state_unused(layer, macro, by_name, at)
    outside: dict[str, Element] = {}
    for root in roots:
        for each in _properties(root, within=False):
            outside.setdefault(each.getAttribute("name"), each)
    for root in roots:
        for each in _properties(root, within=True):
            name = each.getAttribute("name")
            if name in outside:
                _state_hidden(layer, each, outside[name], at)


def _state_unused(
    layer: SourceLayer, macro: Macro, by_name: Mapping[str, list[Macro]], at: At
) -> None:
    """State which parameters neither the macro uses nor any macro that it comes to call.

    A macro sees what the macro that calls it sees. Of macros that are not known, who knows?
    """
    reached, waiting, uses = set[int](), [macro], set[str]()
    while waiting:
        each = waiting.pop()
        if id(each) in reached:
            continue
        reached.add(id(each))
        if each.is_open or not each.calls <= by_name.keys():
            return
        uses |= each.used_names
        waiting += [called for name in each.calls for called in by_name.get(name, ())]
    name = macro.element.getAttribute("name")
    for parameter, span in macro.parameters.items():
        if parameter.lstrip("*") not in uses:
            layer.add_node(
                "UnusedParameter",
                at(macro.element.origin.source, span),
                ("parameter", literal(parameter)),
                ("macro", literal(name)),
                ("node", layer.document),
            )


def _state_hidden(layer: SourceLayer, inner: Element, outer: Element, at: At) -> None:
    origin = outer.origin
    line = origin.source.position(origin.start).line
    layer.add_node(
        "ShadowedProperty",
        at(inner.origin.source, inner.span_of("name")),
        ("property", literal(inner.getAttribute("name"))),
        ("outer", literal(f"{origin.source.name}:{line}")),
        ("node", layer.document),
    )


def _macros(root: Element) -> Iterator[Macro]:
    for element in root.everything:
        if element.tagName == "xacro:macro":
            parameters, defaults = _parameters(element)
            inside = [each for each in element.everything if each is not element]
            yield Macro(element, parameters, defaults, inside)


def _parameters(macro: Element) -> tuple[dict[str, Span], str]:
    """Return the parameters of a macro, with their places, and the text of their defaults."""
    text = macro.getAttribute("params")
    spans = macro.origin.attributes.get("params")
    found: dict[str, Span] = {}
    defaults: list[str] = []
    at = 0
    exact = spans is not None and spans.value.end - spans.value.start == len(text)
    while match := _PARAMETER.match(text, at) or _WORD.match(text, at):
        name = match[1]
        place = Span(*match.span(1))
        if spans is not None:
            start = spans.value.start
            place = Span(start + place.start, start + place.end) if exact else spans.value
        found[name] = place
        if match.re is _PARAMETER:
            defaults.append(match[3] or "")
            if match[2]:
                # Handed on from outside, so the name is used by the default itself.
                defaults.append("")
        at = match.end()
    return found, " ".join(defaults)


def _properties(root: Element, *, within: bool) -> Iterator[Element]:
    """Yield the properties that are defined inside macros, or outside, for that scope alone."""
    waiting = [(root, False)]
    while waiting:
        element, inside = waiting.pop()
        inside = inside or element.tagName == "xacro:macro"
        if element.tagName == "xacro:property" and inside is within and _is_local(element):
            yield element
        waiting.extend((each, inside) for each in reversed(list(element.elements)))


def _is_local(element: Element) -> bool:
    name = element.getAttribute("name")
    return bool("$" not in name and not (set(element.values) & {"scope", "remove", "default"}))


def _names_in(elements: list[Element]) -> Iterator[str]:
    for element in elements:
        for name, value in element.values.items():
            yield from _names(value)
            if element.tagName == "xacro:insert_block" and name == "name":
                yield value
            if element.tagName == "xacro:macro" and name == "params":
                yield from _NAME.findall(value)
        for child in element.children:
            if isinstance(child, Text) and "$" in child.data:
                yield from _names(child.data)


def _names(text: str) -> Iterator[str]:
    """Yield the names in what of *text* is evaluated."""
    if "$" in text:
        for match in _EVALUATED.finditer(text):
            yield from _NAME.findall(match[1] or match[2] or "")
