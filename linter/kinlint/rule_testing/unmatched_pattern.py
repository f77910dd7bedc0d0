"""The first part of a rule's query that an example does not match."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from itertools import count
from pathlib import Path

from kinlint.catalogue.repair_file import prefixes
from kinlint.catalogue.rulebook import PREFIXES
from kinlint.catalogue.variable_checks import Variables, selects
from kinlint.document import Document
from kinlint.engine.compiler.shacl_terms import sh
from kinlint.engine.compiler.shape import target_shapes
from kinlint.engine.compiler.shapes_graph import ShapesFile, ShapesGraph, parse
from kinlint.engine.compiler.target import target
from kinlint.engine.store import Store
from kinlint.resources import data
from kinlint.rule import Rule
from kinlint.sparql.ast import Element, Filter, Group, Select, Triples, render
from kinlint.sparql.patterns import patterns
from kinlint.sparql.tokens import split
from kinlint.terms import Term, is_iri
from kinlint.text import Span

THIS = "?this"
INTERNAL = re.compile(r"\?k_\w+")
"""Variables that stand for blank nodes, and for the nodes between the steps of a path."""


def unmatched(rule: Rule, documents: Sequence[Document], store: Store, mark: Span) -> str | None:
    """Return why no query of *rule* finds anything at *mark*; None if nobody can tell.

    *store* has what is known of *documents*, of which the first has the *mark*.
    """
    file = parse(Path(rule.path), rule.name)
    graph = ShapesGraph((parse(data("shapes") / PREFIXES), file))
    found = []
    for shape in target_shapes(graph):
        if graph.home(shape.node) is not file:
            continue
        targets = target(shape, THIS).all
        nodes = [row["this"] for row in store.rows(f"SELECT DISTINCT ?this {{ {targets} }}")]
        if not nodes:
            found.append("nothing in the example is a target of the rule")
            continue
        focus = _focus(nodes, documents[0], mark)
        for query in selects(file, prefixes()):
            if query.query.node in graph.values(shape.node, sh("sparql")):
                found += _query(file, query, targets, focus, store)
    return "; ".join(dict.fromkeys(found)) or None


def _focus(nodes: Sequence[Term], document: Document, mark: Span) -> list[Term]:
    """Return those of *nodes* whose description in *document* has *mark*; none if none has."""
    places = document.map.nodes
    return [
        node
        for node in nodes
        if node in places
        and places[node].whole.start <= mark.start
        and mark.end <= places[node].whole.end
    ]


def _query(
    file: ShapesFile, query: Variables, targets: str, focus: Sequence[Term], store: Store
) -> Iterator[str]:
    """Yield the first part of *query* that none of *focus* matches, or no target without any."""
    named = [node for node in focus if is_iri(node)]
    start = f"VALUES {THIS} {{ {' '.join(named)} }}" if named else f"{{ {targets} }}"
    kept: list[str] = []
    for element in _ordered(query.select):
        kept.append(f"{render(element)}{' .' if isinstance(element, Triples) else ''}")
        text = f"ASK {{ {start} {' '.join(kept)} }}"
        if "?PATH" in text:
            return
        if not store.query(text):
            told = readable(render(element), prefixes())
            line = file.text.count("\n", 0, _place(file, query, element)) + 1
            fault = "is never true" if isinstance(element, Filter) else "matches nothing"
            more = " together with what precedes it" if len(kept) > 1 else ""
            yield f"line {line}: {told} {fault}{more}"
            return


def _ordered(select: Select) -> Iterator[Element]:
    """Yield the parts of *select*, its triple patterns one by one, its filters at the end."""
    elements = _flat(select.group)
    yield from (each for each in elements if not isinstance(each, Filter))
    yield from (each for each in elements if isinstance(each, Filter))


def _flat(group: Group) -> list[Element]:
    found: list[Element] = []
    names = count(9000)
    for element in group.elements:
        if isinstance(element, Triples):
            found += [Triples((each.text,)) for each in patterns(element.tokens, names)]
        else:
            found.append(element)
    return list(dict.fromkeys(found))


def _place(file: ShapesFile, query: Variables, element: Element) -> int:
    """Return where *element* stands in *file*: at the longest run of its words there."""
    known = prefixes()
    words = [each.text for each in split(readable(render(element), known))]
    found = split(query.query.text)
    spelled = [each.text.replace("$", "?", 1) for each in found]
    longest, place = 0, 0
    for at in range(len(spelled)):
        for first in range(len(words)):
            run = 0
            for one, other in zip(spelled[at:], words[first:], strict=False):
                if one != other:
                    break
                run += 1
            if run > longest:
                longest, place = run, found[at].start
    return query.query.place(file.text, place)


def readable(text: str, known: Mapping[str, str]) -> str:
    """Return the SPARQL *text* with prefixes, and `[]` for variables that nobody wrote."""
    for prefix, namespace in known.items():
        text = re.sub(f"<{re.escape(namespace)}([\\w-]+)>", rf"{prefix}:\1", text)
    return INTERNAL.sub("[]", text).replace(" [ ] ", " [] ")
