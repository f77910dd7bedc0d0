"""Checks of the terms in a file of rules or shapes: each is one that exists.

Only names with a prefix are held to this. An IRI written in full is meant as it is.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from typing import NamedTuple

from kinlint.catalogue.known_terms import attributes_of, names_in
from kinlint.engine.compiler.shacl_terms import sh
from kinlint.engine.compiler.shapes_graph import ShapesFile
from kinlint.formats.records import ELEMENTS
from kinlint.formats.turtle import turtle_tokens
from kinlint.sparql.keywords import WORDS
from kinlint.sparql.tokens import NotSparql, Token, prologue, split
from kinlint.suggestion import did_you_mean
from kinlint.terms import Term, iri, literal_value
from kinlint.vocabulary import ATTRIBUTE, EXTENSION, SH

QUERIES = (sh("select"), sh("ask"), sh("construct"), sh("update"))
"""Properties whose values are SPARQL."""
TYPED = ("a", "rdf:type")
"""Predicates that lead to a class."""


class Fault(NamedTuple):
    """Something wrong in a file."""

    offset: int
    """Offset in its text."""
    text: str
    """Message."""


def term_faults(file: ShapesFile, prefixes: Mapping[str, str]) -> Iterator[Fault]:
    """Yield the terms of *file* that do not exist; its queries may use *prefixes*."""
    own = {subject for subject, _, _ in file.triples}
    yield from _turtle(file, own)
    for query in queries(file):
        for fault in query_faults(query.text, prefixes, own, update=query.kind == sh("update")):
            yield Fault(query.place(file.text, fault.offset), fault.text)


class WrittenQuery(NamedTuple):
    """A query of a file, as it is written there."""

    node: Term
    """The node that states it."""
    kind: Term
    """The property that states it: `sh:select`, for example."""
    text: str
    """Its text, without escapes."""
    start: int
    """Offset of the text in the file."""
    escapes: bool
    """True if the file has escapes in it, so that offsets in it are only those of its lines."""

    def place(self, file: str, offset: int) -> int:
        """Return where *offset* of the query is in the text *file*."""
        if not self.escapes:
            return self.start + offset
        line = file.count("\n", 0, self.start) + self.text.count("\n", 0, offset)
        return sum(len(each) for each in file.splitlines(keepends=True)[:line])


def queries(file: ShapesFile) -> Iterator[WrittenQuery]:
    """Yield the queries of *file*, in the order of its triples, each once."""
    for node, kind, value in dict.fromkeys(file.triples):
        if kind in QUERIES:
            text = literal_value(value)
            start = file.text.find(text)
            if start < 0:
                first = text.split("\\", 1)[0]
                yield WrittenQuery(node, kind, text, max(file.text.find(first), 0), escapes=True)
            else:
                yield WrittenQuery(node, kind, text, start, escapes=False)


def _turtle(file: ShapesFile, own: set[Term]) -> Iterator[Fault]:
    """Yield the terms of *file* outside its queries that do not exist."""
    found = list(turtle_tokens.tokens(file.text))
    check = _Terms(file.prefixes, own, frozenset(each.text for each in found))
    predicate, declared = "", False
    for token in found:
        if token.kind in ("at", "word"):
            declared = token.text.lower().lstrip("@") in ("prefix", "base")
        elif token.kind == "iri":
            declared = False
        if token.kind == "name" and not declared:
            fault = check.fault(token.text)
            if not fault and predicate == "targetClass":
                fault = check.no_class(token.text, "write sh:targetObjectsOf")
            if fault:
                yield Fault(token.start, fault)
            if check.full(token.text).startswith(f"<{SH}"):
                predicate = token.text.rpartition(":")[2]


def query_faults(
    text: str, prefixes: Mapping[str, str], own: Collection[Term] = (), *, update: bool = False
) -> Iterator[Fault]:
    """Yield the words and terms of the query *text* that do not exist.

    It may use *prefixes*, and terms of its *own* file. Elements that an *update* makes may have the
    names of attributes.
    """
    try:
        known = {**prefixes, **prologue(text)}
        found = split(text)
    except NotSparql:
        return
    check = _Terms(known, own, frozenset(token.text for token in found))
    before = ""
    for token, following in zip(found, [*found[1:], None], strict=True):
        fault = None
        if token.kind == "word":
            fault = _word(token, following.text if following else "")
        elif token.kind == "name" and before.upper() != "PREFIX":
            beside = "|" in (before, following.text if following else "")
            fault = check.fault(token.text, lenient=beside or update)
            if not fault and before in TYPED:
                fault = check.no_class(token.text, f"write ?parent {token.text} ?element")
        if fault:
            yield Fault(token.start, fault)
        before = token.text


def _word(token: Token, following: str) -> str | None:
    """Return what is wrong with a word of SPARQL, which *following* stands behind."""
    if token.text == "a" or token.text.upper() in WORDS:
        return None
    kind = "function" if following == "(" else "keyword"
    return f"SPARQL has no {kind} '{token.text}'{did_you_mean(token.text.upper(), WORDS)}"


class _Terms:
    """The check of the terms of a text."""

    def __init__(
        self, prefixes: Mapping[str, str], own: Collection[Term], words: frozenset[str]
    ) -> None:
        """Begin with the *prefixes* of the text, the terms that its file defines, its *words*."""
        self.prefixes = prefixes
        self.own = own
        self.named = {self.full(word) for word in words if ":" in word and word[0] not in "\"'<_"}
        self.extended = any(each.startswith(f"<{EXTENSION}") for each in self.named)

    def full(self, name: str) -> Term:
        """Return the IRI that *name* stands for; with no known prefix, none of any vocabulary."""
        prefix, _, local = name.partition(":")
        return iri(self.prefixes.get(prefix, "") + local)

    def fault(self, name: str, *, lenient: bool = False) -> str | None:
        """Return what is wrong with the prefixed *name*; None if it exists, or nobody can tell.

        If *lenient*, an element may have the name of an attribute, as it has in some files.
        Elements that no format lists (`ext:`) have attributes that none lists.
        """
        prefix, _, local = name.partition(":")
        namespace = self.prefixes.get(prefix)
        term = self.full(name)
        known = names_in(namespace) if namespace and local and term not in self.own else None
        if known is None or namespace is None or (fault := known.fault(prefix, local)) is None:
            return None
        if namespace == ATTRIBUTE:
            return None if self.extended else fault
        if local in attributes_of(namespace):
            if lenient:
                return None
            return f"{name}: {known.what} '{local}'; the attribute is at:{local}"
        return fault

    def no_class(self, name: str, remedy: str) -> str | None:
        """Return why *name* is not a class; None if it is not known to be something else."""
        if self.prefixes.get(name.partition(":")[0]) not in ELEMENTS:
            return None
        more = f" {name}" if remedy.startswith("write sh:") else ""
        return f"{name} is the property that leads to an element, not a class: {remedy}{more}"
