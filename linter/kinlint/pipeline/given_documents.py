"""Documents that were read before, in place of texts that are read in this run."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from kinlint.document import Document
from kinlint.light_dataclasses import dataclass
from kinlint.terms import Term, Triple


@dataclass(frozen=True)
class GivenDocuments:
    """Documents with what was found out about the files that they name."""

    documents: Mapping[str, Document]
    """The documents, by the names of their texts."""
    looked_up: Mapping[Term, Sequence[Triple]]
    """Statements about the files that a document names, by its graph."""

    def about_files(self, documents: Iterable[Document]) -> Iterator[Triple]:
        """Yield the statements about files that *documents* name."""
        for document in documents:
            yield from self.looked_up.get(document.graph, ())
