"""Reads a xacro file: the robot it expands to, each statement placed in the text that wrote it."""

from __future__ import annotations

import re
from collections.abc import Callable

from kinlint.addresses import document_iri
from kinlint.document import Document, NodeSpans, SourceMap
from kinlint.errors import SourceError
from kinlint.files.installed_files import is_installed
from kinlint.files.pathglob import absolute
from kinlint.formats import registry
from kinlint.formats.blank_nodes import BlankNodes
from kinlint.formats.options import ReadOptions
from kinlint.formats.source_layer import SourceLayer, src
from kinlint.formats.srdf.format import SRDF
from kinlint.formats.urdf.format import URDF
from kinlint.formats.xacro.definitions import state_definitions
from kinlint.formats.xacro.expanded_text import write
from kinlint.formats.xacro.expansion import MALFORMED, REDEFINED, WITHHELD, Expansion, Fault
from kinlint.formats.xacro.expansion_limits import Limits
from kinlint.formats.xacro.expansion_session import Omitted, Session
from kinlint.formats.xacro.format import XACRO
from kinlint.formats.xacro.included_files import Pieces
from kinlint.formats.xacro.partial_expansion import expand_as_far_as_possible
from kinlint.formats.xacro.source_mapping import MappedPlaces, MappedText
from kinlint.formats.xacro.xacro_parser import ParsedXacro
from kinlint.formats.xml.xml_recognition import recognise_xml
from kinlint.light_dataclasses import replace
from kinlint.suggestion import nearest
from kinlint.terms import XSD, Term, Triple, literal
from kinlint.text import SourceText, Span

OFFSET = src("offset")
TRUE = literal("true", f"{XSD}boolean")
UNKNOWN = {
    "argument": ("UnknownArgument", "argument"),
    "package": ("UnknownPackage", "package"),
    "environment variable": ("UnknownVariable", "variable"),
}
"""Type and property of the statement about a name that is not known here, by its kind."""
REMARKS = {
    REDEFINED: ("ShadowedSymbol", "symbol"),
    WITHHELD: ("WithheldVariable", "variable"),
}
"""Type and property of the statement for a remark about a name, by its kind."""
BODIES = frozenset({"link", "joint"})


def read(source: SourceText, options: ReadOptions) -> Document:
    """Read the robot that *source* expands to, and add statements about the xacro.

    A file that does not expand, or only defines what others use, has only the latter.
    """
    pieces = Pieces(source, absolute(source.name), options)
    packages = options.packages_of(source.name)
    bounds = Limits()

    def session(omitted: Omitted) -> Session:
        arguments = options.xacro_arguments_of(source.name)
        variables = options.xacro_variables_of(source.name)
        return Session(pieces, arguments, packages, variables, bounds, omitted)

    expansion = expand_as_far_as_possible(session, bounds)
    layer = _layer(source, pieces, expansion)
    if expansion.fault is None and _is_robot(expansion.parsed):
        written = write(expansion.parsed, pieces)
        form = recognise_xml(written.text)
        if form is not None and form != XACRO:
            expanded = replace(source, text=written.text, format=form)
            try:
                robot = registry.read(expanded, options)
            except SourceError as error:
                span = written.span(_told(error, expanded))
                layer.add_node("ExpansionFailure", span, ("reason", literal(error.cause)))
            else:
                triple = layer.document, src("format"), literal(XACRO.name)
                layer.triples[triple] = Span(0, min(1, len(source.text)))
                return _moved(robot, source, written, layer, pieces)
    layer.state_file(XACRO.name, source.name, Span(0, len(source.text)))
    places = SourceMap(layer.triples, layer.nodes)
    return Document(
        source, layer.document, tuple(layer.triples), places, pieces=pieces.listed, format=XACRO
    )


def _is_robot(parsed: ParsedXacro) -> bool:
    """Tell whether there is a robot, and not only definitions for files that include this one.

    The latter have a root without name, or without elements of a robot, even misspelt ones.
    """
    root = parsed.root
    assert root is not None
    if root.tagName != "robot":
        return True
    if not root.hasAttribute("name"):
        return False
    known = SRDF.root_children | URDF.root_children
    tags = {each.tagName for each in root.elements}
    return bool(tags & (BODIES | SRDF.root_children)) or any(
        nearest(each, known) in BODIES for each in tags - known
    )


