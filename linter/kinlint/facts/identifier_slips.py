"""Identifiers that nothing describes with the names they resemble, and names for nameless nodes."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from functools import cached_property
from typing import TypeAlias

from kinlint.document import Document
from kinlint.facts.dangling_references import DIGITS, MOST
from kinlint.facts.fact_statements import fact
from kinlint.facts.metamodel_terms import kin
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.file_format import Format
from kinlint.suggestion import LOOKED_UP, distance
from kinlint.terms import RDF_TYPE, Term, Triple, iri, iri_value, is_blank, is_iri
from kinlint.vocabulary import RDFS, SH, SRC

NAMESPACE = re.compile(r"urn:[^:#/]+:[^#/]+:(?=[^:#/]+$)|.*[#/](?=[^#/]*$)")
PREDICATE = "property"
CLASS = "class"
ROLES = {
    **dict.fromkeys((RDF_TYPE, iri(f"{SH}class"), iri(f"{SH}targetClass")), CLASS),
    **{iri(SH + name): PREDICATE for name in ("path", "targetSubjectsOf", "targetObjectsOf")},
}
"""Role of a value of these properties; values of others are described by a document."""

Role: TypeAlias = str
Names: TypeAlias = dict[str, Term]


class IdentifierSlips:
    """Identifiers in the files that name things by IRIs."""

    def __init__(self, scan: PredicateIndex) -> None:
        self._scan = scan
        self._documents = [each for each in scan.documents if names_by_iri(each.format)]

    def resemblances(self) -> Iterator[Triple]:
        """Yield undescribed identifiers and undeclared terms with the one they resemble.

        A term that one other namespace declares by the same name was meant to be that.
        """
        for strange, known, role in self._compared():
            name = split(strange)[1]
            same = [
                names[name]
                for (_, other), names in self._declared.items()
                if other == role and name in names
            ]
            if len(same) == 1:
                yield strange, fact("slip-for"), same[0]
            elif (found := only_near(name, known)) is not None:
                yield strange, fact("slip-for"), known[found]

    def _compared(self) -> Iterator[tuple[Term, Names, Role | None]]:
        """Yield unknown identifiers and terms, what each could be a slip for, and its role."""
        described: dict[str, Names] = {}
        for document in self._documents:
            for node in document.map.nodes:
                if is_iri(node):
                    space, name = split(node)
                    described.setdefault(space, {})[name] = node
        declared = self._declared
        seen: dict[tuple[Term, Role], None] = {}
        for document in self._documents:
            seen.update(dict.fromkeys(_mentioned(document)))
        strange = []
        for term, role in seen:
            space, name = split(term)
            known = declared.get((space, role)) if role else described.get(space)
            if known and name not in known:
                strange.append((term, known, role))
        yield from strange[:LOOKED_UP]

    @cached_property
    def _declared(self) -> Mapping[tuple[str, Role], Names]:
        """Terms that contexts declare, by namespace and role."""
        found: dict[tuple[str, Role], Names] = {}
        values = self._scan.table(kin("values"))
        spaces = {
            space[1:].rpartition('"')[0]
            for _, several in self._scan.table(kin("namespace")).items()
            for space in several
        }
        for term, contexts in self._scan.table(iri(f"{RDFS}isDefinedBy")).items():
            if contexts and is_iri(term) and (parts := split(term))[0] in spaces:
                role = PREDICATE if term in values else CLASS
                found.setdefault((parts[0], role), {})[parts[1]] = term
        return found

    def free_names(self) -> Iterator[Triple]:
        """Yield for each anonymous node with a type a free name in its file's own namespace.

        It is made of the type that stands first, and a number; a file that describes things in
        several namespaces gives none.
        """
        taken = {term for each in self._documents for term, _ in _mentioned(each)}
        taken.update(node for each in self._documents for node in each.map.nodes)
        counts: Counter[str] = Counter()
        for document in self._documents:
            space = _own_namespace(document)
            types: dict[Term, Term] = {}
            for subject, predicate, value in document.statements:
                if predicate == RDF_TYPE and is_blank(subject) and _is_class(value):
                    types.setdefault(subject, value)
            for node, kind in types.items() if space else ():
                stem = f"{space}{kebab(split(kind)[1])}"
                while (name := iri(f"{stem}-{counts[stem] + 1}")) in taken:
                    counts[stem] += 1
                counts[stem] += 1
                yield node, fact("free-name"), name


def split(term: Term) -> tuple[str, str]:
    """Return the namespace of an IRI, and the rest."""
    whole = iri_value(term)
    found = NAMESPACE.match(whole)
    end = found.end() if found else 0
    return whole[:end], whole[end:]


def kebab(name: str) -> str:
    """Return *name* in small letters, with hyphens where words begin."""
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "-", name).casefold()


def only_near(name: str, known: Iterable[str]) -> str | None:
    """Return the one of *known* that *name* is a slip for, if it is nearer than all others."""
    digits = DIGITS.findall(name)
    alike = sorted(
        (distance(name.casefold(), each.casefold(), MOST), each)
        for each in known
        if abs(len(each) - len(name)) <= MOST and DIGITS.findall(each) == digits
    )
    if not alike or alike[0][0] > min(MOST, (len(name) - 1) // 2):
        return None
    return alike[0][1] if len(alike) == 1 or alike[1][0] > alike[0][0] else None


def _mentioned(document: Document) -> Iterator[tuple[Term, Role]]:
    """Yield the IRIs that *document* mentions, with their roles: property, class or none."""
    for _, predicate, value in document.statements:
        if predicate.startswith(f"<{SRC}"):
            continue
        yield predicate, PREDICATE
        if is_iri(value):
            yield value, ROLES.get(predicate, "")


def _is_class(kind: Term) -> bool:
    """Tell whether a type is one of the model, not of its notation."""
    return is_iri(kind) and not kind.startswith(f"<{SRC}")


def _own_namespace(document: Document) -> str:
    """Return the one namespace in which *document* describes things; else nothing."""
    own = iri(f"{SRC}ownNamespace")
    spaces = [value for _, predicate, value in document.statements if predicate == own]
    return spaces[0][1:].rpartition('"')[0] if len(spaces) == 1 else ""


def names_by_iri(form: Format) -> bool:
    """Tell whether people write files of *form* and name things in them by IRIs."""
    return not form.is_tree and form.editor is not None
