"""Results of Oxigraph's parsers, as kinlint's terms."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from kinlint.errors import SourceError
from kinlint.formats.blank_nodes import BlankNodes
from kinlint.terms import Term, Triple, blank, iri, literal
from kinlint.text import SourceText

if TYPE_CHECKING:
    from pyoxigraph import RdfFormat


def triples(
    source: SourceText, form: RdfFormat, base: str | None, blanks: BlankNodes | None = None
) -> Iterator[Triple]:
    """Yield the triples of *source*, graph names left out; blank nodes renamed by *blanks*.

    Raises SourceError with line and column when it is not what *form* says.
    """
    from pyoxigraph import parse  # noqa: PLC0415  a native module, needed only here

    try:
        for quad in parse(source.text, format=form, base_iri=base):
            yield (
                _term(quad.subject, source, blanks),
                _term(quad.predicate, source, blanks),
                _term(quad.object, source, blanks),
            )
    except SyntaxError as error:
        cause = f"not {form.name}: {error.msg.partition(': ')[2]}"
        raise SourceError(source.name, cause, *_place(source, error)) from None


def _term(term: Any, source: SourceText, blanks: BlankNodes | None) -> Term:
    kind = type(term).__name__
    if kind == "NamedNode":
        return iri(term.value)
    if kind == "BlankNode":
        return blanks.named(term.value) if blanks else blank(term.value)
    if kind == "Literal":
        return literal(term.value, term.datatype.value, term.language or "")
    raise SourceError(source.name, "triples about triples (RDF-star) are not supported")


def _place(source: SourceText, error: SyntaxError) -> tuple[int | None, int | None]:
    """Return line and column: Oxigraph counts code points, and lines by their line feeds."""
    if error.lineno is None:
        return None, None
    return min(error.lineno, len(source.line_starts)), error.offset
