"""The `kl:ignore` statements of models, read for what they silence.

A value names rules by a literal or an IRI (`"UNI001"`, `rule:missing-unit`, `kl:UNI001`), or is
a node that says so with `kl:rule`, says why with `kl:reason` and until when with `kl:until`. What a
comment in XML says is about an element and all that is written within.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING

from kinlint.configuration.selectors import Catalogue
from kinlint.document import Document
from kinlint.errors import UsageError
from kinlint.files import environment
from kinlint.light_dataclasses import dataclass
from kinlint.terms import RDF_TYPE, Term, Triple, iri, iri_value, is_iri, is_literal, literal_value
from kinlint.text import Location, Span
from kinlint.vocabulary import KL, RULE, SRC

if TYPE_CHECKING:
    from datetime import date

IGNORE = iri(f"{KL}ignore")
RULE_NAMED, REASON, _UNTIL = (iri(f"{KL}{name}") for name in ("rule", "reason", "until"))
_GRAPH_NAME = iri(f"{SRC}name")
_NAMED_GRAPH = iri(f"{SRC}NamedGraph")
_COMMENT = iri(f"{SRC}Comment")


@dataclass(frozen=True, slots=True, eq=False)
class Directive:
    """A `kl:ignore` statement, or a comment that says so, about one selector."""

    document: Document
    """The document that contains the statement."""
    statement: Triple
    """The triple whose subject is the node to silence."""
    span: Span
    """The place of the statement."""
    selector: str
    """The selector as written."""
    codes: frozenset[str]
    """Codes of the rules that `selector` names; none if it is unknown."""
    reason: str | None = None
    """The reason given, if there is one."""
    until: str | None = None
    """The end date as written."""
    active: bool = True
    """True if the end date has not passed."""
    whole_file: bool = False
    """True if `node` is the name of the file's graph."""
    extent: Location | None = None
    """The place within which findings are covered; None for the node alone."""

    @property
    def node(self) -> Term:
        """Return the node that the statement is about."""
        return self.statement[0]

    def names(self, codes: frozenset[str]) -> bool:
        """Tell whether the directive silences one of *codes*."""
        return not self.codes.isdisjoint(codes)

    @property
    def justification(self) -> str:
        """Why a finding is silent: the reason given, or where it is ignored."""
        place = self.document.location(self.span)
        return self.reason or f"kl:ignore at {place.source.name}:{place.start.line}"


def find_directives(
    documents: Iterable[Document], catalogue: Catalogue, today: date | None = None
) -> tuple[Directive, ...]:
    """Every `kl:ignore` of *documents*, in their order; *today* is the day of the run."""
    return tuple(
        directive
        for document in documents
        if document.saying(IGNORE)
        for directive in _file_directives(document, catalogue, today)
    )


def _file_directives(
    document: Document, catalogue: Catalogue, today: date | None
) -> Iterator[Directive]:
    said: dict[tuple[Term, Term], list[Term]] = defaultdict(list)
    for subject, predicate, value in document.statements:
        if predicate in (RULE_NAMED, REASON, _UNTIL):
            said[subject, predicate].append(value)
    graphs = _graph_names(document)
    comments = {s for s, p, o in document.statements if o == _COMMENT and p == RDF_TYPE}
    for statement in document.statements:
        if statement[1] != IGNORE:
            continue
        value = statement[2]
        until = next(iter(said.get((value, _UNTIL), ())), None)
        reason = next(iter(said.get((value, REASON), ())), None)
        for named in [(value, RULE_NAMED, rule) for rule in said.get((value, RULE_NAMED), ())] or [
            statement
        ]:
            selector = _selector(named[2])
            yield Directive(
                document=document,
                statement=statement,
                span=_span(document, named, statement),
                selector=selector,
                codes=_codes(selector, catalogue),
                reason=_text(reason),
                until=_text(until),
                active=until is None or _lasts(_text(until) or "", today),
                whole_file=statement[0] in graphs,
                extent=_extent(document, statement[0]) if value in comments else None,
            )


def _extent(document: Document, node: Term) -> Location | None:
    """Return the place of *node* with all that belongs to it; None if it is not described."""
    spans = document.map.nodes.get(node)
    return document.location(spans.whole) if spans else None


def _graph_names(document: Document) -> frozenset[Term]:
    """The nodes that stand for the whole file."""
    losses = {s for s, _, o in document.statements if o == _NAMED_GRAPH}
    names = (o for s, p, o in document.statements if p == _GRAPH_NAME and s in losses)
    return frozenset({document.graph, *names})


def _span(document: Document, *statements: Triple) -> Span:
    """The span of the first of *statements* that is located, else of its subject."""
    spans: Mapping[Triple, Span] = document.map.triples
    for statement in statements:
        if span := spans.get(statement):
            return span
    node = document.map.nodes.get(statements[-1][0])
    return node.best if node else Span(0, 0)


def _selector(value: Term) -> str:
    if is_literal(value):
        return literal_value(value)
    if not is_iri(value):
        return ""
    written = iri_value(value)
    for namespace in (RULE, KL):
        if written.startswith(namespace):
            return written.removeprefix(namespace)
    return written


def _codes(selector: str, catalogue: Catalogue) -> frozenset[str]:
    try:
        return catalogue.find(selector)[1]
    except UsageError:
        return frozenset()


def _text(value: Term | None) -> str | None:
    if value is None:
        return None
    return literal_value(value) if is_literal(value) else value


def _lasts(until: str, today: date | None) -> bool:
    """Tell whether the date *until* has not passed; an invalid date has."""
    from datetime import date  # noqa: PLC0415  few models have such a day

    try:
        return (today or date.fromisoformat(environment.today())) <= date.fromisoformat(until)
    except ValueError:
        return False
