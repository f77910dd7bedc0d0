"""Shapes graphs: the triples of Turtle files as tokens, with an index and list access."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TypeAlias

import pyoxigraph as ox

from kinlint.engine.compiler.completion import completed
from kinlint.errors import RuleInvalid
from kinlint.light_dataclasses import dataclass, field
from kinlint.terms import RDF, Term, Triple, is_literal

Source: TypeAlias = Path | tuple[str, str]
"""A Turtle file, or a name and a text."""

FIRST, REST, NIL = f"<{RDF}first>", f"<{RDF}rest>", f"<{RDF}nil>"


@dataclass(frozen=True)
class ShapesFile:
    """A parsed Turtle file: its triples in the order of the text, its prefixes, and the text.

    Blank nodes are named `_:<label of the file>.<order of appearance>`, so that a file gives them
    the same names by itself and among others.
    """

    name: str
    """Name of the file."""
    triples: tuple[Triple, ...]
    """Triples, in the order of the text."""
    prefixes: dict[str, str]
    """Namespaces by prefix."""
    text: str = field(default="", repr=False)
    """Text of the file."""


@dataclass
class ShapesGraph:
    """The triples of several files, by subject and predicate."""

    files: tuple[ShapesFile, ...]
    """Files in the order in which they were given."""
    namespaces: dict[tuple[Term, ...], dict[str, str]] = field(default_factory=dict, repr=False)
    """Namespaces by prefix that ontologies declare, as far as these have been asked for."""
    _out: dict[Term, dict[Term, list[Term]]] = field(default_factory=dict, repr=False)
    _in: dict[tuple[Term, Term], list[Term]] = field(default_factory=dict, repr=False)
    _home: dict[Term, ShapesFile] = field(default_factory=dict, repr=False)

    def __post_init__(self) -> None:
        for file in self.files:
            for s, p, o in file.triples:
                values = self._out.setdefault(s, {}).setdefault(p, [])
                if o not in values:
                    values.append(o)
                    self._in.setdefault((p, o), []).append(s)
                self._home.setdefault(s, file)

    def subjects(self) -> Iterator[Term]:
        """Yield every subject once, in the order of the files."""
        return iter(self._out)

    def values(self, subject: Term, *predicates: Term) -> list[Term]:
        """Return the objects of *subject* for *predicates*, in the order of the text."""
        about = self._out.get(subject, {})
        return [value for predicate in predicates for value in about.get(predicate, ())]

    def predicates(self, subject: Term) -> tuple[Term, ...]:
        """Return the predicates that *subject* has."""
        return tuple(self._out.get(subject, ()))

    def referrers(self, predicate: Term, value: Term) -> list[Term]:
        """Return the subjects that have *value* for *predicate*."""
        return self._in.get((predicate, value), [])

    def home(self, subject: Term) -> ShapesFile:
        """Return the file that describes *subject* first."""
        return self._home.get(subject, self.files[0])

    def one(self, subject: Term, predicate: Term) -> Term | None:
        """Return the only object, or None; two are refused."""
        values = self.values(subject, predicate)
        if len(values) > 1:
            raise self.invalid(subject, f"{predicate} has {len(values)} values, not one")
        return values[0] if values else None

    def list(self, head: Term) -> tuple[Term, ...]:
        """Return the members of an RDF list; anything less than well-formed is refused."""
        members: list[Term] = []
        seen: set[Term] = set()
        node = head
        while node != NIL:
            first, rest = self.values(node, FIRST), self.values(node, REST)
            if node in seen or is_literal(node) or len(first) != 1 or len(rest) != 1:
                raise self.invalid(head, "this is not a well-formed list")
            seen.add(node)
            members.append(first[0])
            node = rest[0]
        return tuple(members)

    def is_true(self, subject: Term, predicate: Term) -> bool:
        """Tell whether the value is `true`, spelled so: SHACL knows no other spelling."""
        return '"true"^^<http://www.w3.org/2001/XMLSchema#boolean>' in self.values(
            subject, predicate
        )

    def invalid(self, node: Term, cause: str) -> RuleInvalid:
        """Return the error that *node* is not as SHACL demands, with its file and what has it."""
        name, seen = node, {node}
        while name.startswith("_:"):
            above = [s for s, about in self._out.items() if any(name in v for v in about.values())]
            if not above or above[0] in seen:
                break
            name = above[0]
            seen.add(name)
        return RuleInvalid(f"{self.home(node).name}: {name}: {cause}")


def read(files: Sequence[Source]) -> ShapesGraph:
    """Return the graph of Turtle *files*.

    Raises `RuleInvalid` with the file and line of what is no Turtle.
    """
    named = zip(files, labels(files), strict=True)
    return ShapesGraph(tuple(parse(source, label) for source, label in named))


def labels(files: Sequence[Source]) -> list[str]:
    """Return what tells the blank nodes of *files* apart: their stems, numbered where equal."""
    found: list[str] = []
    for source in files:
        stem = Path(source if isinstance(source, Path) else source[0]).stem
        label = re.sub(r"[^A-Za-z0-9]+", "-", stem).strip("-") or "file"
        same = sum(each.split(".")[0] == label for each in found)
        found.append(f"{label}.{same}" if same else label)
    return found


def parse(source: Source, label: str = "b") -> ShapesFile:
    """Return the Turtle file *source*; names of its blank nodes begin with *label*.

    Rule files are completed with what all of them say. `RuleInvalid` names the line and cause if
    it is no Turtle.
    """
    name = str(source if isinstance(source, Path) else source[0])
    names: dict[str, str] = {}

    def token(term: ox.NamedNode | ox.BlankNode | ox.Literal | ox.Triple) -> Term:
        written = str(term)
        if isinstance(term, ox.BlankNode):
            return names.setdefault(written, f"_:{label}.{len(names)}")
        return written

    try:
        text = source.read_text("utf-8-sig") if isinstance(source, Path) else source[1]
        base = Path(name).resolve().as_uri()
        parser = ox.parse(text, ox.RdfFormat.TURTLE, base_iri=base)
        triples = tuple((token(q.subject), token(q.predicate), token(q.object)) for q in parser)
    except UnicodeDecodeError as error:
        raise RuleInvalid(f"{name}: not UTF-8, from byte {error.start} on") from error
    except SyntaxError as error:
        cause = str(error.msg).split(": ", 1)[-1]
        raise RuleInvalid(f"{name}:{error.lineno}: {cause}") from error
    return ShapesFile(name, completed(triples), dict(parser.prefixes), text)