def _layer(source: SourceText, pieces: Pieces, expansion: Expansion) -> SourceLayer:
    """Return the statements about the xacro itself."""
    graph = document_iri(source.name)
    layer = SourceLayer(graph, BlankNodes(f"{source.name} as xacro"))

    def at(text: SourceText, span: Span) -> Span:
        begin = pieces.begin(text)
        return Span(begin + span.start, begin + span.end)

    for element, included in expansion.includes if expansion.fault is None else ():
        triple = graph, src("includes"), document_iri(included.name)
        layer.triples.setdefault(triple, at(element.origin.source, element.span_of("filename")))
    for each in expansion.missing:
        _state_fault(layer, each, at, expansion)
    for element in expansion.omitted:
        origin = element.origin
        layer.add_node("MissingPart", at(origin.source, origin.tag), ("node", graph))
    if (fault := expansion.fault) is not None and fault.name not in {
        each.name for each in expansion.missing
    }:
        _state_fault(layer, _in_project(fault, expansion), at, expansion)
    for remark in expansion.remarks:
        kind, prop = REMARKS.get(remark.kind, ("XacroRemark", "reason"))
        value = remark.name if remark.kind else remark.message
        span = at(remark.source, remark.span)
        layer.add_node(kind, span, (prop, literal(value)), ("node", graph))
    state_definitions(layer, expansion.files, at)
    return layer


def _in_project(fault: Fault, expansion: Expansion) -> Fault:
    """Return *fault*; if it is in an installed file, at the last include of the main file."""
    main = next(iter(expansion.files.values()), None)
    if main is None or main.root is None or not is_installed(absolute(fault.source.name)):
        return fault
    own = main.root.origin.source
    calls = [each for each, _ in expansion.includes if each.origin.source is own]
    span = calls[-1].span_of("filename") if calls else main.root.origin.tag
    return replace(fault, source=own, span=span, reason=f"{fault.reason}, in {fault.source.name}")


def _misspelt_argument(fault: Fault, expansion: Expansion) -> tuple[Fault, str | None]:
    """Return *fault* where its argument is written, and a declared argument that resembles it."""
    roots = [each.root for each in expansion.files.values() if each.root is not None]
    declared = {
        each.getAttribute("name")
        for root in roots
        for each in root.elements
        if each.tagName == "xacro:arg"
    }
    written = re.compile(rf"\$\(arg\s+{re.escape(fault.name)}\s*\)")
    if written.search(fault.source.text[fault.span.start : fault.span.end]) is None:
        for source in (root.origin.source for root in roots):
            if (match := written.search(source.text)) is not None:
                fault = replace(fault, source=source, span=Span(*match.span()))
                break
    return fault, nearest(fault.name, declared)


def _state_fault(
    layer: SourceLayer,
    fault: Fault,
    at: Callable[[SourceText, Span], Span],
    expansion: Expansion,
) -> None:
    node = ("node", layer.document)
    if fault.kind in UNKNOWN:
        kind, prop = UNKNOWN[fault.kind]
        told = [(prop, literal(fault.name)), node]
        if prop == "argument":
            fault, known = _misspelt_argument(fault, expansion)
            told += [("resembles", literal(known))] if known else []
        layer.add_node(kind, at(fault.source, fault.span), *told)
        return
    span, reason = at(fault.source, fault.span), ("reason", literal(fault.reason))
    if fault.kind == MALFORMED:
        layer.add_node("MalformedText", span, reason, ("unread", TRUE), node)
    else:
        layer.add_node("ExpansionFailure", span, reason, node)


def _moved(
    robot: Document, source: SourceText, written: MappedText, layer: SourceLayer, pieces: Pieces
) -> Document:
    """Return *robot* with its places in *pieces*, and the statements of *layer*."""
    others = [(start, pieces.append(text) - start) for start, text in robot.pieces[1:]]

    def back(span: Span) -> Span:
        """Return the source of what the robot's reader placed at *span*."""
        if not others or span.start < others[0][0]:
            return written.span(span)
        shift = next(by for start, by in reversed(others) if start <= span.start)
        return Span(span.start + shift, span.end + shift)

    def back_to_node(spans: NodeSpans) -> NodeSpans:
        identifier = spans.identifier
        return NodeSpans(back(spans.whole), None if identifier is None else back(identifier))

    statements: list[Triple] = []
    own: dict[Triple, Span] = {}
    for triple in robot.statements:
        if triple[1] == OFFSET:
            span = back(robot.map.triples[triple])
            moved = triple[0], OFFSET, _number(span.start)
            own[moved] = span
            statements.append(moved)
        else:
            statements.append(triple)
    known = set(layer.triples) - set(robot.statements) if layer.triples else set()
    own |= {triple: span for triple, span in layer.triples.items() if triple in known}
    statements += [triple for triple in layer.triples if triple in known]
    nodes = MappedPlaces(robot.map.nodes, back_to_node, layer.nodes)
    places = SourceMap(MappedPlaces(robot.map.triples, back, own), nodes)
    form = XACRO if robot.format == URDF else robot.format
    return Document(
        source, robot.graph, statements, places, robot.prefixes, pieces=pieces.listed, format=form
    )


def _told(error: SourceError, text: SourceText) -> Span:
    """Return the place in *text* that *error* names."""
    start = text.line_starts[(error.line or 1) - 1] + (error.column or 1) - 1
    return Span(start, start + 1)


def _number(offset: int) -> Term:
    return literal(str(offset), f"{XSD}integer")
