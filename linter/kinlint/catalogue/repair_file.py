"""Reads the repairs of a rule file and takes their SPARQL Updates apart."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cache
from pathlib import Path
from textwrap import dedent
from typing import TYPE_CHECKING

from kinlint import resources
from kinlint.errors import RuleInvalid
from kinlint.model import KNOWN, Applicability, Repair
from kinlint.terms import Term, Triple, blank, iri, is_blank, literal
from kinlint.vocabulary import DASH, KL, RDFS, SH

if TYPE_CHECKING:
    from rdflib import Graph
    from rdflib.term import Node

APPLICABILITY = {
    f"{KL}safe": Applicability.SAFE,
    f"{KL}unsafe": Applicability.UNSAFE,
    f"{KL}displayOnly": Applicability.DISPLAY,
}
SKIPPED = re.compile(
    r"""(?:"{3}.*?"{3}|'{3}.*?'{3}|"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)*')|<[^<>\s]*>|\#[^\n]*""",
    re.DOTALL,
)
NAME = re.compile(r"(?<![\w?$:.-])([A-Za-z][\w.-]*):([A-Za-z_][\w-]*)")
VARIABLE = re.compile(r"[?$]([A-Za-z_]\w*)")


def read_repairs(graph: Graph, rule: Node, file: Path) -> tuple[Repair, ...]:
    """The repairs that *file* gives its *rule*, the preferred first.

    Raises `RuleInvalid` for an update that is no SPARQL, or not one DELETE/INSERT operation.
    """
    from rdflib import URIRef  # noqa: PLC0415

    nodes = graph.objects(rule, URIRef(f"{DASH}suggestionGenerator"))
    found = [_repair(graph, node, file) for node in nodes]
    return tuple(sorted(found, key=lambda each: (each.order, each.title, each.update)))


def _repair(graph: Graph, node: Node, file: Path) -> Repair:
    from rdflib import URIRef  # noqa: PLC0415

    def values(predicate: str) -> list[str]:
        return sorted(str(value) for value in graph.objects(node, URIRef(predicate)))

    def value(predicate: str) -> str:
        return next(iter(values(predicate)), "")

    title, claimed, said = value(f"{RDFS}label"), value(f"{KL}applicability"), value(f"{SH}update")
    if not title or claimed not in APPLICABILITY or not said:
        raise RuleInvalid(f"{file}: a repair has rdfs:label, kl:applicability and sh:update")
    update = f"{_header(said)}\n{said.strip()}\n"
    removed, added = _templates(update, title, file)
    variables = tuple(sorted(set(VARIABLE.findall(SKIPPED.sub(" ", said)))))
    names = " ".join(f"?{name}" for name in variables) or "*"
    return Repair(
        title=title,
        applicability=APPLICABILITY[claimed],
        update=dedent(said).strip(),
        query=f"{_header(said)}\nSELECT DISTINCT {names} {{ {KNOWN} LATERAL {_where(said)} }}",
        variables=variables,
        removed=removed,
        added=added,
        terms=tuple(sorted(_terms(said))),
        why=" ".join(value(f"{RDFS}comment").split()),
        formats=tuple(values(f"{KL}format")),
        order=float(value(f"{SH}order") or 0),
    )


@cache
def _prefixes() -> Mapping[str, str]:
    """The prefixes that all rules share."""
    from rdflib import Graph, URIRef  # noqa: PLC0415

    shared = Graph().parse(resources.data("shapes") / "prefixes.ttl", format="turtle")
    return {
        str(shared.value(node, URIRef(f"{SH}prefix"))): str(
            shared.value(node, URIRef(f"{SH}namespace"))
        )
        for node in shared.objects(URIRef(f"{KL}prefixes"), URIRef(f"{SH}declare"))
    }


def _header(update: str) -> str:
    """The prefixes that *update* uses and does not declare itself."""
    bare = SKIPPED.sub(" ", update)
    return "\n".join(
        f"PREFIX {prefix}: <{namespace}>"
        for prefix, namespace in sorted(_prefixes().items())
        if re.search(rf"(?<![\w.-]){re.escape(prefix)}:", bare)
    )


