"""Changes of the text of an element."""

from __future__ import annotations

from functools import partial

from kinlint.edits import Edit, Unsayable
from kinlint.formats.xml.editing import rewriting, spelling
from kinlint.formats.xml.editing.element_delta import Change
from kinlint.formats.xml.editing.element_sites import Site
from kinlint.formats.xml.editing.insertion import opening
from kinlint.formats.xml.editing.rewriting import Place, Values
from kinlint.text import Span


def text_edits(
    site: Site, old: Values, change: Change, kept: frozenset[str], place: Place
) -> list[Edit]:
    """The edits that make *change* of the text of the element at *site*, which is *old*.

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
        raise Unsayable(rewriting.NOT_LITERAL)
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
        raise Unsayable("there are elements in place of a text")
    start, end = layout.content(number)
    blank = not layout.text[start:end].strip()
    return Edit(Span(start, end if blank else start), text)
