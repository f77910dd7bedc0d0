"""Loads documents into a store: each as one named graph, replaced as a whole."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from datetime import UTC, datetime

from kinlint.endpoint.connection import Endpoint
from kinlint.endpoint.source_record import StoredDocument, written
from kinlint.endpoint.storable import line
from kinlint.endpoint.stored_graphs import (
    APART,
    COMPANION,
    COUNTER,
    FILE,
    LOADED,
    MODEL,
    RECORD,
    REVISION,
    SIZE,
)
from kinlint.light_dataclasses import dataclass
from kinlint.terms import XSD, Term, literal, literal_value

MOST_LETTERS = 4 * 2**20
"""Letters of one update; a document that has more is an update by itself."""


@dataclass(frozen=True)
class Loader:
    """Loads models into a store."""

    endpoint: Endpoint
    """The store."""

    def load(self, models: Iterable[Sequence[StoredDocument]]) -> Iterator[int]:
        """Load *models*; yield the number of documents of each update that was made.

        The documents of one update are replaced together, and those of a model are in one update,
        as far as they fit.
        """
        texts: dict[Term, str] = {}
        for model in models:
            for each in model:
                text = replacement(each, self._home(each, model), _companions(each, model))
                if texts and sum(map(len, texts.values())) + len(text) > MOST_LETTERS:
                    yield self._make(texts)
                    texts = {}
                texts[each.document.graph] = text
        if texts:
            yield self._make(texts)

    def newest(self) -> int:
        """Return the number of the newest loading."""
        query = f"SELECT ?r WHERE {{ GRAPH {COUNTER} {{ {COUNTER} {REVISION} ?r }} }}"
        return max((int(literal_value(row["r"])) for row in self.endpoint.select(query)), default=0)

    def _make(self, texts: dict[Term, str]) -> int:
        self.endpoint.update(" ;\n".join((*texts.values(), _counted(texts))))
        return len(texts)

    def _home(self, stored: StoredDocument, model: Sequence[StoredDocument]) -> Term | None:
        """Return the name of *model* for *stored*, which is a part of it, or its companion.

        A document that is loaded alone, or as a companion, stays in the model that it was in.
        """
        mine = [each.document for each in model if not each.document.source.companion]
        if not stored.document.source.companion and len(mine) > 1:
            return mine[0].graph
        own = stored.document.graph
        alone = None if stored.document.source.companion else own
        query = f"SELECT ?model WHERE {{ GRAPH {own} {{ {own} {MODEL} ?model }} }}"
        return next((row["model"] for row in self.endpoint.select(query)), alone)


def _companions(stored: StoredDocument, model: Sequence[StoredDocument]) -> list[Term]:
    """Return the graphs that are read along with *stored*."""
    if stored.document.source.companion:
        return []
    return [each.document.graph for each in model if each.document.source.companion]


def replacement(stored: StoredDocument, model: Term | None, companions: Iterable[Term]) -> str:
    """Return the update that has the graph of *stored* state what the document states.

    It is a part of *model*, if of any.
    """
    document = stored.document
    graph = document.graph
    now = datetime.now(UTC).isoformat(timespec="seconds").replace("+00:00", "Z")
    kept = [each for each in document.statements if each not in stored.apart]
    told = (
        (FILE, literal(document.source.name)),
        *((MODEL, each) for each in (model,) if each is not None),
        *((COMPANION, each) for each in companions),
        (LOADED, literal(now, f"{XSD}dateTime")),
        (SIZE, str(len(kept))),
        *((APART, str(len(each))) for each in (stored.apart,) if each),
        (RECORD, literal(written(stored))),
    )
    lines = (*map(line, kept), *(f"{graph} {name} {value} .\n" for name, value in told))
    return f"DROP SILENT GRAPH {graph} ;\nINSERT DATA {{ GRAPH {graph} {{\n{''.join(lines)}}} }}"


def _counted(graphs: Iterable[Term]) -> str:
    """Return the updates that number the loading of *graphs*, each as simple as stores want it."""
    said = f"GRAPH {COUNTER} {{ {COUNTER} {REVISION} "
    newest = f"SELECT (COALESCE(MAX(?old), 0) + 1 AS ?new) WHERE {{ {said}?old }} }}"
    every = f"VALUES ?g {{ {' '.join(graphs)} }}"
    updates = (
        f"INSERT {{ {said}?new }} }} WHERE {{ {{ {newest} }} }}",
        f"DELETE {{ {said}?old }} }} WHERE {{ {said}?old, ?newer FILTER(?newer > ?old) }} }}",
        f"INSERT {{ GRAPH ?g {{ ?g {REVISION} ?new }} }} WHERE {{ {said}?new }} {every} }}",
    )
    return " ;\n".join(updates)
