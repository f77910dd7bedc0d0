"""Terms as people read them: the abbreviations of the file, numbers without their datatype."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Collection, Mapping
from functools import cached_property
from urllib.parse import unquote

from kinlint.addresses import is_address, owner_path, short_path, split, unordered
from kinlint.formats.records import ELEMENTS
from kinlint.light_dataclasses import dataclass, field
from kinlint.terms import (
    RDF_TYPE,
    XSD,
    Term,
    Triple,
    iri_value,
    is_blank,
    is_literal,
    literal_datatype,
    literal_value,
)
from kinlint.vocabulary import (
    ATTRIBUTE,
    DOCUMENT_BASE,
    EXTENSION,
    KIN,
    KL,
    METAMODELS,
    QUANTITY_KIND,
    QUDT,
    REFERENCE,
    SRC,
    UNIT,
)

BARE = (METAMODELS, KL, KIN, SRC, UNIT, QUANTITY_KIND, QUDT, DOCUMENT_BASE)
"""Namespaces whose local names stand for themselves, as models write them."""

XML = (ATTRIBUTE, *ELEMENTS, EXTENSION, REFERENCE)
"""Namespaces of elements and attributes, whose local names are what files of XML write."""

COMPONENT = re.compile(r"-[1-9][0-9]*$")
"""The end of the property that has one number of an attribute of several."""


LONGEST, TAIL = 160, 40
"""Most characters of a term that a message repeats, and how many of them are its end."""

NUMBERS = {f"{XSD}{name}" for name in ("double", "float", "decimal", "integer")}


@dataclass(frozen=True)
class TermFormatter:
    """Writes terms as people read them in a file."""

    prefixes: Mapping[str, str] = field(default_factory=dict)
    """The prefixes of the file."""
    own: tuple[str, ...] = ()
    """Namespaces that the file describes."""
    nodes: Collection[Term] = field(default=(), repr=False)
    """Nodes of the file: elements of different kinds that share a name are told apart."""
    kinds: Collection[str] = field(default=(), repr=False)
    """Tags of elements that are spoken of by name alone, where no other one has it."""

    def term(self, term: Term) -> str:
        """Return *term* without the quotes, brackets and datatypes of N-Triples, in one line."""
        if is_blank(term):
            return "an anonymous node"
        if is_literal(term):
            number = literal_datatype(term) in NUMBERS
            return _short(_number(term) if number else literal_value(term))
        return _short(self.iri(iri_value(term)))

    def iri(self, iri: str) -> str:
        """*iri* by its local name or a prefix, whichever the file would write; else whole."""
        if is_address(iri):
            name, path = split(iri)
            return unquote(self._path(path) if path else name)
        if iri.startswith(XML):
            local = iri.partition("#")[2]
            return COMPONENT.sub("", local) if iri.startswith(ATTRIBUTE) else local
        if iri.startswith(BARE):
            return iri.replace("#", "/").rstrip("/").rpartition("/")[2]
        fitting = [
            (namespace, prefix)
            for prefix, namespace in self.prefixes.items()
            if namespace and iri.startswith(namespace) and iri != namespace
        ]
        if fitting:
            namespace, prefix = max(fitting)
            return f"{prefix}:{iri[len(namespace) :]}"
        base = max((each for each in self.own if iri.startswith(each)), key=len, default="")
        return iri[len(base) :] or iri

    def _path(self, path: str) -> str:
        """Return the names on the path to an element, or its lifted node, with kinds if needed."""
        owner = unordered(owner_path(path, self.kinds))
        shared = short_path(owner, self.kinds) in self._shared
        return path.removeprefix("/") if shared else short_path(path, self.kinds)

    @cached_property
    def _shared(self) -> frozenset[str]:
        """The names that several elements of the file have."""
        paths = (
            split(iri_value(node))[1].removeprefix("/") for node in self.nodes if is_address(node)
        )
        # A path to a named element ends in a tag and the name, which is told apart sooner.
        likely = (
            path for path in paths if path.rpartition("/")[0].rpartition("/")[2] in self.kinds
        )
        named = (path for path in likely if owner_path(path, self.kinds) == path)
        counts = Counter(short_path(unordered(path), self.kinds) for path in named)
        return frozenset(name for name, count in counts.items() if count > 1)

    def triple(self, triple: Triple) -> str:
        """Return *triple* as a phrase."""
        subject, predicate, value = triple
        if predicate == RDF_TYPE:
            return f"{self.term(subject)} is {article(self.term(value))}"
        return f"{self.term(subject)} {self.term(predicate)} {self.term(value)}"


def article(noun: str) -> str:
    """Return *noun* with its indefinite article."""
    sound = noun.lower()
    vowel = sound.startswith(("a", "e", "i", "o", "u")) and not sound.startswith(("uni", "use"))
    return f"{'an' if vowel else 'a'} {noun}"


def _short(text: str) -> str:
    """Return *text* with escaped control characters, without its middle if it is very long."""
    if len(text) > LONGEST:
        text = f"{text[: LONGEST - TAIL]}…{text[-TAIL:]}"
    if text.isprintable():
        return text
    return "".join(char if char.isprintable() else _escape(char) for char in text)


def _escape(char: str) -> str:
    named = {"\n": "\\n", "\r": "\\r", "\t": "\\t"}
    return named.get(char) or f"\\u{ord(char):04x}"


def _number(term: Term) -> str:
    text = literal_value(term)
    try:
        number = float(text)
    except ValueError:
        return text
    if literal_datatype(term).endswith("integer"):
        return text
    return f"{number:.15g}"
