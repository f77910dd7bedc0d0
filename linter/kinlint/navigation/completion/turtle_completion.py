"""Completion in Turtle: prefixed names of nodes, classes, properties and units."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from kinlint.navigation.completion.candidate import NOTHING, Candidate, Completions, Kind
from kinlint.navigation.completion.graph_values import TYPE, GraphValues
from kinlint.navigation.completion.situation import Situation
from kinlint.text import Span

_PREFIX = re.compile(r"(?im)^\s*@?prefix\s+([\w.-]*):\s*<([^<>\s]*)>")
_STEP = re.compile(
    r"""(?:[ \t\r\n]|\#[^\r\n]*)+ | <[^<>\s]*> | \"{3}.*?(?:\"{3}|\Z) | '{3}.*?(?:'{3}|\Z)
    | "(?:[^"\\\r\n]|\\.)*"? | '(?:[^'\\\r\n]|\\.)*'? | @[a-zA-Z-]+ | \^\^
    | [.;,\[\]()](?=\s|\Z|[\[\]();,.<"]) | [^\s;,\[\]()"'<>]*[^\s;,\[\]()"'<>.] | .""",
    re.VERBOSE | re.DOTALL,
)
_LOCAL = re.compile(r"[\w.-]*\w|")
_REST = re.compile(r"[\w:-]*")
SUBJECT, PREDICATE, OBJECT = range(3)


def complete(situation: Situation) -> Completions:
    """Return what can be written at the place of *situation*, in a file of Turtle."""
    text, offset = situation.source.text, situation.offset
    place = _Place(text[:offset])
    if place.in_comment:
        return NOTHING
    prefixes = {match[2]: match[1] for match in _PREFIX.finditer(text)}
    meanings = {prefix: iri for iri, prefix in prefixes.items()}
    graph = GraphValues(situation, lambda iri: _spelled(iri, prefixes))
    rest = _REST.match(text, offset)
    end = rest.end() if rest else offset
    if place.partial[:1] in ('"', "'") and text[end : end + 1] == place.partial[0]:
        end += 1
    span = Span(offset - len(place.partial), end)
    types = [_expanded(each, meanings) for each in place.types]
    if place.role == OBJECT:
        found = _objects(graph, _expanded(place.predicate, meanings), types, place.partial)
    elif place.role == PREDICATE:
        found = _predicates(graph, types, prefixes)
    else:
        found = graph.undescribed()
    return Completions.from_candidates(found, span)


class _Place:
    """The end of *text* as a place in a statement."""

    def __init__(self, text: str) -> None:
        self.role = SUBJECT
        self.predicate = ""
        self.types: list[str] = []
        self.partial = ""
        self.in_comment = False
        outer: list[tuple[str, list[str]]] = []
        for match in _STEP.finditer(text):
            mark = match[0]
            ends = match.end() == len(text)
            if mark[0] in " \t\r\n#":
                last = mark.rpartition("\n")[2]
                self.in_comment = ends and "#" in last
            elif mark == ".":
                self.role, self.predicate, self.types = SUBJECT, "", []
                outer = []
            elif mark == ";":
                self.role = PREDICATE
            elif mark == "[":
                outer.append((self.predicate, self.types))
                self.role, self.predicate, self.types = PREDICATE, "", []
            elif mark == "]":
                self.predicate, self.types = outer.pop() if outer else ("", [])
                self.role = OBJECT if self.predicate else PREDICATE
            elif mark not in (",", "(", ")"):
                self._name(mark, ends=ends)

    def _name(self, token: str, *, ends: bool) -> None:
        if ends:
            self.partial = token
        elif self.role == SUBJECT:
            self.role = PREDICATE
        elif self.role == PREDICATE:
            self.predicate, self.role = token, OBJECT
        elif self.predicate in ("a", "rdf:type"):
            self.types = [*self.types, token]


def _objects(
    graph: GraphValues, predicate: str, types: Sequence[str], partial: str
) -> Iterator[Candidate]:
    for each in graph.values(predicate, types):
        if each.kind in (Kind.RULE, Kind.WORD):
            yield each._replace(text=f'"{each.label}"')
        elif not partial.startswith(('"', "'")):
            yield each


def _predicates(
    graph: GraphValues, types: Sequence[str], prefixes: dict[str, str]
) -> Iterator[Candidate]:
    above, used = graph.vocabulary.above(types), graph.used_with(types)
    yield Candidate("a", Kind.ATTRIBUTE, "classes of the node", 0 if not types else 2, "a ")
    for name in graph.vocabulary.said:
        if graph.vocabulary.is_property(name):
            written = _spelled(name, prefixes)
            if written is not None:
                fits = graph.vocabulary.belongs(name, above)
                rank = 0 if fits else 1 if name in used else 2
                detail = graph.vocabulary.describe(name)
                yield Candidate(written, Kind.ATTRIBUTE, detail, rank)


def _expanded(name: str, meanings: dict[str, str]) -> str:
    if name == "a":
        return TYPE
    if name.startswith("<"):
        return name[1:-1]
    prefix, _, local = name.partition(":")
    return f"{meanings.get(prefix, prefix)}{local}"


def _spelled(iri: str, prefixes: dict[str, str]) -> str | None:
    """Return *iri* with one of *prefixes*; None if none fits."""
    best = max((each for each in prefixes if iri.startswith(each)), key=len, default=None)
    if best is None or not _LOCAL.fullmatch(local := iri[len(best) :]):
        return None
    return f"{prefixes[best]}:{local}"
