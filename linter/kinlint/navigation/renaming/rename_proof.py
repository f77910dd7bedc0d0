"""Proof that a renaming changes the name and nothing else: the texts are read again."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from kinlint.addresses import is_address, last_tag, local_name, sibling
from kinlint.configuration.settings import Settings
from kinlint.document import Document
from kinlint.edits import Edit
from kinlint.errors import SourceError
from kinlint.files.pathname import real
from kinlint.finding import TextEdit
from kinlint.fixes.texts import Texts
from kinlint.formats.registry import read
from kinlint.formats.xml.schema import schema
from kinlint.light_dataclasses import replace
from kinlint.navigation.renaming.renaming_error import NotRenamable
from kinlint.pipeline.analyzer import Examination
from kinlint.pipeline.read_models import read_documents
from kinlint.terms import Term, Triple, iri, is_literal, literal, literal_value
from kinlint.text import SourceText, Span
from kinlint.vocabulary import ATTRIBUTE, SRC

AT, OWN, TEXT = f"<{ATTRIBUTE}", f"<{SRC}", iri(f"{SRC}text")
"""Beginnings of the properties of attributes, and of those that tell how a text is written, of
which that of the text of an element counts."""


class _Changes(NamedTuple):
    """Edits of texts, by the paths of their files."""

    sources: Mapping[Path, SourceText]
    """The texts as they are."""
    edits: Mapping[Path, Sequence[Edit]]
    """The edits of each."""


def prove(
    edits: Sequence[TextEdit],
    renamed: Mapping[Term, Term],
    made: Examination,
    texts: Texts,
    settings: Settings,
) -> None:
    """Raise `NotRenamable` unless *edits* of *texts* change only the nodes that are *renamed*.

    *made* is the examination of the texts as they are.
    """
    sources: dict[Path, SourceText] = {}
    by_path: dict[Path, list[Edit]] = {}
    for each in edits:
        path = real(each.location.source.name)
        sources[path] = each.location.source
        by_path.setdefault(path, []).append(Edit(each.location.span, each.text))
    changes = _Changes(sources, by_path)
    after = texts.rewritten([changes])
    options = replace(made.options, overlay={**made.options.overlay, **after.changed}, memory={})
    failed: list[SourceError] = []
    _, documents = read_documents(
        after.given, failed, settings, lambda source: read(source, options)
    )
    if failed:
        raise NotRenamable(f"the renamed model cannot be read: {failed[0]}")
    if len(documents) != len(made.documents):
        raise NotRenamable("the renamed model has other files")
    new = {each.graph: each for each in documents}
    for before in made.documents:
        expected = set(_expected(before, edits, renamed))
        found = set(_statements(new[before.graph])) if before.graph in new else set()
        if expected != found:
            raise NotRenamable(_difference(before, expected, found))


def _difference(document: Document, expected: set[Triple], found: set[Triple]) -> str:
    """Return what the file of *document* would say otherwise."""
    lost, gained = sorted(expected - found), sorted(found - expected)
    told = next(iter(lost or gained))
    words = [literal_value(each) if is_literal(each) else each[1:-1] for each in told]
    short = " ".join(each.rpartition("#")[2].lstrip("/") or each for each in words)
    verb = "no longer say" if lost else "say"
    return f"{document.source.name} would {verb} '{short}', so the meaning would change"


def _statements(document: Document) -> Iterator[Triple]:
    """Yield what *document* says of robots, and the texts of elements."""
    for triple in document.statements:
        if triple[1] == TEXT or not triple[1].startswith(OWN):
            yield triple


def _expected(
    document: Document, edits: Sequence[TextEdit], renamed: Mapping[Term, Term]
) -> Iterator[Triple]:
    """Yield what *document* says with the nodes *renamed*, and its values changed by *edits*."""
    changed: dict[str, list[TextEdit]] = {}
    for each in edits:
        changed.setdefault(each.location.source.name, []).append(each)
    names = {each.location.source[each.location.span] for each in edits}
    computed = {local_name(a): local_name(b) for a, b in renamed.items() if is_address(a)}

    def value_of(triple: Triple) -> Term:
        return _literal(document, triple, changed, computed)

    renamed = {**renamed, **dict(_users(document, names.union(computed), value_of))}
    for subject, predicate, value in _statements(document):
        if is_literal(value):
            new = value
            if any(name in value for name in names):
                new = value_of((subject, predicate, value))
        else:
            new = _renamed(value, renamed)
        yield _renamed(subject, renamed), predicate, new


def _users(
    document: Document, names: Collection[str], value_of: Callable[[Triple], Term]
) -> Iterator[tuple[Term, Term]]:
    """Yield the elements that are called after what they refer to, with their new names."""
    if not document.format.is_tree:
        return
    naming = iri(ATTRIBUTE + schema(document.format.lifted_as).names)
    named = {
        s for s, p, o in document.statements if p == naming and literal_value(o) == local_name(s)
    }
    for triple in document.statements:
        subject, predicate, value = triple
        if not predicate.startswith(AT) or not is_literal(value):
            continue
        if predicate != naming and subject in named:
            continue
        if literal_value(value) in names and last_tag(subject):
            new = value_of(triple)
            if new != value and local_name(subject) == literal_value(value):
                yield subject, sibling(subject, last_tag(subject), literal_value(new))


def _renamed(term: Term, renamed: Mapping[Term, Term]) -> Term:
    """Return *term* as the *renamed* node, or as one in it."""
    for old, new in renamed.items():
        if term == old:
            return new
        if term.startswith(old[:-1]) and term[len(old) - 1] in "/;":
            return f"{new[:-1]}{term[len(old) - 1 :]}"
    return term


def _literal(
    document: Document,
    triple: Triple,
    edits: Mapping[str, Sequence[TextEdit]],
    computed: Mapping[str, str],
) -> Term:
    """Return the value of *triple* as it is once *edits* are made where it is written.

    One that xacro computes there becomes another by *computed*.
    """
    span = document.map.triples.get(triple)
    if span is None:
        return triple[2]
    place = document.location(span)
    text, moved = place.source[place.span], 0
    for each in sorted(edits.get(place.source.name, ()), key=lambda one: one.location.span):
        own = each.location.span
        if place.span.start <= own.start and own.end <= place.span.end:
            inner = Span(own.start - place.span.start + moved, own.end - place.span.start + moved)
            text = f"{text[: inner.start]}{each.text}{text[inner.end :]}"
            moved += len(each.text) - (own.end - own.start)
    before = place.source[place.span]
    if before == text:
        return triple[2]
    value = literal_value(triple[2])
    if before not in value:
        return literal(computed.get(value, value))
    return literal(text) if before == value else literal(value.replace(before, text))
