"""Reads one MJCF file, with all that it includes, and states what MuJoCo's compiler makes of it."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from kinlint.document import Document
from kinlint.errors import SourceError
from kinlint.files.bounded_read import Unreadable
from kinlint.files.environment import kind
from kinlint.files.pathglob import absolute
from kinlint.files.pathname import shown
from kinlint.files.project_reach import ProjectReach
from kinlint.formats.blank_nodes import BlankNodes
from kinlint.formats.dependencies.included_text import included_text
from kinlint.formats.mjcf.format import MJCF
from kinlint.formats.mjcf.mjcf_elements import INCLUDE, MjcfElement, root_types, tree
from kinlint.formats.mjcf.stated_model import stated
from kinlint.formats.options import ReadOptions
from kinlint.formats.source_layer import SourceLayer
from kinlint.formats.xml import reader as xml
from kinlint.formats.xml.added_statements import value_span, with_statements
from kinlint.formats.xml.element_types import ElementType
from kinlint.formats.xml.included_statements import with_includes
from kinlint.light_dataclasses import dataclass, field, replace
from kinlint.terms import iri, literal
from kinlint.text import SourceText
from kinlint.vocabulary import ATTRIBUTE
from kinlint.vocabulary import MJCF as NAMESPACE

FILE = iri(f"{ATTRIBUTE}file")
MODEL = "model"
ROOTS = {INCLUDE: iri(f"{NAMESPACE}mujocoinclude"), MODEL: iri(f"{NAMESPACE}mujoco")}
"""The properties that lead from what names a file to the root of that file."""
MOST_DEEP = 16
MOST_INCLUDED = 1_000
MOST_STATED = 500_000
LARGEST = 1 << 26
"""Limits of included files.

These are the depth of includes and models, their number, the statements that the files make
together, and the bytes of a file.
"""


def read(source: SourceText, options: ReadOptions) -> Document:
    """Read the statements of an MJCF file, including those of the files that it includes.

    Raises SourceError for a file that cannot be read; an included one that cannot be read is
    stated.
    """
    main = absolute(source.name)
    budget = _Budget(ProjectReach(main, options.packages_of(source.name)))
    assembly = _Assembly(main, options, budget, (main,))
    whole = assembly.read(source, None, main)
    root = assembly.root or tree(whole.graph, whole.statements)
    return whole if root is None else stated(whole, root)


@dataclass
class _Budget:
    """Account of the files that one file includes, directly or not."""

    reach: ProjectReach
    """The files that may be included."""
    count: int = 0
    """Number of files so far."""
    stated: int = 0
    """Number of statements that they make."""

    def excess(self, depth: int) -> str:
        """Return the reason why nothing more is included; empty if there is none."""
        if self.stated > MOST_STATED:
            return "the included files are too large"
        too_many = depth > MOST_DEEP or self.count > MOST_INCLUDED
        return "too many files include each other" if too_many else ""


@dataclass
class _Assembly:
    """One model with its included files, each of which it includes once."""

    main: Path
    """The file that paths are relative to."""
    options: ReadOptions
    """The options of the run."""
    budget: _Budget
    """Account of all included files."""
    models: tuple[Path, ...]
    """The main files of the models that this one is part of, itself last."""
    taken: set[Path] = field(default_factory=set)
    """Files that are part of the model already."""
    root: MjcfElement | None = field(default=None, init=False)
    """The root of a model that is one file, once that was read."""

    def read(
        self, source: SourceText, around: ElementType | None, path: Path, depth: int = 0
    ) -> Document:
        """Read *source* at *path* with its includes; *around* is the type of what includes it."""
        self.taken.add(path)
        roots = None if around is None else root_types(around)
        document = xml.read(source, self.options, roots)
        if len(self.models) > 1 or depth:
            self.budget.stated += len(document.statements)
        root = tree(document.graph, document.statements)
        if root is None:
            return document
        if around is not None:
            if not root.children:
                raise Unreadable(f"{path.name} is empty")
            root.type = around
        layer = SourceLayer(document.graph, BlankNodes(f"{source.name}#included"))
        found: dict[str, list[tuple[MjcfElement, Document]]] = {INCLUDE: [], MODEL: []}
        for each in _naming_files(root, around):
            name = each.text("file")
            if not name.strip():
                continue
            kind_, included = self._included(each, name, path, depth + 1)
            if isinstance(included, Document):
                found[each.tag].append((each, included))
                continue
            span = value_span(document, each.node, (FILE,), name)
            said = ("node", each.node), ("written", literal(name)), ("reason", literal(included))
            layer.add_node(kind_, span, *said)
        whole = with_statements(document, layer)
        if not depth and not any(found.values()):
            self.root = root
        for tag, grafts in found.items():
            whole = with_includes(whole, [(e.node, d) for e, d in grafts], ROOTS[tag])
        return whole

    def _included(
        self, element: MjcfElement, name: str, near: Path, depth: int
    ) -> tuple[str, Document | str]:
        """Return what the file *name* states, or the class and the reason of what is wrong."""
        unread = "UnresolvedInclude"
        path = self._path(name, near)
        if path is None:
            return unread, "there is no such file"
        is_model = element.tag == MODEL
        if path in (self.models if is_model else self.taken):
            return self._taken_again(path, near)
        self.budget.count += 1
        if excess := self.budget.excess(depth + len(self.models)):
            return unread, excess
        around = element.parent.type if element.parent is not None and not is_model else None
        home = _Assembly(path, self.options, self.budget, (*self.models, path))
        try:
            text = included_text(path, self.budget.reach, shown(path), self.options, LARGEST)
            text = replace(text, format=MJCF)
            return unread, (home if is_model else self).read(text, around, path, depth)
        except SourceError as error:
            return unread, f"{path.name} cannot be read: {error.cause}"
        except Unreadable as error:
            return unread, str(error)

    def _taken_again(self, path: Path, near: Path) -> tuple[str, str]:
        """Return the class and the reason of what is wrong with a file that is there already."""
        if path in (*self.models, near):
            return "CircularInclude", f"{path.name} includes itself"
        return "RepeatedInclude", f"{path.name} is already included"

    def _path(self, name: str, near: Path) -> Path | None:
        """Return the file *name*: in the folder of the main file, or else of the one at *near*."""
        tried = (absolute(home.parent / name.replace("\\", "/")) for home in (self.main, near))
        return next((each for each in tried if kind(each) == "file"), None)


def _naming_files(root: MjcfElement, around: ElementType | None) -> Iterator[MjcfElement]:
    """Yield the includes and the models below *root*, each type known from what is around."""
    pending = [root]
    while pending:
        at = pending.pop()
        for each in at.children:
            if at is root and around is not None:
                each.type = around.children.get(each.tag, each.type)
            elif at is not root:
                each.type = at.type.children.get(each.tag, each.type)
            if each.tag == INCLUDE or (each.tag == MODEL and at.tag == "asset"):
                yield each
            else:
                pending.append(each)
