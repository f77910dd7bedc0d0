"""The triples of an ontology, indexed for those who compile its axioms."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

import pyoxigraph as ox

from kinlint.engine.axioms import Pattern, name
from kinlint.engine.literal_spelling import normal
from kinlint.errors import RuleInvalid
from kinlint.terms import RDF, RDF_TYPE, XSD, Term, Triple
from kinlint.vocabulary import OWL, RDFS

INVERSE = f"<{OWL}inverseOf>"
DATATYPES = (f"<{XSD}", f"<{RDFS}Literal>", f"<{RDF}langString>", f"<{RDF}PlainLiteral>")


class Schema:
    """The statements of an ontology, indexed by predicate."""

    def __init__(self, triples: Iterable[Triple]) -> None:
        self.triples = tuple(triples)
        self._pairs: dict[Term, list[tuple[Term, Term]]] = {}
        for subject, predicate, value in self.triples:
            self._pairs.setdefault(predicate, []).append((subject, value))

    @classmethod
    def read(cls, files: Iterable[Path]) -> Schema:
        """Return the schema in Turtle *files*; `RuleInvalid` if one is no Turtle."""
        triples: list[Triple] = []
        for file in files:
            try:
                # Two files may use one label for different blank nodes.
                base = file.absolute().as_uri()
                quads = ox.parse(
                    path=file, format=ox.RdfFormat.TURTLE, base_iri=base, rename_blank_nodes=True
                )
                triples += [
                    (str(q.subject), str(q.predicate), normal(str(q.object))) for q in quads
                ]
            except SyntaxError as error:
                raise RuleInvalid(f"{file}:{error.lineno}: {error.msg}") from error
        return cls(triples)

    def pairs(self, predicate: Term) -> list[tuple[Term, Term]]:
        """Return the subjects and objects that *predicate* relates."""
        return self._pairs.get(predicate, [])

    def objects(self, subject: Term, predicate: Term) -> list[Term]:
        """Return the values of *predicate* for *subject*."""
        return [value for each, value in self.pairs(predicate) if each == subject]

    def instances(self, kind: Term) -> list[Term]:
        """Return the subjects of type *kind*."""
        return [each for each, value in self.pairs(RDF_TYPE) if value == kind]

    def list(self, node: Term) -> tuple[Term, ...]:
        """Return the members of the RDF list that begins at *node*."""
        members: list[Term] = []
        while first := self.objects(node, f"<{RDF}first>"):
            members.append(first[0])
            node = next(iter(self.objects(node, f"<{RDF}rest>")), "")
        return tuple(members)

    def is_datatype(self, kind: Term) -> bool:
        """Tell whether members of *kind* are literals."""
        return kind.startswith(DATATYPES) or kind in self.instances(f"<{RDFS}Datatype>")

    def arc(self, relation: Term, start: Term, end: Term) -> Pattern:
        """Return *start* has *end* as *relation*, which may be an anonymous inverse."""
        if relation.startswith("_:"):
            for inverse in self.objects(relation, INVERSE):
                return end, inverse, start
        return start, relation, end

    def phrase(self, relation: Term) -> str:
        """Return *relation* in words."""
        if relation.startswith("_:"):
            return "inverse of " + " or ".join(map(name, self.objects(relation, INVERSE)))
        return name(relation)
