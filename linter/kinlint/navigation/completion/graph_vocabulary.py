"""Statements of the vocabulary about terms: classes, properties, units, and their relations."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import lru_cache
from pathlib import Path

from kinlint.light_dataclasses import dataclass, field
from kinlint.vocabulary import KIN, OWL, QUANTITY_KIND, QUDT, RDFS, UNIT

SUBCLASS, DOMAIN, RANGE, DEFINED, COMMENT = (
    f"{RDFS}{name}" for name in ("subClassOf", "domain", "range", "isDefinedBy", "comment")
)
VALUES, CONTAINER, NUMBER = f"{KIN}values", f"{KIN}container", f"{KIN}Number"
LEADS = (f"{KIN}leadsTo", f"{KIN}alsoLeadsTo", RANGE)
KIND, SYMBOL = f"{QUDT}hasQuantityKind", f"{QUDT}symbol"
MEASURED = tuple(f"{KIN}{name}" for name in ("unitKind", "vectorKind", "measuredAs"))
ON, HAS = f"{OWL}onProperty", f"{OWL}hasValue"


@dataclass(eq=False)
class GraphVocabulary:
    """The statements of the vocabulary about terms, by IRI."""

    said: Mapping[str, Mapping[str, Sequence[str]]]
    """Values by subject and property."""
    _above: dict[str, frozenset[str]] = field(default_factory=dict)

    @property
    def classes(self) -> Iterator[str]:
        """Yield the classes that contexts define."""
        for name, entries in self.said.items():
            if DEFINED in entries and VALUES not in entries and CONTAINER not in entries:
                yield name

    @property
    def units(self) -> Mapping[str, str]:
        """The symbols of all units, by IRI."""
        return {
            name: next(iter(entries.get(SYMBOL, ())), "")
            for name, entries in self.said.items()
            if name.startswith(UNIT) and KIND in entries
        }

    @property
    def quantity_kinds(self) -> Sequence[str]:
        """All kinds of quantity that a unit measures."""
        found = (kind for name in self.units for kind in self.said[name][KIND])
        return sorted({kind for kind in found if kind.startswith(QUANTITY_KIND)})

    def kinds_of(self, unit: str) -> Sequence[str]:
        """Return what *unit* measures."""
        return self.said.get(unit, {}).get(KIND, ())

    def is_property(self, name: str) -> bool:
        """Tell whether *name* is a property."""
        entries = self.said.get(name, {})
        return any(each in entries for each in (VALUES, CONTAINER, DOMAIN, *LEADS))

    def is_class(self, name: str) -> bool:
        """Tell whether *name* is a class that a context defines."""
        return DEFINED in self.said.get(name, {}) and not self.is_property(name)

    def above(self, types: Iterable[str]) -> frozenset[str]:
        """Return *types* with all their superclasses."""
        found: set[str] = set()
        for each in types:
            if each not in self._above:
                reached, waiting = set[str](), [each]
                while waiting:
                    if (at := waiting.pop()) not in reached:
                        reached.add(at)
                        waiting += self.said.get(at, {}).get(SUBCLASS, ())
                self._above[each] = frozenset(reached)
            found |= self._above[each]
        return frozenset(found)

    def belongs(self, property_: str, types: frozenset[str]) -> bool:
        """Tell whether *property_* is one of what is of *types*, with their superclasses."""
        return not types.isdisjoint(self.said.get(property_, {}).get(DOMAIN, ()))

    def leads_to(self, property_: str) -> frozenset[str]:
        """Return the classes of the values of *property_*, none if nothing is known."""
        entries = self.said.get(property_, {})
        return frozenset(each for word in LEADS for each in entries.get(word, ()))

    def measured_by(self, types: frozenset[str]) -> frozenset[str]:
        """Return the kinds of quantity in which values of what is of *types* are measured."""
        found = (self.said.get(each, {}) for each in types)
        return frozenset(kind for each in found for word in MEASURED for kind in each.get(word, ()))

    def words(self, property_: str) -> Sequence[str]:
        """Return the words that classes are defined by as values of *property_*."""
        found = (each for each in self.said.values() if property_ in each.get(ON, ()))
        return sorted({word for each in found for word in each.get(HAS, ())})

    def describe(self, name: str) -> str:
        """Return what *name* takes, or its symbol, in a few words."""
        entries = self.said.get(name, {})
        symbol = entries.get(SYMBOL, ())
        taken = [each.rpartition("#")[2].lower() for each in entries.get(VALUES, ())]
        many = any(each.endswith("List") for each in entries.get(CONTAINER, ()))
        what = ", ".join(symbol or taken)
        return f"list of {what}s" if many and what else what


@lru_cache(maxsize=2)
def graph_vocabulary(files: tuple[Path, ...]) -> GraphVocabulary:
    """Return what the Turtle *files* say, read once."""
    import pyoxigraph as ox  # noqa: PLC0415  a native module

    said: dict[str, dict[str, list[str]]] = defaultdict(lambda: defaultdict(list))
    for path in files:
        base = path.absolute().as_uri()
        for quad in ox.parse(path=path, format=ox.RdfFormat.TURTLE, base_iri=base):
            entries = said[getattr(quad.subject, "value", str(quad.subject))]
            entries[quad.predicate.value].append(getattr(quad.object, "value", str(quad.object)))
    return GraphVocabulary({name: dict(entries) for name, entries in said.items()})
