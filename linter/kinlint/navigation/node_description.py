"""Descriptions of nodes for people: types, units, frames and values."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from kinlint.facts.metamodel_terms import AS_SEEN_BY, COORDINATE_OF, OF, WITH_RESPECT_TO, kin, qudt
from kinlint.facts.predicate_index import numeric
from kinlint.navigation.graph_model import GraphModel
from kinlint.navigation.unit_symbols import coherent, symbol
from kinlint.term_format import TermFormatter
from kinlint.terms import RDF_TYPE, Term, is_blank, is_literal
from kinlint.vocabulary import ATTRIBUTE, REFERENCE, SRC

UNIT = qudt("unit")
TOLD = (
    ("unit", UNIT),
    ("quantity kind", qudt("hasQuantityKind")),
    ("as seen by", AS_SEEN_BY),
    ("of", OF),
    ("with respect to", WITH_RESPECT_TO),
    ("on body", kin("on-body")),
    ("joins", kin("joins-body")),
)
"""Labels and properties that are shown of every node: stated, lifted or inferred."""
BELONGING = ("mass", "lower", "upper")
"""Numbers that are told of what belongs to a node."""
MOST_VALUES, MOST_LINES, DEEPEST = 8, 16, 2
LAYERS = tuple(f"<{each}" for each in (SRC, ATTRIBUTE, REFERENCE))
"""Beginnings of the properties that tell how something is written."""


class Descriptions:
    """Describes nodes of the *model* as *display* abbreviates."""

    def __init__(self, model: GraphModel, display: TermFormatter) -> None:
        self.model, self.display = model, display

    def types(self, node: Term) -> Sequence[str]:
        """Return the classes that *node* is said to be of, or else those that follow."""
        store = self.model.store
        said = {value for predicate, value in store.described(node) if predicate == RDF_TYPE}
        every = sorted(said or set(store.values(node, RDF_TYPE)))
        return list(dict.fromkeys(map(self.display.term, every)))

    def lines(self, node: Term) -> Sequence[str]:
        """Return what is stated of *node* besides its types, as list items in Markdown."""
        told = [f"{words}: {self._listed(v)}" for words, p in TOLD if (v := self._values(node, p))]
        told += self._values_stated(node)
        told += self._belonging(node, DEEPEST)
        return [f"- {each}" for each in dict.fromkeys(told)][:MOST_LINES]

    def _values(self, node: Term, property_: Term) -> Sequence[Term]:
        """Return the values of *property_*; of what is coordinates, or else of their relation."""
        values = set(self.model.values(node, property_))
        if not values:
            relations = self.model.values(node, COORDINATE_OF)
            values = {value for each in relations for value in self.model.values(each, property_)}
        return sorted(values)

    def _values_stated(self, node: Term) -> Iterator[str]:
        """Yield the properties of *node* that have no words of their own."""
        stated: dict[Term, list[Term]] = {}
        for predicate, value in sorted(self.model.store.described(node)):
            if predicate != RDF_TYPE and not predicate.startswith(LAYERS):
                stated.setdefault(predicate, []).append(value)
        known = {words.replace(" ", "-") for words, _ in TOLD} | {"hasQuantityKind"}
        for predicate, values in stated.items():
            name = predicate[:-1].rpartition("#")[2].rpartition("/")[2]
            plain = [each for each in values if not is_blank(each)]
            if plain and name not in known:
                numbers = [self._number(node, name, each) for each in plain]
                exact = ", ".join(each for each in numbers if each)
                yield f"{self.display.term(predicate)}: {exact or self._listed(plain)}"

    def _number(self, node: Term, name: str, value: Term) -> str:
        """Return the number *value*, with its unit and what it is in SI where both are known."""
        number = numeric(value) if is_literal(value) else None
        if number is None:
            return ""
        units = self._values(node, UNIT)
        unit = units[0] if len(units) == 1 else None
        store = self.model.store
        own = _spaced(symbol(store, unit)) if unit is not None else ""
        computed = [numeric(each) for each in self.model.computed(node, name)]
        if unit is None or not computed or computed[0] is None:
            return f"{number:.12g}{own}"
        si = f"{computed[0]:.6g}{_spaced(coherent(store, unit))}"
        return si if si == f"{number:.6g}{own}" else f"{number:.12g}{own} = {si}"

    def _belonging(self, node: Term, depth: int) -> Iterator[str]:
        """Yield the numbers of what belongs to *node*, at most *depth* steps away."""
        for part in self.model.owned(node):
            if part == node:
                continue
            numbers = [
                f"{self.display.term(predicate)} {shown}"
                for predicate, value in sorted(self.model.store.described(part))
                if (name := predicate[:-1].rpartition("#")[2]) in BELONGING
                and (shown := self._number(part, name, value))
            ]
            if numbers:
                yield f"{', '.join(self.types(part)[-1:])}: {', '.join(numbers)}"
            if depth > 1:
                yield from self._belonging(part, depth - 1)

    def _listed(self, terms: Iterable[Term]) -> str:
        every = [f"`{self.display.term(each)}`" for each in terms]
        more = len(every) - MOST_VALUES
        return ", ".join(every[:MOST_VALUES]) + (f" and {more} more" if more > 0 else "")


def _spaced(unit: str) -> str:
    return f" {unit}" if unit else ""
