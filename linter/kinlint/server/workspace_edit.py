"""Changes of texts as edits of the protocol, bound to the versions that they are made for."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from difflib import SequenceMatcher

from lsprotocol import types

from kinlint.edits import Edit
from kinlint.finding import TextEdit
from kinlint.server.request_context import Places
from kinlint.text import Location, SourceText, Span

MOST_LINES = 2_000
"""Larger changes are written as one: to compare so many lines takes too long."""


def workspace_edit(
    edits: Iterable[TextEdit], places: Places, *, versioned: bool
) -> types.WorkspaceEdit:
    """Convert *edits* of any files to a workspace edit.

    *versioned* if the client can refuse stale edits.
    """
    by_name: dict[str, list[TextEdit]] = {}
    for edit in edits:
        by_name.setdefault(edit.location.source.name, []).append(edit)
    made = {
        name: [types.TextEdit(places.range(one.location), one.text) for one in own]
        for name, own in by_name.items()
    }
    if not versioned:
        return types.WorkspaceEdit(changes={places.uri(name): own for name, own in made.items()})
    return types.WorkspaceEdit(
        document_changes=[
            types.TextDocumentEdit(_identifier(name, places), own) for name, own in made.items()
        ]
    )


def _identifier(name: str, places: Places) -> types.OptionalVersionedTextDocumentIdentifier:
    buffer = places.buffer(name)
    version = None if buffer is None else buffer.version
    return types.OptionalVersionedTextDocumentIdentifier(places.uri(name), version)


def difference(before: SourceText, after: str) -> Iterator[TextEdit]:
    """Edits of whole lines, or of what is in one, that make *after* of the text *before*."""
    old, new = before.text.splitlines(keepends=True), after.splitlines(keepends=True)
    first = _alike(old, new)
    last = _alike(old[first:][::-1], new[first:][::-1])
    old, new = old[first : len(old) - last], new[first : len(new) - last]
    at = sum(map(len, before.text.splitlines(keepends=True)[:first]))
    for edit in _edits(old, new, at):
        yield TextEdit(Location(before, edit.span), edit.text)


def _edits(old: Sequence[str], new: Sequence[str], at: int) -> Iterator[Edit]:
    """The edits that make the lines *new* of *old*, which begin at offset *at*."""
    if max(len(old), len(new)) > MOST_LINES:
        yield Edit(Span(at, at + sum(map(len, old))), "".join(new))
        return
    offsets = [at]
    for line in old:
        offsets.append(offsets[-1] + len(line))
    for kind, i, j, k, m in SequenceMatcher(None, old, new, autojunk=False).get_opcodes():
        if kind != "equal":
            yield Edit(Span(offsets[i], offsets[j]), "".join(new[k:m]))


def _alike(one: Sequence[str], other: Sequence[str]) -> int:
    """Return the number of leading lines that two texts share."""
    pairs = zip(one, other, strict=False)
    return next((n for n, (a, b) in enumerate(pairs) if a != b), min(len(one), len(other)))
