"""Reads one SDF file, with all that it includes, and states what its names and poses come to."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from kinlint.document import Document
from kinlint.errors import SourceError
from kinlint.files.bounded_read import Unreadable
from kinlint.files.packages import Packages
from kinlint.files.pathglob import absolute
from kinlint.files.pathname import shown
from kinlint.files.project_reach import ProjectReach
from kinlint.formats.blank_nodes import BlankNodes
from kinlint.formats.dependencies.included_text import included_text
from kinlint.formats.dependencies.model_uri import MissingModel, locate
from kinlint.formats.options import ReadOptions
from kinlint.formats.sdf.format import SDF
from kinlint.formats.sdf.frames import CircularReference
from kinlint.formats.sdf.resolution import resolve_names
from kinlint.formats.sdf.sdf_elements import SdfElement, tree
from kinlint.formats.source_layer import SourceLayer, src
from kinlint.formats.xml import reader as xml
from kinlint.formats.xml.added_statements import value_span, with_statements
from kinlint.formats.xml.included_statements import with_includes
from kinlint.light_dataclasses import dataclass
from kinlint.terms import Triple, iri, literal
from kinlint.text import SourceText
from kinlint.vocabulary import ATTRIBUTE
from kinlint.vocabulary import SDF as NAMESPACE

ROOT = iri(f"{NAMESPACE}sdf")
MOST_DEEP = 16
MOST_INCLUDED = 1_000
MOST_STATED = 500_000
LARGEST = 1 << 26
"""Limits of included files.

These are the depth of includes, their number, the statements that the included files make together,
and the bytes of a file.
"""


def read(source: SourceText, options: ReadOptions) -> Document:
    """Read the statements of an SDF file, including those of the files that it includes.

    Raises SourceError for a file that cannot be read; an included one that cannot be read is
    stated.
    """
    inclusion = _Inclusion(options, options.packages_of(source.name))
    whole = inclusion.read(source, (absolute(source.name),))
    root = tree(whole.graph, whole.statements)
    if root is None:
        return whole
    triples, circles = resolve_names(root, whole.statements)
    return _with_names(whole, triples, circles)


@dataclass
class _Inclusion:
    """Files that one file includes, directly or not."""

    options: ReadOptions
    """The options of the run."""
    packages: Packages
    """The packages and models that URIs lead to."""
    count: int = 0
    """Number of inclusions so far."""
    stated: int = 0
    """Number of statements that they make."""

    def read(self, source: SourceText, chain: tuple[Path, ...]) -> Document:
        """Read *source* with its includes; *chain* are the files that include each other."""
        document = xml.read(source, self.options)
        self.stated += len(document.statements) if len(chain) > 1 else 0
        root = tree(document.graph, document.statements)
        if root is None:
            return document
        layer = SourceLayer(document.graph, BlankNodes(f"{source.name}#included"))
        found = []
        for include in _includes(root):
            uri = include.first("uri")
            if uri is None or not uri.text.strip():
                continue
            kind, included = self._included(uri.text.strip(), chain)
            if isinstance(included, Document):
                found.append((include.node, included))
                continue
            span = value_span(document, uri.node, (src("text"),), uri.text)
            written, reason = literal(uri.text.strip()), literal(included.reason)
            details = ("node", include.node), ("written", written), ("reason", reason)
            layer.add_node(kind, span, *details)
        return with_includes(with_statements(document, layer), found, ROOT)

    def _included(self, uri: str, chain: tuple[Path, ...]) -> tuple[str, Document | MissingModel]:
        unread = "UnresolvedInclude"
        path = locate(uri, chain, self.packages)
        if isinstance(path, MissingModel):
            return unread, path
        if path in chain:
            return "CircularInclude", MissingModel(f"{path.name} includes itself")
        self.count += 1
        if excess := self._excess(len(chain)):
            return unread, MissingModel(excess)
        try:
            return unread, self.read(self._text(path, chain[0]), (*chain, path))
        except SourceError as error:
            return unread, MissingModel(f"{path.name} cannot be read: {error.cause}")
        except Unreadable as error:
            return unread, MissingModel(str(error))

    def _excess(self, depth: int) -> str:
        """Return the reason why nothing more is included; empty if there is none."""
        if self.stated > MOST_STATED:
            return "the included files are too large"
        too_many = depth > MOST_DEEP or self.count > MOST_INCLUDED
        return "too many files include each other" if too_many else ""

    def _text(self, path: Path, near: Path) -> SourceText:
        """Return the SDF text of the file at *path*, for the file at *near*."""
        reach = ProjectReach(near, self.packages)
        text = included_text(path, reach, shown(path), self.options, LARGEST)
        if text.format != SDF:
            raise Unreadable(f"{text.name} is not SDF")
        return text


def _includes(root: SdfElement) -> Iterator[SdfElement]:
    """Yield the includes of all worlds and models below *root*."""
    pending = [root]
    while pending:
        at = pending.pop()
        yield from at.all("include")
        pending += [each for each in at.children if each.tag in ("world", "model")]


def _with_names(
    document: Document,
    triples: Mapping[Triple, Triple | None],
    circles: Sequence[CircularReference],
) -> Document:
    """Return *document* with what was derived from it."""
    layer = SourceLayer(document.graph, BlankNodes(f"{document.source.name}#names"))
    for circle in circles:
        carrier, role = circle.carrier.node, circle.role
        ways = (f"<{ATTRIBUTE}{role}>", src("text"), f"<{ATTRIBUTE}frame>")
        node = layer.add_node(
            "CircularReference",
            value_span(document, carrier, ways, circle.written),
            ("node", circle.owner.node),
            ("role", literal(role)),
            ("written", literal(circle.written)),
        )
        for member in circle.members:
            layer.triples[node, src("member"), member.node] = layer.nodes[node].best
    written = document.map.triples
    return with_statements(
        document, layer, {each: written[of] if of else None for each, of in triples.items()}
    )
