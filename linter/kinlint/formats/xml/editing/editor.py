"""Editing of a document in XML: changes of its statements become edits of its texts."""

from __future__ import annotations

from collections.abc import Iterable
from functools import partial
from itertools import pairwise

from kinlint.document import Document
from kinlint.edits import Delta, Edit, NotExpressible, negated
from kinlint.formats.options import ReadOptions
from kinlint.formats.xml.editing import rewriting, spelling
from kinlint.formats.xml.editing.element_delta import ElementChanges, ValueChange
from kinlint.formats.xml.editing.element_layout import ElementLayout
from kinlint.formats.xml.editing.element_removal import removals
from kinlint.formats.xml.editing.element_sites import SEVERAL, Site, Sites
from kinlint.formats.xml.editing.insertion import Written, insertion, opening, replacement
from kinlint.formats.xml.editing.new_elements import NewElements
from kinlint.formats.xml.editing.rewriting import Place, Values
from kinlint.formats.xml.editing.start_tag import NAME, StartTag
from kinlint.formats.xml.editing.syntax_fixes import split_delta, syntax_edits
from kinlint.terms import Term, is_blank, is_literal, literal_value
from kinlint.text import Span


class Editor:
    """Edits of one document."""

    def __init__(self, document: Document, options: ReadOptions) -> None:
        del options
        self._document, self._sites = document, Sites(document)

    def edits(self, delta: Delta) -> list[Edit]:
        """Return the smallest edits that say *delta*, in order.

        Raises Unsayable if there are none.
        """
        rest, about = split_delta(self._document, delta)
        edits = _Writing(self._sites, rest).edits() if rest else []
        if not about:
            return edits
        return merged_edits([*edits, *syntax_edits(self._document, self._sites, about)])


class _Writing:
    """State of writing one delta into the text."""

    def __init__(self, sites: Sites, delta: Delta) -> None:
        self._sites = sites
        self._changes = ElementChanges.from_delta(delta, sites.elements)
        said = {literal_value(value) for _, _, value in delta.removed if is_literal(value)}
        self._kept = frozenset(said.union(map(negated, said)))
        self._fresh = NewElements(sites, self._changes, self._kept, self._taken)
        self._edits: list[Edit] = []
        self._awaited: dict[tuple[int, Edit], int] = {}

    def edits(self) -> list[Edit]:
        """Return all edits, in order."""
        changes = self._changes
        gone = [*changes.deleted, *changes.moved]
        self._sites.check_uses(gone)
        for node, change in changes.values.items():
            if not is_blank(node):
                self._say(node, change)
        for node, tag in changes.renamed.items():
            self._rename(node, tag)
        parents = [each for each in changes.children if not is_blank(each)]
        for parent in sorted(parents, key=lambda each: not self._is_below(each, changes.moved)):
            self._fill(parent, gone)
        new = {each for each in (*changes.values, *changes.children) if is_blank(each)}
        if not new <= self._fresh.written:
            raise NotExpressible("a new element stands nowhere")
        self._delete(gone)
        if any(self._awaited.values()):
            raise NotExpressible(SEVERAL)
        return merged_edits(self._edits)

    def _is_below(self, node: Term, others: Iterable[Term]) -> bool:
        """Tell whether *node* is one of *others* or written within one of them."""
        known, at = self._sites.elements, node
        while at in known and at not in others:
            at = known[at].parent
        return at in others

    def _taken(self, span: Span) -> list[Edit]:
        """Remove and return the edits within *span*, which are made elsewhere instead."""
        own = [each for each in self._edits if _is_in(each.span, span)]
        self._edits = [each for each in self._edits if not _is_in(each.span, span)]
        return own

    def _make(self, site: Site, edits: Iterable[Edit]) -> None:
        """Keep *edits* of the text of *site*; this may undo others.

        A text that stands for several elements is edited once, for all of them.
        """
        own = list(edits)
        made = list(site.document_edits(own))
        if (uses := self._sites.use_count(site)) > 1:
            for edit in own:
                key = id(site.layout), edit
                self._awaited[key] = self._awaited.get(key, uses) - 1
            made = [each for each in made if each not in self._edits]
        self._edits += made

    def _say(self, node: Term, change: ValueChange) -> None:
        site, slots = self._site(node), self._sites.elements[node].slots
        place = partial(self._sites.component, node)
        start = StartTag(site.layout, site.number, slots, self._kept, place)
        self._make(site, start.edits(change))
        if "" in change.removed or "" in change.added:
            old = slots.get("", {})
            self._make(site, text_edits(site, old, change, self._kept, partial(place, "")))

    def _site(self, node: Term) -> Site:
        site, tag = self._sites.shared_site(node), self._changes.renamed.get(node)
        return site._replace(tag=tag) if tag else site

    def _rename(self, node: Term, tag: str) -> None:
        if not NAME.fullmatch(tag):
            raise NotExpressible(f"{tag} is not a name in XML")
        site = self._sites.shared_site(node)
        names = site.layout.names(site.number)
        self._make(site, [Edit(span, tag) for span in names])

    def _fill(self, parent: Term, gone: list[Term]) -> None:
        """Put new children into *parent*, the first ones where others are *gone* from."""
        site = self._site(parent)
        layout, number = site.layout, site.number
        places = {
            self._sites.shared_site(each).number: each
            for each in gone
            if self._stands_in(each, site)
        }
        behind: dict[int | None, list[Written]] = {}
        for tag, node in self._changes.children[parent]:
            new = self._fresh.element(tag, node, layout, layout.quote(number))
            if places:
                alike = (each for each in places if layout.name(each) == tag)
                at = next(alike, next(iter(places)))
                gone.remove(places.pop(at))
                self._make(site, [replacement(layout, at, new)])
            else:
                behind.setdefault(_place(layout, number, tag), []).append(new)
        self._make(site, [insertion(site, new, at) for at, new in behind.items()])

    def _stands_in(self, node: Term, site: Site) -> bool:
        own = self._sites.shared_site(node)
        return own.begin == site.begin and own.layout.parents[own.number] == site.number

    def _delete(self, gone: list[Term]) -> None:
        texts: dict[int, list[Site]] = {}
        for node in gone:
            site = self._sites.shared_site(node)
            if site.layout.parents[site.number] < 0:
                raise NotExpressible("a file has a root element")
            parent = self._sites.elements[node].parent
            if self._is_below(parent, self._changes.moved):
                raise NotExpressible("the changes touch each other")
            if not self._is_below(parent, self._changes.deleted):
                texts.setdefault(site.begin, []).append(site)
        for sites in texts.values():
            numbers = dict.fromkeys(each.number for each in sites)
            self._edits += sites[0].document_edits(removals(sites[0].layout, numbers))


