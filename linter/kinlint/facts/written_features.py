"""Features of documents that consumers read differently, by the queries of `shapes/targets`."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.contexts.model_prefixes import model_prefixes
from kinlint.facts.fact_statements import fact
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.formats.records import spoken_of_as
from kinlint.terms import Term, Triple, iri, literal
from kinlint.vocabulary import FEATURE, INHERITED, SRC

NODE = iri(f"{SRC}node")
HAS, CALLED = fact("feature"), fact("feature-name")
FEATURES: dict[str, tuple[Term, ...]] = {
    "feature": (iri(f"{INHERITED}range-1"),),
    "feature-name": (),
}
"""Names of the facts, each with the terms that it follows from and that are not there unasked."""


def written_features(scan: PredicateIndex) -> Iterator[Triple]:
    """Yield which features each place has, and what these are called.

    Queries for other formats than those of the documents are not asked.
    """
    from kinlint.targets.consumer_files import consumer_table  # noqa: PLC0415  few runs have targets

    scan.table(NODE)  # Files that are missing may come without a change of the documents.
    forms = {spoken_of_as(document.format) for document in scan.documents}
    prologue = "".join(f"PREFIX {name}: <{space}> " for name, space in model_prefixes().items())
    for feature in consumer_table().features.values():
        if feature.query and not forms.isdisjoint(feature.formats):
            places = {row["place"] for row in scan.store.rows(prologue + feature.query)}
            name = iri(FEATURE + feature.name)
            yield from ((place, HAS, name) for place in sorted(places))
            if places:
                yield name, CALLED, literal(feature.label)
