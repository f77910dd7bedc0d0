"""The statement `kl:ignore` about a node, as a change of a graph."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from kinlint.document import Document
from kinlint.edits import Delta
from kinlint.suppression.directive import IGNORE, REASON, RULE_NAMED
from kinlint.terms import Term, Triple, literal


def ignore_delta(
    document: Document, codes: Mapping[Term, Iterable[str]], reason: str | None
) -> Delta:
    """Return the statements that silence the *codes* of each node of *document*, for *reason*."""
    there, added = set(document.statements), list[Triple]()
    for number, (node, own) in enumerate(codes.items()):
        holder, way = (node, IGNORE) if reason is None else (f"_:new{number}", RULE_NAMED)
        rules = [(holder, way, literal(code)) for code in own]
        if reason is not None:
            rules = [(node, IGNORE, holder), *rules, (holder, REASON, literal(reason))]
        added += [each for each in rules if each not in there]
    return Delta(added=tuple(added))
