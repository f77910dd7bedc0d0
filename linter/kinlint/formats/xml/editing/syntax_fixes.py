"""Places that break the rules of XML, or are ignored by readers, written as intended.

That is what it takes for a document to say no more what it says of such a place.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from kinlint.document import Document
from kinlint.edits import Delta, Edit, NotExpressible
from kinlint.formats.source_layer import src
from kinlint.formats.xml.editing.element_layout import ElementLayout
from kinlint.formats.xml.editing.element_removal import with_lines
from kinlint.formats.xml.editing.element_sites import Site, Sites
from kinlint.formats.xml.editing.rewriting import NOT_LITERAL
from kinlint.formats.xml.editing.start_tag import deletions
from kinlint.formats.xml.recovery import CONTROL, DECLARATION, HYPHENS, MARKS, OTHERWISE_SOUND
from kinlint.formats.xml.tag_scanner import LOST
from kinlint.terms import RDF_TYPE, Triple, is_blank
from kinlint.text import Span

NODE, SPACED = src("node"), src("UnreadSpace")
KINDS = {
    src("MalformedText"): src("reason"),
    src("RepeatedAttribute"): src("attribute"),
    src("StrayText"): src("written"),
    SPACED: src("reason"),
}
"""Property that describes a repairable flaw of the syntax, by the type of the flaw."""

BREAK = re.compile(r"\s*[\t\r\n]\s*")
NUMBERS = re.compile(r"[-+.\deE\s]*")
VERSION = re.compile(r"version\s*=\s*[\"']([^\"']*)")
UNICODE = ("utf-8", "ascii")
WRITTEN = {"<": "&lt;", ">": "&gt;"}
OPEN, CLOSE = "<!--", "-->"
PAIR = 2


def split_delta(document: Document, delta: Delta) -> tuple[Delta, list[Triple]]:
    """Return the part of *delta* about elements, and the removed triples about syntax errors."""
    gone = [each for each in delta.removed if is_blank(each[0])]
    if not gone:
        return delta, []
    kinds = {s: KINDS.get(o) for s, p, o in document.statements if p == RDF_TYPE and is_blank(s)}
    about = [each for each in gone if kinds.get(each[0]) == each[1]]
    rest = tuple(each for each in delta.removed if each not in set(about))
    return Delta(rest, delta.added), about


def syntax_edits(document: Document, sites: Sites, about: list[Triple]) -> Iterator[Edit]:
    """Yield the edits of *document* after which it no longer says any of *about*."""
    places = {s: o for s, p, o in document.statements if p == NODE}
    spaced = {s for s, p, o in document.statements if p == RDF_TYPE and o == SPACED}
    for triple in about:
        node, predicate, _ = triple
        span = document.map.nodes[node].whole
        if predicate == src("reason"):
            place = document.location(span)
            begin = span.start - place.span.start
            correct = _respaced if node in spaced else _corrected
            for (start, end), text in correct(sites.layout(place.source), place.span):
                yield Edit(Span(start + begin, end + begin), text)
            continue
        site = sites[places[node]]
        if predicate == src("attribute"):
            yield from site.document_edits(_without_attribute(site, span.start - site.begin))
        else:
            yield from site.document_edits(_without_text(site))


def _without_attribute(site: Site, at: int) -> Iterator[Edit]:
    return deletions(site.layout, site.number, lambda each: each.key.start == at)


def _without_text(site: Site) -> Iterator[Edit]:
    for run in site.layout.places.runs(site.number):
        if not CONTROL.fullmatch(site.layout.source[run]):
            yield Edit(with_lines(site.layout, run), "")


def _respaced(layout: ElementLayout, span: Span) -> Iterator[Edit]:
    """Separate numbers by blanks, with nothing around them."""
    written = layout.source[span]
    if not NUMBERS.fullmatch(written):
        raise NotExpressible(NOT_LITERAL)
    yield Edit(span, BREAK.sub(" ", written.strip()))


def _corrected(layout: ElementLayout, span: Span) -> Iterator[Edit]:
    text, start = layout.text, span.start
    written = layout.source[span]
    lost = LOST.match(text)
    if lost is not None and start == lost.start("cut"):
        yield Edit(Span(start, start), "<?" if lost["cut"].startswith("xml") else "<")
    elif written.startswith("&"):
        yield Edit(Span(start, start + 1), "&amp;")
    elif written in WRITTEN or MARKS.fullmatch(written):
        yield Edit(span, WRITTEN.get(written, ""))
    elif CONTROL.fullmatch(written):
        yield Edit(span, " " * len(written))
    elif OTHERWISE_SOUND.fullmatch(written) and not start and (version := VERSION.search(written)):
        yield Edit(Span(*version.span(1)), "1.0")
    elif DECLARATION.match(written) and start and not layout.before(start):
        yield Edit(Span(0, start), "")
    elif DECLARATION.match(written) and start and layout.source.encoding in UNICODE:
        yield Edit(with_lines(layout, span), "")
    elif HYPHENS.fullmatch(written):
        yield from _comment(text, start)
    elif start and text[start - 1] in "\"'":
        yield Edit(Span(start, start), " ")
    else:
        raise NotExpressible("it is unclear what is meant")


def _comment(text: str, at: int) -> Iterator[Edit]:
    """Separate the hyphens in a comment, or make a line of them."""
    start, end = text.rfind(OPEN, 0, at) + len(OPEN), text.find(CLOSE, at)
    for match in HYPHENS.finditer(text, start, end):
        apart = len(match[0]) == PAIR and match.end() < end
        yield Edit(Span(*match.span()), "- -" if apart else "=" * len(match[0]))
