"""Fills message templates with the words of the author: names as written, elements by their tag.

A node that was made of an element of XML is called by that element, `<limit> of joint 'elbow'`,
and never by the address that only the graph has.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from typing import TypeGuard

from kinlint.addresses import document_of, is_element, local_name, unordered, way_out
from kinlint.document import Document
from kinlint.findings.brief_numbers import DIGITS, MOST_DIGITS, brief
from kinlint.findings.locator import Locator, Source
from kinlint.light_dataclasses import dataclass
from kinlint.message_template import VARIABLE
from kinlint.term_format import NUMBERS, TermFormatter
from kinlint.terms import (
    Term,
    Triple,
    iri,
    iri_value,
    is_blank,
    is_iri,
    is_literal,
    literal_datatype,
    literal_value,
)
from kinlint.text import Location
from kinlint.vocabulary import ATTRIBUTE, FACT, SRC

KINDS = frozenset(
    {"actor", "body", "frame", "group", "joint", "light", "link", "macro", "model", "prim", "world"}
)
"""Elements that are spoken of by kind and name: joint 'elbow'."""

FACT_NODE = re.compile(r"urn:kinlint:fact:([\w-]+):0*(\d+)")
"""The IRI of a computed node: its kind and number."""

PART = "<urn:kinlint:fact:component:"
"""The beginning of the IRI of a computed part of a chain."""
MEMBER = iri(f"{FACT}member")
DEFINED = iri(f"{SRC}term")
"""The property of a definition that has the prefix or term."""
NAMESPACE = iri(f"{SRC}namespace")
"""The property of the definition of a prefix that has what it stands for."""

TEXT = f"<{SRC}text"
"""Beginning of the property of the text of an element, and those of the words in it."""

NUMERIC = re.compile(r"[-+]?(?:\d++(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d+)?")
"""A number as attributes hold it."""

SYNONYMS = {"body": "link", "root": "link", "shape": "collision", "part": "link"}
"""Words of templates that say the kind of what is named after them."""

TOLD = frozenset({"visual", "collision", "axis2"})
"""Elements without a name that tell apart what is within them."""


@dataclass(frozen=True)
class Wording:
    """Words for the terms of a finding."""

    locator: Locator
    """The places of the run."""
    location: Location
    """The place of the finding."""
    focus: Term
    """Its focus node."""

    @cached_property
    def display(self) -> TermFormatter:
        """The abbreviations of the file."""
        return self.locator.display(self.location)

    def words(self, template: str, terms: Mapping[str, Term | None]) -> dict[str, str]:
        """Return the words for the variables of *template*: names in quotes, numbers without.

        A kind that the template names before the variable is left out: joint '{?joint}'.
        """
        before: dict[str, str] = {}
        for match in VARIABLE.finditer(template):
            before.setdefault(match[3], (match[1] or "").lower())
        found = {name: terms.get(name) for name in before}
        first = {name: self.word(term) if term else "''" for name, term in found.items()}
        words = dict(first)
        for name, term in found.items():
            kind, _, rest = first[name].partition(" '")
            if rest and before[name] and kind.endswith(SYNONYMS.get(before[name], before[name])):
                words[name] = f"'{rest}"
            elif term and (
                same := [
                    found[each]
                    for each in words
                    if first[name] == first[each] and term != found[each]
                ]
            ):
                words[name] = self._exact(term, same)
        return words

    def _exact(self, term: Term, others: Sequence[Term | None]) -> str:
        """Return *term* so that none of *others* reads the same: more digits, the whole IRI."""
        if self._is_numeric(term):
            texts = [self._digits(each) for each in (term, *others) if self._is_numeric(each)]
            for digits in range(DIGITS, MOST_DIGITS):
                short = brief(texts[0], digits)
                if all(short != brief(each, digits) for each in texts[1:]):
                    return short
            return texts[0]
        if is_iri(term) and self._element(term) is None:
            return f"'{iri_value(term)}'"
        return self.word(term)

    def word(self, term: Term) -> str:
        """Return *term* in the words of its file.

        `'rob:elbow'`, `2.5`, `<limit> of joint 'elbow'`.
        """
        if self._is_numeric(term):
            return brief(self._digits(term))
        element = self._element(term)
        if element is None:
            return f"'{self._written_as(self.focus, term) or self.display.term(term)}'"
        document, phrase = element[0], " of ".join(_phrases(*element))
        if document.graph == self._home:
            return phrase
        return f"{phrase} in '{document.source.name.replace(chr(92), '/').rpartition('/')[2]}'"

    def _is_numeric(self, term: Term | None) -> bool:
        """Tell whether *term* is a number, which in XML is a text to begin with."""
        if is_number(term):
            return True
        text = term is not None and self.in_xml and is_literal(term)
        return text and NUMERIC.fullmatch(literal_value(term or "")) is not None

    def _digits(self, term: Term | None) -> str:
        """Return all digits of a numeric *term*."""
        if is_number(term):
            return self.display.term(term)
        return literal_value(term or "")

    def statement(self, triple: Triple) -> str:
        """Return *triple* in the words of its file: `<limit> of joint 'elbow': upper 1.5`.

        Empty for a type or a reference of an element, which only the graph has in this form.
        """
        subject, property_, value = triple
        fact = property_.startswith(f"<{FACT}")
        name = iri_value(property_).removeprefix(FACT).replace("-", " ") if fact else ""
        if self._element(subject) is None:
            return self._statement(triple, name)
        if not name:
            stated = property_.startswith((f"<{ATTRIBUTE}", TEXT)) or self.locator.origins(subject)
            if not (is_literal(value) and stated):
                return ""
            name = self._written_as(subject, property_) or self.display.term(property_)
        if property_.startswith(TEXT):
            return f"{self._mention(subject)}: {self._mention(value)}"
        return f"{self._mention(subject)}: {name} {self._mention(value)}"

    def _statement(self, triple: Triple, fact: str) -> str:
        """Return *triple* about no element; *fact* is the name of its property if it is computed.

        Empty for what only the graph has.
        """
        subject, property_, value = triple
        if fact:
            if parts := self._parts(value):
                return f"{self._mention(subject)} has a part of {parts}"
            told = f"{self._mention(subject)} {fact} {self._mention(value)}"
            return "" if self._parts(subject) else told
        if is_blank(subject) and any(self.locator.store.values(subject, DEFINED)):
            told = f"{self._mention(subject)} is {self._mention(value)}"
            return told if property_ == NAMESPACE else ""
        if self._element(value) is not None:
            return ""
        return FACT_NODE.sub(r"\1 \2", self.display.triple(triple).replace(FACT, ""))

    def source(self, triple: Triple) -> str:
        """Return what has the value of a *triple* of a document, by the name it has there.

        `'upper'` is an attribute or a property, `<pose> of link 'hand'` an element with text; what
        the graph alone has is named by its subject.
        """
        subject, property_, _ = triple
        element = self._element(subject)
        if property_.startswith(f"<{SRC}") and not property_.startswith(TEXT):
            return self.word(self.locator.described(subject))
        if element is None:
            return f"'{self.display.term(property_)}'"
        path, attribute = self.locator.provenance.read_from(subject, property_)
        if attribute:
            return f"'{attribute}'"
        tags = [f"<{tag}>" for tag in reversed(path.split("/")) if tag]
        return " of ".join((*tags, *_phrases(*element)))

    def quotation(self, source: Source) -> str:
        """Return what the text at *source* says: `<pose> of link 'hand': 0 0 1`."""
        place = source.location
        return f"{self.source(source.triple)}: {' '.join(place.source[place.span].split())}"

    def _mention(self, term: Term) -> str:
        """Return *term* as a statement names it.

        Elements in words, computed numbers by their kind.
        """
        if (element := self._element(term)) is not None:
            return " of ".join(_phrases(*element))
        if is_number(term):
            return brief(self.display.term(term))
        if is_blank(term) and (prefix := next(self.locator.store.values(term, DEFINED), None)):
            return f"prefix '{literal_value(prefix)}'"
        return FACT_NODE.sub(r"\1 \2", self.display.term(term))

    def _parts(self, term: Term) -> str:
        """Return the names of what a computed part of a chain consists of; empty for the rest."""
        if not term.startswith(PART):
            return ""
        names = [
            self.display.term(each) for each in sorted(self.locator.store.values(term, MEMBER))
        ]
        return " and ".join((", ".join(names[:-1]), names[-1])) if names[1:] else "".join(names)

    def _written_as(self, subject: Term, property_: Term) -> str:
        """Return the attribute or element that a lifted *property_* of *subject* is from."""
        if self._element(subject) is not None and is_iri(property_):
            for _, triple in self.locator.provenance.property(subject, property_).written:
                element, way, _ = triple
                text = way.startswith(TEXT)
                return unordered(local_name(element)) if text else self.display.term(way)
        return ""

    @cached_property
    def in_xml(self) -> bool:
        """True if the finding is about an element, whose attributes are texts to begin with."""
        return self._element(self.focus) is not None

    @cached_property
    def _home(self) -> Term:
        """The graph of the document that the finding is about."""
        graph = document_of(self.focus)
        if graph in self.locator.store.documents:
            return graph
        document = self.locator.document(self.location)
        return document.graph if document is not None else graph

    def _element(self, term: Term) -> tuple[Document, Term] | None:
        """Return the innermost element that *term* is or was made of, and its document."""
        if not is_iri(term):
            return None
        document = self.locator.store.documents.get(document_of(term))
        if document is None:
            return None
        origins = (term, *self.locator.origins(term))
        nodes = [node for node in origins if is_element(node) and node in document.map.nodes]
        return (document, max(nodes, key=lambda node: node.count("/"))) if nodes else None


def is_number(term: Term | None) -> TypeGuard[Term]:
    """Tell whether *term* is a literal with a numeric datatype."""
    return term is not None and is_literal(term) and literal_datatype(term) in NUMBERS


def _phrases(document: Document, node: Term) -> Iterator[str]:
    """*node* and the elements that it stands in, up to the first that a name tells apart."""
    steps = list(way_out(node, document.map.nodes))
    for at, (tag, name, order) in enumerate(steps):
        if name and tag in KINDS:
            models = [each for kind, each, _ in steps[at + 1 : -1] if kind == "model"]
            yield f"{tag} '{'::'.join((*reversed(models), name))}'"
            return
        if name:
            yield f"{tag} '{name}'"
        elif not at or order or tag in TOLD:
            yield f"<{tag}> {order}".rstrip()
