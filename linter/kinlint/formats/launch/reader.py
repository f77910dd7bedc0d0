"""Reads which arguments a launch file passes to the xacro of a robot."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from kinlint.addresses import child, document_iri, repeated_address, root_of
from kinlint.document import Document, NodeSpans, SourceMap
from kinlint.errors import SourceError
from kinlint.files.bounded_read import Unreadable, contents
from kinlint.files.packages import Packages
from kinlint.files.pathglob import absolute
from kinlint.formats.blank_nodes import BlankNodes
from kinlint.formats.declared_arguments import DeclaredArguments, declared_arguments
from kinlint.formats.launch.format import LAUNCH
from kinlint.formats.launch.markup_launch import markup_calls
from kinlint.formats.launch.python_launch import PythonLaunch
from kinlint.formats.launch.xacro_call import HERE, SHARE, XacroCall
from kinlint.formats.options import ReadOptions
from kinlint.formats.source_layer import SourceLayer, src
from kinlint.suggestion import nearest
from kinlint.terms import Term, Triple, iri, literal
from kinlint.text import SourceText, Span
from kinlint.vocabulary import ATTRIBUTE

MOST_LISTED = 10
"""Most declared arguments that are listed."""
LARGEST = 1 << 18
"""Most characters of a file that is looked into."""


def read(source: SourceText, options: ReadOptions) -> Document:
    """Read the calls of xacro; a file without any states nothing but what it is.

    What cannot be understood without running it is passed over.
    """
    graph = document_iri(source.name)
    root = root_of(graph)
    layer = SourceLayer(graph, BlankNodes(source.name))
    layer.state_file(LAUNCH.name, source.name, Span(0, len(source.text)))
    stated: dict[Triple, Span] = {}
    nodes: dict[Term, NodeSpans] = {}
    packages = options.packages_of(source.name)
    for call in calls(source):
        if not nodes:
            begin = Span(0, min(1, len(source.text)))
            stated[graph, _term("launch"), root] = begin
            layer.triples[root, src("describedIn"), graph] = begin
            nodes[root] = NodeSpans(Span(0, len(source.text)))
        _state(call, root, stated, nodes)
        for name, span, reason in _undeclared(call, absolute(source.name), packages):
            details = {"written": name, "file": call.file.rpartition("/")[2], "reason": reason}
            told = ((key, literal(value)) for key, value in details.items())
            layer.add_node("UndeclaredArgument", span, ("node", graph), *told)
    statements = (*stated, *layer.triples)
    places = SourceMap({**stated, **layer.triples}, {**nodes, **layer.nodes})
    return Document(source, graph, statements, places, format=LAUNCH)


def calls(source: SourceText) -> Sequence[XacroCall]:
    """Return the calls of xacro in *source* whose files are known."""
    if len(source.text) > LARGEST or "xacro" not in source.text:
        return []
    xml = source.text.lstrip()[:1] == "<"
    if xml or source.name.lower().endswith((".yaml", ".yml")):
        found = markup_calls(source.text, xml=xml)
    else:
        found = PythonLaunch(source).calls()
    return sorted(found, key=lambda each: each.span)


def _state(
    call: XacroCall, root: Term, stated: dict[Triple, Span], nodes: dict[Term, NodeSpans]
) -> None:
    """State the *call* in the launch file with this *root*, and its arguments."""

    def add(parent: Term, tag: str, name: str, span: Span) -> Term:
        first, order = child(parent, tag, name), 1
        element = first
        while element in nodes:
            order += 1
            element = iri(repeated_address(first[1:-1], order))
        nodes[element] = NodeSpans(span, span)
        stated[parent, _term(tag), element] = span
        stated[element, iri(f"{ATTRIBUTE}name"), literal(name)] = span
        return element

    element = add(root, "xacro", call.file, call.span)
    for name, span in call.arguments:
        add(element, "argument", name, span)


def _undeclared(
    call: XacroCall, launch: Path, packages: Packages
) -> Iterator[tuple[str, Span, str]]:
    """Yield the arguments of *call* that its file does not declare, with what it does."""
    declared = _declared(call.file, launch, packages) if call.arguments else None
    if declared is None:
        return
    for name, span in call.arguments:
        if name not in declared.names:
            meant = nearest(name, declared.names)
            listed = ", ".join(f"'{each}'" for each in sorted(declared.names)[:MOST_LISTED])
            if meant is not None:
                yield name, span, f"closest name: '{meant}'"
            elif declared.complete:
                yield name, span, f"declared: {listed}" if listed else "it declares none"


def _declared(file: str, launch: Path, packages: Packages) -> DeclaredArguments | None:
    """Return the arguments that the xacro *file* declares; None if it is not found."""
    if file.startswith(SHARE):
        path = packages.resolve(file, launch.parent)
    elif file.startswith(HERE):
        path = absolute(launch.parent / file.removeprefix(HERE).lstrip("/"))
    else:
        path = Path(file) if file.startswith("/") else None
    if path is None:
        return None
    try:
        text = contents(path, launch).decode("utf-8", "replace")
    except (Unreadable, SourceError):
        return None
    return declared_arguments([(str(path), text, packages)])


def _term(name: str) -> Term:
    return iri(f"{LAUNCH.namespace}{name}")
