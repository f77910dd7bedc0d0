"""The lifted statements as nodes of expanded JSON-LD, in the order of the files they come from."""

from __future__ import annotations

import math
import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from decimal import Decimal
from typing import Any, TypeAlias

from kinlint.conversion.published import published_terms
from kinlint.document import FROM, Document
from kinlint.terms import (
    NUMERIC,
    RDF,
    RDF_TYPE,
    XSD,
    Term,
    Triple,
    iri,
    iri_value,
    is_blank,
    is_literal,
    literal_datatype,
    literal_value,
)
from kinlint.vocabulary import KIN, METAMODELS

Node: TypeAlias = dict[str, Any]

FIRST, REST = iri(f"{RDF}first"), iri(f"{RDF}rest")
GEOMETRY = f"{METAMODELS}geometry/structural-entities#"
PARENT = iri(f"{KIN}parent-attachment")
SIMPLICES = iri(f"{GEOMETRY}simplices")
PARTS = tuple(iri(GEOMETRY + part) for part in ("origin", "vector-x", "vector-y", "vector-z"))
CHAIN = f"{METAMODELS}kinematic-chain/structural-entities#"
OWNERS = frozenset(
    {
        f"{GEOMETRY}SimplicialComplex",
        f"{CHAIN}Joint",
        f"{CHAIN}KinematicChain",
    }
)
"""Classes of nodes whose names begin those of the nodes that belong to them."""
_DIGITS = re.compile(r"(\d+)")


class Statements:
    """The domain statements of a lift by subject, with the element that each subject is from.

    A body that lists a frame lists its origin and its axes, too.
    """

    def __init__(self, triples: Iterable[Triple]) -> None:
        self.said: dict[Term, dict[Term, list[Term]]] = {}
        self.origins: dict[Term, list[Term]] = {}
        self.parents: dict[Term, Term] = {}
        """The attachment of each joint on its parent."""
        known = published_terms()
        for s, p, o in triples:
            if p == FROM:
                self.origins.setdefault(s, []).append(o)
                continue
            if p == PARENT:
                self.parents[s] = o
            term = o if p == RDF_TYPE else p
            if is_blank(s) or iri_value(term) in known:
                self.said.setdefault(s, {}).setdefault(p, []).append(o)
        for body in self.said.values():
            for frame in tuple(body.get(SIMPLICES, ())):
                body[SIMPLICES] += self._parts(frame, body[SIMPLICES])

    def _parts(self, frame: Term, listed: Collection[Term]) -> list[Term]:
        """The origin and axes of *frame* that are not *listed*."""
        said = self.said.get(frame, {})
        parts = (part for predicate in PARTS for part in said.get(predicate, ()))
        return [part for part in parts if part not in listed]

    @property
    def subjects(self) -> list[Term]:
        """Return the nodes with a name and a type."""
        return [s for s, said in self.said.items() if not is_blank(s) and RDF_TYPE in said]

    def items(self, head: Term) -> list[Term]:
        """The items of the list at *head*."""
        found = []
        while is_blank(head):
            said = self.said[head]
            found.append(said[FIRST][0])
            head = said[REST][0]
        return found


class Order:
    """Nodes sorted by where the body or joint they belong to is written, and then by name."""

    def __init__(self, statements: Statements, documents: Sequence[Document]) -> None:
        self.statements = statements
        self.documents = documents
        subjects = statements.subjects
        self.owners = {s for s in subjects if not OWNERS.isdisjoint(self._types(s))}
        self._places = {owner: self._place(owner) for owner in self.owners}
        self._owner_of: dict[Term, Term] = {}
        ranked = sorted(subjects, key=self._key)
        self.ranks = {subject: number for number, subject in enumerate(ranked)}

    def _types(self, subject: Term) -> set[str]:
        return {iri_value(each) for each in self.statements.said[subject][RDF_TYPE]}

    def owner(self, node: Term) -> Term:
        """The body, joint or chain whose name the name of *node* continues, or *node* itself."""
        if node not in self._owner_of:
            self._owner_of[node] = next(filter(self.owners.__contains__, _above(node)), node)
        return self._owner_of[node]

    def _place(self, owner: Term) -> tuple[int, int, int]:
        chain = f"{CHAIN}KinematicChain" in self._types(owner)
        for number, document in enumerate(self.documents):
            for element in self.statements.origins.get(owner, ()):
                if element in document.map.nodes:
                    return number, int(chain), document.map.nodes[element].whole.start
        return len(self.documents), int(chain), 0

    def _key(self, node: Term) -> tuple[Any, ...]:
        owner = self.owner(node)
        place = self._places.get(owner, (len(self.documents), 0, 0))
        return place, _natural(owner), _natural(node)

    def values(self, node: Term, values: Iterable[Term]) -> list[Term]:
        """Return the *values* of a property of *node*: its own parts first, then the parent's."""
        last = len(self.ranks)
        own = self.owner(node)
        parent = self.statements.parents.get(own, own)[:-1]

        def key(each: Term) -> tuple[bool, bool, int, Term]:
            foreign = self.owner(each) != own
            return foreign, not each.startswith(parent), self.ranks.get(each, last), each

        return sorted(values, key=key)


def _above(node: Term) -> Iterator[Term]:
    """*node*, and each that its name continues."""
    space, _, local = node[1:-1].partition("#")
    while local:
        yield f"<{space}#{local}>"
        local = local.rpartition("/")[0]


def _natural(name: str) -> list[tuple[int, int | str]]:
    """Sorts numbers in names as numbers, and what belongs to a thing after the thing."""
    return [
        (0, int(part)) if part.isdecimal() else (1, part)
        for part in _DIGITS.split(name.rstrip(">").replace("/", "\0"))
    ]


def expanded_nodes(
    statements: Statements, order: Order, names: Mapping[str, str]
) -> Iterator[Node]:
    """Each subject as a node; *names* has the namespace for each document."""
    for subject in sorted(statements.subjects, key=order.ranks.__getitem__):
        made: Node = {"@id": absolute_iri(subject, names)}
        for predicate, values in sorted(statements.said[subject].items()):
            if predicate == RDF_TYPE:
                made["@type"] = sorted(map(iri_value, values))
                continue
            name = iri_value(predicate)
            made[name] = [
                _value(statements, each, name, names) for each in order.values(subject, values)
            ]
        yield made


def absolute_iri(term: Term, names: Mapping[str, str]) -> str:
    """The IRI of *term* in the namespaces of the result."""
    value = iri_value(term)
    space, mark, local = value.partition("#")
    return names[space] + local if mark and space in names else value


def _value(statements: Statements, term: Term, predicate: str, names: Mapping[str, str]) -> Node:
    if is_literal(term):
        return _literal(term, published_terms()[predicate].coercion)
    if is_blank(term) or term == iri(f"{RDF}nil"):
        items = statements.items(term)
        return {"@list": [_value(statements, each, predicate, names) for each in items]}
    return {"@id": absolute_iri(term, names)}


def _literal(term: Term, coercion: str) -> Node:
    """A literal such that a context which coerces its property to *coercion* writes it plainly."""
    text, datatype = literal_value(term), literal_datatype(term)
    if datatype not in NUMERIC:
        return {"@value": text}
    number = float(text)
    if not math.isfinite(number):
        return {"@value": text, "@type": datatype}
    if coercion == "xsd:decimal":
        return {"@value": f"{Decimal(repr(number)):f}", "@type": f"{XSD}decimal"}
    plain = int(text) if datatype.endswith("integer") else number
    return {"@value": plain, "@type": f"{XSD}double"} if coercion else {"@value": plain}
