"""Contexts that a file does not load, although keys and types of it are their terms."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sized
from collections.abc import Set as AbstractSet

from kinlint.facts.fact_statements import MEMBER, fact, fact_node, integer
from kinlint.facts.predicate_index import PredicateIndex, Table
from kinlint.formats.source_layer import src
from kinlint.terms import Term, Triple, iri, iri_value, literal, literal_value
from kinlint.vocabulary import KINLINT, METAMODELS, RDFS

FEWEST = 3
"""Number of lost words from which on it is the context that is missing, and not a word wrong."""
BUNDLED = (f"<{METAMODELS}", f"<{KINLINT}")
LOST = (src("DroppedKey"), src("key")), (src("RelativeType"), src("written"))
"""The classes of losses of words, each with the property that has the word."""
COMPOSABLE = literal(f"{KINLINT}composable.json")
"""The context that stands for all of them."""


def missing_contexts(scan: PredicateIndex) -> Iterator[Triple]:
    """Yield for each document the fewest contexts that have its lost words, the most first.

    Each is a node with the `context`, the first `word`, and the losses as members, with their
    `count`.
    """
    words = _lost_words(scan)
    if not words:
        return
    homes = scan.table(iri(f"{RDFS}isDefinedBy"))
    contexts = _contexts_by_word(homes)
    number = 0
    for document, lost in sorted(words.items()):
        loaded = _loaded(scan, document, homes)
        if COMPOSABLE in loaded:
            continue
        known = {word: contexts[word] - loaded for word in lost if word in contexts}
        left = {word: lost[word] for word in known}
        # A word that a loaded context has, too, may be lost for want of a type.
        telling = {word for word in known if loaded.isdisjoint(contexts[word])}
        while chosen := _best(left, known, telling):
            found = sorted(word for word in left if chosen in known[word])
            losses = [each for word in found for each in left.pop(word)]
            number += 1
            node = fact_node("missing-context", number)
            yield document, fact("missing-context"), node
            yield node, fact("context"), literal(iri_value(chosen))
            yield node, fact("count"), integer(len(losses))
            yield node, fact("word"), literal(found[0])
            yield from ((node, MEMBER, each) for each in losses)


def _best(
    left: Mapping[str, Sized], contexts: Mapping[str, Iterable[Term]], telling: AbstractSet[str]
) -> Term | None:
    """Return the context with the most of the words *left*; None if none has enough.

    It has to have one of the *telling* words.
    """
    counts: dict[Term, int] = {each: 0 for word in telling & left.keys() for each in contexts[word]}
    for word, losses in left.items():
        for context in contexts[word]:
            if context in counts:
                counts[context] += len(losses)
    most = max(counts.values(), default=0)
    return min(each for each in counts if counts[each] == most) if most >= FEWEST else None


def _lost_words(scan: PredicateIndex) -> dict[Term, dict[str, list[Term]]]:
    """Return the losses of each document by the lost word."""
    found: dict[Term, dict[str, list[Term]]] = {}
    documents, unread = scan.table(src("document")), scan.table(src("unless"))
    for kind, way in LOST:
        written = scan.table(way)
        for loss in sorted(scan.instances(kind)):
            if unread.values(loss):  # The unread context may have the word.
                continue
            for word in map(literal_value, written.values(loss)):
                for document in documents.values(loss):
                    found.setdefault(document, {}).setdefault(word, []).append(loss)
    return found


def _loaded(scan: PredicateIndex, document: Term, homes: Table) -> set[Term]:
    """Return the contexts that *document* names, and those whose own terms it uses."""
    named = scan.table(src("context"))
    uses = scan.table(src("usesContext")).values(document)
    names = [name for use in uses for name in named.values(use)]
    found = {COMPOSABLE} & set(names) | {iri(literal_value(name)) for name in names}
    for term in scan.table(src("usesTerm")).values(document):
        if len(own := homes.values(term)) == 1:
            found.update(own)
    return found


def _contexts_by_word(homes: Table) -> dict[str, set[Term]]:
    """Return the bundled contexts that define each word."""
    found: dict[str, set[Term]] = {}
    for term, contexts in homes.items():
        whole = iri_value(term)
        word = whole[max(whole.rfind("#"), whole.rfind("/")) + 1 :]
        named = {each for each in contexts if each.startswith(BUNDLED)}
        found.setdefault(word, set()).update(named)
    return found
