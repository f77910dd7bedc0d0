"""Nodes, classes, units and words that can be values of a property in a graph."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property

from kinlint.addresses import is_address
from kinlint.navigation.completion.candidate import Candidate, Kind
from kinlint.navigation.completion.graph_vocabulary import GraphVocabulary, graph_vocabulary
from kinlint.navigation.completion.ignored_rules import codes
from kinlint.navigation.completion.situation import Situation
from kinlint.terms import RDF, RDF_TYPE, iri_value, is_iri
from kinlint.vocabulary import KIN, KL, QUDT, SRC

TYPE, UNIT_OF, KIND_OF = f"{RDF}type", f"{QUDT}unit", f"{QUDT}hasQuantityKind"
IGNORES = (f"{KL}ignore", f"{KL}rule")
SPACES = (f"{KIN}SemanticTag",)
Spell = Callable[[str], str | None]
FITTING, USUAL, OTHER = 0, 1, 3


class GraphValues:
    """Values of the model of *situation* and the vocabulary; *spell* writes IRIs as the file does.

    What cannot be spelled is left out.
    """

    def __init__(self, situation: Situation, spell: Spell) -> None:
        self._situation, self._spell = situation, spell

    @cached_property
    def vocabulary(self) -> GraphVocabulary:
        """Statements of the vocabulary about terms."""
        return graph_vocabulary(self._situation.rulebook.vocabulary)

    @cached_property
    def nodes(self) -> Mapping[str, Sequence[str]]:
        """The types of the nodes that the model describes, by IRI."""
        found: dict[str, list[str]] = {}
        for document in self._situation.documents:
            for subject, predicate, value in document.statements:
                if predicate != RDF_TYPE or value.startswith(f"<{SRC}"):
                    continue
                if is_iri(subject) and not is_address(subject):
                    found.setdefault(iri_value(subject), []).append(iri_value(value))
        return found

    def values(self, property_: str, types: Sequence[str]) -> Iterator[Candidate]:
        """Yield what *property_* of a node of *types* can lead to."""
        if property_ == TYPE:
            yield from self._classes()
        elif property_ == UNIT_OF:
            yield from self._units(types)
        elif property_ == KIND_OF:
            wanted = self.vocabulary.measured_by(self.vocabulary.above(types))
            for each in self.vocabulary.quantity_kinds:
                rank = FITTING if each in wanted else USUAL
                yield from self._spelled(each, Kind.UNIT, "kind of quantity", rank)
        elif property_ in IGNORES:
            yield from codes(self._situation)
        else:
            for word in self.vocabulary.words(property_):
                yield Candidate(word, Kind.WORD, rank=FITTING)
            yield from self._nodes(property_)

    def undescribed(self) -> Iterator[Candidate]:
        """Yield the nodes that are spoken of and described nowhere."""
        known = self.nodes.keys()
        spaces = tuple({each.rpartition("#")[0] + "#" for each in known if "#" in each})
        for document in self._situation.documents:
            for _, predicate, value in document.statements:
                if not is_iri(value) or predicate == RDF_TYPE:
                    continue
                if (name := iri_value(value)) not in known and name.startswith(spaces):
                    yield from self._spelled(name, Kind.NAME, "not described yet", FITTING)

    def used_with(self, types: Sequence[str]) -> frozenset[str]:
        """Return the properties of the nodes of the model that are of one of *types*."""
        alike = {f"<{name}>" for name, own in self.nodes.items() if not set(own).isdisjoint(types)}
        return frozenset(
            iri_value(predicate)
            for document in self._situation.documents
            for subject, predicate, _ in document.statements
            if subject in alike
        )

    def _classes(self) -> Iterator[Candidate]:
        used = {each for types in self.nodes.values() for each in types}
        for each in dict.fromkeys([*self.vocabulary.classes, *sorted(used)]):
            yield from self._spelled(each, Kind.CLASS, "", FITTING if each in used else USUAL)

    def _units(self, types: Sequence[str]) -> Iterator[Candidate]:
        wanted = self.vocabulary.measured_by(self.vocabulary.above(types))
        for unit, symbol in self.vocabulary.units.items():
            kinds = self.vocabulary.kinds_of(unit)
            names = ", ".join(each.rpartition("/")[2] for each in kinds[:2])
            fits = not wanted.isdisjoint(kinds)
            rank = FITTING if fits else USUAL
            yield from self._spelled(unit, Kind.UNIT, f"{symbol} {names}".strip(), rank)

    def _nodes(self, property_: str) -> Iterator[Candidate]:
        wanted = self.vocabulary.leads_to(property_)
        for name, types in self.nodes.items():
            fits = not wanted.isdisjoint(self.vocabulary.above(types))
            rank = USUAL if not wanted else FITTING if fits else OTHER
            short = ", ".join(each.rpartition("#")[2] for each in types[:2])
            yield from self._spelled(name, Kind.NAME, short, rank)

    def _spelled(self, iri: str, kind: Kind, detail: str, rank: int) -> Iterator[Candidate]:
        written = self._spell(iri)
        if written is not None:
            yield Candidate(written, kind, detail, rank)
