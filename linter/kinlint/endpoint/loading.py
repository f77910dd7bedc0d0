"""Loads documents into a store: each as one named graph, replaced as a whole."""

from __future__ import annotations

import gc
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from datetime import UTC, datetime

from kinlint.endpoint.connection import Endpoint, QueryRefused
from kinlint.endpoint.source_record import StoredDocument, written
from kinlint.endpoint.storable import line
from kinlint.endpoint.stored_graphs import (
    APART,
    COMPANION,
    COUNTER,
    FILE,
    FORMAT,
    LOADED,
    MODEL,
    RECORD,
    REVISION,
    SIZE,
    homes,
)
from kinlint.errors import SourceError
from kinlint.light_dataclasses import dataclass
from kinlint.terms import XSD, Term, literal, literal_value

MOST_LETTERS = 4 * 2**20
"""Letters of one update; a document that has more is an update by itself."""


@dataclass(frozen=True)
class Loader:
    """Loads models into a store."""

    endpoint: Endpoint
    """The store."""

    def load(
        self, models: Iterable[Sequence[StoredDocument]], failed: Callable[[SourceError], None]
    ) -> Iterator[int]:
        """Load *models*; yield the number of documents of each update that was made.

        The documents of one update are replaced together, and those of a model are in one update,
        as far as they fit. Documents that the store refuses are told *failed*, and the others
        loaded. Raises `EndpointError` if it refuses all documents of the first update.
        """
        tried, loaded = 0, 0
        for parts in _updates(models):
            every = {each.graph: each for each in parts}
            refusals: list[tuple[str, QueryRefused]] = []
            made = self._make(every, refusals)
            tried, loaded = tried + len(every), loaded + made
            if not loaded and tried > 1:
                raise refusals[0][1]
            for name, error in refusals:
                failed(SourceError(name, str(error)))
            gc.collect()  # documents are circles of objects
            yield made

    def newest(self) -> int:
        """Return the number of the newest loading."""
        query = f"SELECT ?r WHERE {{ GRAPH {COUNTER} {{ {COUNTER} {REVISION} ?r }} }}"
        numbers = (literal_value(row["r"]) for row in self.endpoint.select(query))
        return max((int(each) for each in numbers if each.isdecimal()), default=0)

    def _make(self, parts: Mapping[Term, _Part], refusals: list[tuple[str, QueryRefused]]) -> int:
        """Load *parts*, half by half if the store refuses them; return how many it takes."""
        alone = [graph for graph, each in parts.items() if each.home is None]
        known = homes(self.endpoint, alone) if alone else {}
        texts = [each.replacement(known.get(graph)) for graph, each in parts.items()]
        try:
            self.endpoint.update(" ;\n".join((*texts, _counted(parts))))
        except QueryRefused as error:
            if len(parts) == 1:
                refusals.extend((each.name, error) for each in parts.values())
                return 0
        else:
            return len(parts)
        every = [*parts.items()]
        half = len(every) // 2
        return sum(self._make(dict(each), refusals) for each in (every[:half], every[half:]))


@dataclass(frozen=True)
class _Part:
    """A document that is loaded, in its model."""

    stored: StoredDocument
    """The document."""
    model: Sequence[StoredDocument]
    """The documents of the model."""
    lines: str
    """Its statements and the record of it, in N-Triples."""

    @property
    def letters(self) -> int:
        """The length of its statements."""
        return len(self.lines)

    @property
    def name(self) -> str:
        """The name of its file."""
        return self.stored.document.source.name

    @property
    def graph(self) -> Term:
        """The name of its graph."""
        return self.stored.document.graph

    @property
    def home(self) -> Term | None:
        """The name of the model, if it is loaded with others of it, and not as a companion."""
        mine = [each.document for each in self.model if not each.document.source.companion]
        several = len(mine) > 1 and not self.stored.document.source.companion
        return mine[0].graph if several else None

    def replacement(self, known: Term | None) -> str:
        """Return the update that has the graph state what the document states.

        A document that is loaded alone, or as a companion, stays in the model that is *known* of
        it.
        """
        companion = self.stored.document.source.companion
        home = self.home or known or (None if companion else self.graph)
        aside = (each.document for each in self.model if each.document.source.companion)
        told = (
            *((MODEL, each) for each in (home,) if each is not None),
            *((COMPANION, each.graph) for each in aside if not companion),
        )
        more = "".join(f"{self.graph} {name} {value} .\n" for name, value in told)
        said = f"GRAPH {self.graph} {{\n{self.lines}{more}}}"
        return f"DROP SILENT GRAPH {self.graph} ;\nINSERT DATA {{ {said} }}"


def _updates(models: Iterable[Sequence[StoredDocument]]) -> Iterator[list[_Part]]:
    """Yield the documents of *models* as updates replace them together."""
    parts, letters = list[_Part](), 0
    for model in models:
        for each in model:
            part = _Part(each, model, statements(each))
            if parts and letters + part.letters > MOST_LETTERS:
                yield parts
                parts, letters = [], 0
            parts.append(part)
            letters += part.letters
    if parts:
        yield parts


def statements(stored: StoredDocument) -> str:
    """Return what *stored* states, and what is told of it by itself, in N-Triples."""
    document = stored.document
    now = datetime.now(UTC).isoformat(timespec="seconds").replace("+00:00", "Z")
    kept = [each for each in document.statements if each not in stored.apart]
    told = (
        (FILE, literal(document.source.name)),
        (FORMAT, literal(document.format.name)),
        (LOADED, literal(now, f"{XSD}dateTime")),
        (SIZE, str(len(kept))),
        *((APART, str(len(each))) for each in (stored.apart,) if each),
        (RECORD, literal(written(stored))),
    )
    lines = (*map(line, kept), *(f"{document.graph} {name} {value} .\n" for name, value in told))
    return "".join(lines)


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