def _is_in(inner: Span, outer: Span) -> bool:
    """Tell whether *inner* is a part of an element at *outer*, neither all of it nor behind it."""
    return outer.start < inner.start < outer.end


def _place(layout: ElementLayout, parent: int, tag: str) -> int | None:
    """Return the child of an element that a new one with *tag* comes after."""
    last = layout.last_children(parent)
    return last.get(tag, next(iter(last.values()), None))


def merged_edits(edits: Iterable[Edit]) -> list[Edit]:
    """Return *edits* in order, insertions at one place as one."""
    merged: list[Edit] = []
    for edit in sorted(edits, key=lambda each: each.span):
        if merged and merged[-1].span == edit.span and edit.span.start == edit.span.end:
            merged[-1] = Edit(edit.span, merged[-1].text + edit.text)
        else:
            merged.append(edit)
    if any(one.span.end > other.span.start for one, other in pairwise(merged)):
        raise NotExpressible("the changes touch each other")
    return merged


def text_edits(
    site: Site, old: Values, change: ValueChange, kept: frozenset[str], place: Place
) -> list[Edit]:
    """Return the edits that make *change* of the text of the element at *site*, which is *old*.

    *place* tells where a component of it was read from; *kept* are spellings that stay.
    """
    layout, number = site.layout, site.number
    new = rewriting.merged_values(old, change.removed.get("", {}), change.added.get("", {}), "text")
    runs = [] if layout.closed(number) else layout.places.runs(number)
    raw = "".join(
        layout.source[run]
        if layout.in_section(run.start)
        else spelling.unescaped(layout.source[run])
        for run in runs
    )
    literal = spelling.tokens(raw) == spelling.tokens(rewriting.current_text(old))
    if not literal and not (old and new and runs):
        raise NotExpressible(rewriting.NOT_LITERAL)
    if old and not new:
        return [Edit(run, "") for run in runs]
    if not old:
        return [
            _first(
                site, spelling.escaped_text(rewriting.formatted_values(new, kept), layout.source)
            )
        ]
    write = spelling.cdata_content if layout.in_section(runs[0].start) else spelling.escaped_text
    value = rewriting.Rewriting(
        layout.text, old, new, kept, partial(write, source=layout.source), place
    )
    return value.edits(runs) if literal else value.edits_of_parts()


def _first(site: Site, text: str) -> Edit:
    """Return the edit that gives *text* to an element that had none."""
    layout, number = site.layout, site.number
    if layout.closed(number):
        return Edit(opening(layout, number), f">{text}</{site.tag}>")
    if layout.children[number]:
        raise NotExpressible("there are elements in place of a text")
    start, end = layout.content(number)
    blank = not layout.text[start:end].strip()
    return Edit(Span(start, end if blank else start), text)
