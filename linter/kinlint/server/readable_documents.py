"""The documents of files as they were when they could be read last."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import islice

from kinlint.document import Document
from kinlint.pipeline.analyzer import Examination
from kinlint.terms import iri
from kinlint.vocabulary import SRC

UNREAD = iri(f"{SRC}unread")
FIRST = 1_000
"""Number of statements among which an unread document says that it is one: it states nothing else
but flaws of its text."""


class ReadableDocuments:
    """Remembers the newest readable document of each file, and those that it formed a model with.

    While a file is being typed in, it cannot be read for moments, and may be no part of its model.
    """

    def __init__(self) -> None:
        self._known: dict[str, Sequence[Document]] = {}
        self._newest: dict[str, Document] = {}

    def remember(self, examination: Examination | None) -> None:
        """Take over the documents of *examination* that could be read."""
        documents = () if examination is None else examination.documents
        for each in documents:
            name = each.source.name
            if self._newest.get(name) is each or is_readable(each):
                self._newest[name] = each
                self._known.update(dict.fromkeys(_names(each), documents))

    def forget(self, names: Iterable[str]) -> None:
        """Forget the files called *names*, none of which is open."""
        closed = set(names)
        for name, documents in list(self._known.items()):
            if any(each.source.name in closed for each in documents):
                del self._known[name]
                self._newest.pop(name, None)

    def of(self, name: str, examination: Examination) -> Sequence[Document]:
        """Return the documents of the model of the file *name*, which is now in *examination*."""
        now = {each.source.name: each for each in examination.documents if is_readable(each)}
        if any(name in _names(each) for each in now.values()):
            return examination.documents
        before = {each.source.name: each for each in self._known.get(name, ())}
        return tuple({**before, **now}.values())


def _names(document: Document) -> list[str]:
    """Return the names of the texts that *document* is made of."""
    return [each.name for each in document.sources]


def is_readable(document: Document) -> bool:
    """Tell whether the text of *document* could be read."""
    return all(predicate != UNREAD for _, predicate, _ in islice(document.statements, FIRST))