def _terms(update: str) -> Iterator[Term]:
    """The IRIs that *update* writes with a prefix."""
    known = _prefixes()
    for prefix, local in set(NAME.findall(SKIPPED.sub(" ", update))):
        if prefix in known:
            yield iri(known[prefix] + local)


def _templates(
    update: str, title: str, file: Path
) -> tuple[tuple[Triple, ...], tuple[Triple, ...]]:
    from rdflib.plugins.sparql.algebra import translateUpdate  # noqa: PLC0415
    from rdflib.plugins.sparql.parser import parseUpdate  # noqa: PLC0415

    try:
        operations = translateUpdate(parseUpdate(update)).algebra
    except Exception as error:
        raise RuleInvalid(f"{file}: the update of '{title}' is no SPARQL: {error}") from error
    if len(operations) != 1 or operations[0].name != "Modify":
        raise RuleInvalid(f"{file}: the update of '{title}' is not one DELETE/INSERT … WHERE")
    removed, added = (
        _ordered(list(_tokens(operations[0][part].triples)), update)
        if part in operations[0]
        else ()
        for part in ("delete", "insert")
    )
    if any(is_blank(term) for triple in removed for term in triple):
        raise RuleInvalid(f"{file}: the update of '{title}' deletes a blank node by its label")
    return removed, added


def _ordered(triples: Sequence[Triple], update: str) -> tuple[Triple, ...]:
    """*triples* by where the text of *update* first has their properties: parsing loses it.

    What is said of a blank node, which parsing calls at random, follows what leads to it.
    """
    words = update[update.upper().find("INSERT") :]
    places = {p: _place(re.split(r"[#/]", p.strip("<>"))[-1], words) for _, p, _ in triples}
    about: dict[Term, list[Triple]] = {}
    for triple in triples:
        about.setdefault(triple[0], []).append(triple)

    def shape(term: Term) -> str:
        """What is said of a blank node, and of those within; other terms as they are."""
        if not is_blank(term):
            return term
        said = sorted((places[p], p, shape(value)) for _, p, value in about.get(term, ()))
        return f"[{said}]"

    def key(triple: Triple) -> tuple[int, str, str, str]:
        return places[triple[1]], triple[1], shape(triple[2]), shape(triple[0])

    inner = {value for _, _, value in triples if is_blank(value)}
    todo = sorted((each for each in triples if each[0] not in inner), key=key, reverse=True)
    ordered: list[Triple] = []
    while todo:
        triple = todo.pop()
        ordered.append(triple)
        todo += sorted(about.get(triple[2], ()) if is_blank(triple[2]) else (), key=key)[::-1]
    ordered = list(dict.fromkeys(ordered))
    names = {label: blank(str(n)) for n, label in enumerate(dict.fromkeys(_blanks(ordered)))}
    return tuple((names.get(s, s), p, names.get(o, o)) for s, p, o in ordered)


def _place(name: str, text: str) -> int:
    """Where *text* first has *name* as a whole word; -1 if nowhere."""
    found = re.search(rf"(?<![\w-]){re.escape(name)}(?![\w-])", text)
    return found.start() if found else -1


def _blanks(triples: Iterable[Triple]) -> Iterator[Term]:
    return (term for triple in triples for term in triple if is_blank(term))


def _tokens(triples: Iterable[tuple[Node, Node, Node]]) -> Iterator[Triple]:
    for subject, predicate, value in triples:
        yield _token(subject), _token(predicate), _token(value)


def _token(node: Node) -> Term:
    from rdflib import BNode, Literal, Variable  # noqa: PLC0415

    if isinstance(node, Variable):
        return f"?{node}"
    if isinstance(node, BNode):
        return blank(str(node))
    if isinstance(node, Literal):
        return literal(str(node), str(node.datatype or ""), node.language or "")
    return iri(str(node))


def _where(update: str) -> str:
    """The text of the group after WHERE, braces included; an empty group if there is none."""
    bare = SKIPPED.sub(lambda match: " " * len(match[0]), update)
    found = re.search(r"\bWHERE\s*\{", bare, re.IGNORECASE)
    if found is None:
        return "{}"
    depth, start = 0, found.end() - 1
    for at in range(start, len(bare)):
        depth += {"{": 1, "}": -1}.get(bare[at], 0)
        if not depth:
            return update[start : at + 1]
    return update[start:]
