"""The record that describes one file format."""

from __future__ import annotations

from enum import Enum

from kinlint.light_dataclasses import dataclass, field


class Shape(Enum):
    """The data model of a format."""

    GRAPH = "graph"
    """Statements about nodes with IRIs, in the terms of the composable metamodels."""
    TREE = "tree"
    """Elements, each with an IRI below that of its document; lifted to the metamodels."""


@dataclass(frozen=True)
class Format:
    """File format: how its files are recognised, read, written and shown.

    Each record is kept in the package of its format, next to the reader; `kinlint.formats.records`
    collects them. Modules are named, not imported, so that a run loads only the readers that it
    needs. Two records of one name are equal, also when one of them comes from another process.
    """

    name: str
    """The identifier in rules (`kl:format`), in the source layer and in the names of data files."""
    title: str = field(compare=False, repr=False)
    """The name in prose and in headings of tables."""
    suffixes: tuple[str, ...] = field(compare=False, repr=False)
    """The ends of the names of its files, with their dots, the usual one first."""
    shape: Shape = field(compare=False, repr=False)
    """Content of its files: graphs of statements or trees of elements."""
    reader: str = field(compare=False, repr=False)
    """The dotted name of the module whose `read(source, options)` makes a document of a text."""
    shared_suffixes: tuple[str, ...] = field(default=(), compare=False, repr=False)
    """Ends of the names of its files that files of other kinds have, too: the root tells."""
    signatures: tuple[bytes, ...] = field(default=(), compare=False, repr=False)
    """The beginnings of those of its files that are no text."""
    archive_suffixes: tuple[str, ...] = field(default=(), compare=False, repr=False)
    """Ends of the names of those of its files that are archives, whatever they begin with."""
    decoder: str | None = field(default=None, compare=False, repr=False)
    """The dotted name of the module whose `decode(name, data)` makes a text of such a file."""
    editor: str | None = field(default=None, compare=False, repr=False)
    """The dotted name of the module whose `Editor(document, options)` writes changes into a text;
    None if the format is only read."""
    fence: str = field(default="text", compare=False, repr=False)
    """The language of its code blocks in Markdown."""
    namespace: str | None = field(default=None, compare=False, repr=False)
    """The namespace of its elements in the format layer; None if it has no elements of its own."""
    roots: tuple[str, ...] = field(default=(), compare=False, repr=False)
    """The tags of its root elements; other formats may share them."""
    root_children: frozenset[str] = field(default=frozenset(), compare=False, repr=False)
    """Tags directly below the root that tell it from formats with the same root."""
    schema: str | None = field(default=None, compare=False, repr=False)
    """The table of its elements and attributes, a file below `shapes/`."""
    block_comment: tuple[str, str] | None = field(default=None, compare=False, repr=False)
    """Delimiters of comments, if these carry suppressions. A format with neither has
    statements for them."""
    line_comments: str | None = field(default=None, compare=False, repr=False)
    """Dotted name of the module that writes suppressions as comments to the end of a line; None if
    there are no such comments."""
    robot_path: tuple[str, ...] = field(default=(), compare=False, repr=False)
    """The tags of the elements from the root to one that is a robot; none if no file has robots."""
    fixed_root: bool = field(default=False, compare=False, repr=False)
    """True if most readers fix the root link of a robot to the world."""
    expands_to: str | None = field(default=None, compare=False, repr=False)
    """The name of the format that its files are macros of; that one's queries, rules and profile
    hold for them."""
    speaks_of: str | None = field(default=None, compare=False, repr=False)
    """The name of the format of the robots that its files annotate without describing them."""
    lifted: bool = field(default=True, compare=False, repr=False)
    """False if its elements are looked at as they are, and nothing is lifted from them."""
    includes: bool = field(default=False, compare=False, repr=False)
    """True if the statements of a file depend on files that it names."""
    searched: bool = field(default=True, compare=False, repr=False)
    """True if directories are searched for its files; others have to be named, or match a glob."""
    robot_files: str | None = field(default=None, compare=False, repr=False)
    """The dotted name of the module whose `robots(paths)` yields those of its files in a directory
    that are read, if the ends of their names do not tell."""
    convertible: bool = field(default=False, compare=False, repr=False)
    """True if `kinlint convert` writes it."""
    appendable: bool = field(default=False, compare=False, repr=False)
    """True if statements may be appended to a file without regard to the rest."""

    @property
    def is_tree(self) -> bool:
        """Tell whether files are trees of elements.

        These are lifted to the composable metamodels.
        """
        return self.shape is Shape.TREE

    @property
    def describes_robots(self) -> bool:
        """Tell whether each file describes complete robots, independently of other files."""
        return self.is_tree and self.speaks_of is None

    @property
    def lifted_as(self) -> str:
        """The name of the format whose lifting queries, rules and profile hold for its files."""
        return self.expands_to or self.name
