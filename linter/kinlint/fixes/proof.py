"""Proves by reading again that a text says what its fix promises: the old graph plus the delta."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence

from kinlint.document import Document
from kinlint.edits import Delta
from kinlint.engine.literal_spelling import normal
from kinlint.terms import (
    RDF_TYPE,
    Term,
    Triple,
    iri,
    iri_value,
    is_blank,
    is_literal,
    literal_value,
)
from kinlint.vocabulary import DOCUMENT_BASE, SRC

FAR = 64
"""The radius of the neighbourhood that tells blank nodes apart, in steps."""

OF_THE_TEXT = f"<{SRC}"
_TERM, _NAMESPACE = iri(f"{SRC}term"), iri(f"{SRC}namespace")
_PREFIXED = frozenset({_NAMESPACE, iri(f"{SRC}written")})
LOST_OF = iri(f"{SRC}node")
"""Property from what is lost to the node that it is lost of."""


def is_exact_change(before: Document, after: Document, delta: Delta) -> bool:
    """Tell whether *after* states exactly what *before* states with *delta*.

    Blank nodes may be called otherwise, and numbers be spelled otherwise. If *delta* repairs what
    was lost in reading, nobody can tell beforehand what is found: then nothing may be missing,
    but types that were none. If it redefines a prefix, names move from one namespace to the other,
    and nothing else may change.
    """
    if before.format.is_tree:
        from kinlint.formats.xml.editing.element_tree import changed, tree  # noqa: PLC0415

        return bool(changed(before, delta) == tree(after))
    removed, moves = set(delta.removed), _moves(before, delta)
    mending = any(
        _of_the_text(triple) and triple[:2] not in moves
        for triple in (*delta.removed, *delta.added)
    )
    # A type may give keys a meaning that its node has lost.
    lossy = {node for _, _, node in before.saying(LOST_OF)}
    mending = mending or any(s in lossy and p == RDF_TYPE for s, p, _ in delta.added)
    old = {
        triple
        for triple in before.statements
        if triple not in removed and not (mending and _means_nothing(triple))
    }
    old.update(delta.added)
    new = set(after.statements)
    if moves:
        old, new = (_moved(each, [*moves.values()]) for each in (old, new))
    expected, found = map(_canonical, _differing(old, new))
    if mending or any(map(_means_nothing, delta.removed)):
        return expected <= found
    return expected == found


def _moves(before: Document, delta: Delta) -> dict[tuple[Term, Term], tuple[str, str]]:
    """Return the beginnings of IRIs that *delta* redefines by a prefix, with the new ones.

    The keys are the definition and the property that it changes.
    """
    new = {triple[:2]: literal_value(triple[2]) for triple in delta.added if triple[1] in _PREFIXED}
    terms = {node: literal_value(term) for node, _, term in before.saying(_TERM)} if new else {}
    return {
        (s, p): (literal_value(o) if p == _NAMESPACE else f"{terms[s]}:", new[s, p])
        for s, p, o in delta.removed
        if (s, p) in new and s in terms
    }


def _moved(statements: Iterable[Triple], moves: Sequence[tuple[str, str]]) -> set[Triple]:
    """Return *statements* of the model with the namespaces that *moves* give their names."""

    def moved(term: Term) -> Term:
        for old, new in moves:
            if term.startswith(f"<{old}"):
                return iri(f"{new}{iri_value(term)[len(old) :]}")
        return term

    said = (triple for triple in statements if not _of_the_text(triple))
    return {(moved(s), moved(p), moved(o)) for s, p, o in said}


def _differing(one: set[Triple], other: set[Triple]) -> tuple[set[Triple], set[Triple]]:
    """Return the statements of each graph but for those that both make in the same words.

    Statements of blank nodes from which blank nodes lead to a difference count as different.
    """
    apart = one ^ other
    waiting = {term for s, _, o in apart for term in (s, o) if is_blank(term)}
    if waiting:
        beside: dict[Term, list[Triple]] = {}
        for triple in one & other:
            for term in triple[::2]:
                if is_blank(term):
                    beside.setdefault(term, []).append(triple)
        while waiting:
            near = beside.pop(waiting.pop(), ())
            apart.update(near)
            waiting.update(term for s, _, o in near for term in (s, o) if term in beside)
    return one & apart, other & apart


def _means_nothing(triple: Triple) -> bool:
    """Tell whether *triple* has a type that is none, which a context may yet give a meaning."""
    return triple[1] == RDF_TYPE and triple[2].startswith(f"<{DOCUMENT_BASE}")


def _of_the_text(triple: Triple) -> bool:
    """Tell whether *triple* is about the writing, not about what is written."""
    _, predicate, value = triple
    return predicate.startswith(OF_THE_TEXT) or (
        predicate == RDF_TYPE and value.startswith(OF_THE_TEXT)
    )


def _canonical(statements: Iterable[Triple]) -> Counter[Triple]:
    """Return *statements* of the model, blank nodes named by the statements around them.

    That is the colour refinement of graphs: nodes keep one name only if nothing within `FAR`
    steps tells them apart, and then they are counted.
    """
    said = {
        (s, p, normal(o) if is_literal(o) else o)
        for s, p, o in statements
        if not _of_the_text((s, p, o))
    }
    around: dict[Term, list[tuple[str, Term, Term]]] = {}
    for s, p, o in said:
        if is_blank(s):
            around.setdefault(s, []).append((">", p, o))
        if is_blank(o):
            around.setdefault(o, []).append(("<", p, s))
    names = dict.fromkeys(around, "")
    for _ in range(FAR):
        finer = {
            node: hash((names[node], *sorted((d, p, str(names.get(o, o))) for d, p, o in edges)))
            for node, edges in around.items()
        }
        if len(set(finer.values())) == len(set(names.values())) and names:
            break
        names = {node: f"_:{name}" for node, name in finer.items()}
    return Counter((names.get(s, s), p, names.get(o, o)) for s, p, o in said)
