"""New elements as text, with what moves into them."""

from __future__ import annotations

from collections.abc import Callable

from kinlint.edits import Edit, NotExpressible, applied
from kinlint.formats.xml.editing import rewriting, spelling
from kinlint.formats.xml.editing.element_delta import ElementChanges, ValueChange
from kinlint.formats.xml.editing.element_layout import BREAK, ElementLayout
from kinlint.formats.xml.editing.element_sites import Sites
from kinlint.formats.xml.editing.insertion import ElementStyle, Written, within
from kinlint.formats.xml.editing.start_tag import NAME, listed
from kinlint.light_dataclasses import dataclass, field
from kinlint.terms import Term
from kinlint.text import Span

Taken = Callable[[Span], list[Edit]]
"""The edits of a span of the document, which are no longer made there."""


@dataclass
class NewElements:
    """Writer of new and moved elements."""

    sites: Sites
    """Places of the elements of the text."""
    changes: ElementChanges
    """Changes that ask for them."""
    kept: frozenset[str]
    """Spellings that stay."""
    taken: Taken
    """Returns the edits that already change a range of the text."""
    written: set[Term] = field(default_factory=set)
    """Nodes that were written so far."""

    def element(self, tag: str, node: Term, layout: ElementLayout, quote: str) -> Written:
        """Return *node* as a new element with *tag*, for a text with a *layout*."""
        if not NAME.fullmatch(tag):
            raise NotExpressible(f"{tag} is not a name in XML")
        if node in self.changes.moved:
            return self._moved(node, layout)
        self.written.add(node)
        slots = self.changes.values.get(node, ValueChange()).added
        children = [
            self.element(name, each, layout, quote)
            for name, each in self.changes.children.get(node, ())
        ]
        head = " ".join((tag, *listed(slots, quote, layout, self.kept)))
        text = ""
        if "" in slots:
            plain = rewriting.formatted_values(
                rewriting.merged_values({}, {}, slots[""], "text"), self.kept
            )
            text = spelling.escaped_text(plain, layout.source)
        if children and text:
            raise NotExpressible("there are elements in place of a text")

        def write(manner: ElementStyle) -> str:
            inside = within(manner, children) if children else text
            return f"<{head}>{inside}</{tag}>" if inside else f"<{head}{layout.ending}"

        return write

    def _moved(self, node: Term, layout: ElementLayout) -> Written:
        """Return *node* as it is written in its old place, with its lines indented anew."""
        site = self.sites[node]
        if site.layout.source.encoding != layout.source.encoding:
            raise NotExpressible("the files have different encodings")
        old = site.layout.indent(site.number) or ""

        def write(manner: ElementStyle) -> str:
            span = site.whole
            own = [
                Edit(Span(each.start - span.start, each.end - span.start), text)
                for each, text in self.taken(span)
            ]
            text = applied(site.layout.source[site.layout.whole(site.number)], own)
            if not manner.line_end:
                return text
            first, *rest = BREAK.split(text)
            lines = (
                f"{manner.indent}{line[len(old) :]}" if line.startswith(old) and line else line
                for line in rest
            )
            return manner.line_end.join((first, *lines))

        return write
