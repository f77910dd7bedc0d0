"""The statement `kl:ignore` about a node, as a change of a graph and as text."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping

from kinlint.document import Document
from kinlint.edits import Delta, Edit, NotExpressible
from kinlint.suppression.directive import IGNORE, REASON, RULE_NAMED
from kinlint.terms import Term, Triple, iri_value, is_blank, literal
from kinlint.text import Span
from kinlint.vocabulary import DOCUMENT_BASE, KL

LINE_END = re.compile(r"\r\n?|\n")


def ignore_delta(
    document: Document, codes: Mapping[Term, Iterable[str]], reason: str | None
) -> Delta:
    """Return the statements that silence the *codes* of each node of *document*, for *reason*."""
    return Delta(added=tuple(_ignore_triples(document, codes, reason)))


def _ignore_triples(
    document: Document, codes: Mapping[Term, Iterable[str]], reason: str | None
) -> Iterator[Triple]:
    there = set(document.statements)
    for number, (node, own) in enumerate(codes.items()):
        if reason is None:
            yield from (
                each for code in own if (each := (node, IGNORE, literal(code))) not in there
            )
            continue
        note = f"_:new{number}"
        yield node, IGNORE, note
        yield from ((note, RULE_NAMED, literal(code)) for code in own)
        yield note, REASON, literal(reason)


def append_statement(document: Document, change: Delta) -> Edit:
    """Return the edit that writes the statements of *change* at the end of *document*.

    Raises NotExpressible for a node that has no name in the text.
    """
    text = document.source.text
    notes = {o: s for s, p, o in change.added if p == IGNORE and is_blank(o)}
    subjects: dict[Term, list[str]] = {}
    prefix = next((name for name, known in document.prefixes.items() if known == KL), None)

    def word(term: Term) -> str:
        if term.startswith(f"<{KL}") and prefix is not None:
            return f"{prefix}:{term[len(KL) + 1 : -1]}"
        if term.startswith(f"<{DOCUMENT_BASE}"):
            return f"<{iri_value(term)[len(DOCUMENT_BASE) :]}>"
        return f"_:kinlint{_free(text)}x{term[5:]}" if term in notes else term

    for s, p, o in change.added:
        if is_blank(s) and s not in notes:
            raise NotExpressible("it is about a node without an IRI")
        subjects.setdefault(s, []).append(f"{word(s)} {word(p)} {word(o)} .")
    found = LINE_END.search(text)
    end = found[0] if found else "\n"
    lines = [line for each in subjects.values() for line in each]
    opening = end if text and text[-1] not in "\r\n" else ""
    return Edit(Span(len(text), len(text)), opening + "".join(f"{line}{end}" for line in lines))


def _free(text: str) -> int:
    """Return a number that no label of ours in *text* has."""
    taken = {int(number) for number in re.findall(r"_:kinlint(\d+)x", text)}
    return max(taken, default=0) + 1
