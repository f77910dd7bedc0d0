"""The words of a finding: its place, message and reason, from a result of an engine."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.addresses import is_address, without_file
from kinlint.catalogue.rulebook import Rulebook
from kinlint.engine.constraint import Constraint
from kinlint.engine.result import Result
from kinlint.engine.store import Store
from kinlint.finding import Finding
from kinlint.findings.grouping import COUNT
from kinlint.findings.locator import Locator
from kinlint.findings.message_of_result import template_of
from kinlint.findings.wording import Wording
from kinlint.message_template import counted, filled
from kinlint.rule import SEVERITY_BY_IRI, SPEAKS_OF, Rule, Severity, SeverityFor
from kinlint.term_format import TermFormatter
from kinlint.terms import XSD, Term, iri, iri_value, is_iri, is_literal, literal, literal_value
from kinlint.vocabulary import FACT, FEATURE, SRC

PLACES = iri(f"{SRC}from"), iri(f"{SRC}node")
"""Properties from what was lifted, and from a flaw, to the element that says it."""
WRITTEN = iri(f"{FACT}feature")


def reason_for(result: Result, finding: Finding, locator: Locator) -> str:
    """Return the sentence that says why *result* makes *finding*; empty if its rule has none."""
    template = result.constraint.because
    wording = Wording(locator, finding.location, finding.focus)
    return filled(template, wording.words(template, dict(placeholder_terms(result))))


def brief_finding(result: Result, locator: Locator, rulebook: Rulebook) -> Finding:
    """Return the finding that *result* makes, without `related` and `because`."""
    rule = rulebook.by_iri[result.constraint.owner]
    location = locator.result_location(result, rulebook.axioms)
    wording = Wording(locator, location, result.focus)
    display = wording.display
    template = template_of(result, rule)
    terms = dict(placeholder_terms(result))
    if rule.group_by and COUNT not in terms:
        terms[COUNT] = literal("1", f"{XSD}integer")
    words = wording.words(template, terms)
    count = 0 if COUNT in words else _number(terms.get(COUNT))
    about = locator.described(result.focus)
    return Finding(
        rule=rule,
        severity=_severity(result.constraint, rule),
        message=counted(filled(template, words), count),
        location=location,
        iri=iri_value(about) if is_iri(about) else locator.anonymous(about, location),
        focus=result.focus,
        targets=result.constraint.consumers,
        severity_for=tuple(
            SeverityFor(SEVERITY_BY_IRI[severity], consumers, formats)
            for severity, consumers, formats in result.constraint.severity_for
            if severity in SEVERITY_BY_IRI
        ),
        versions=(_text(terms.get("targetSince")), _text(terms.get("targetUntil"))),
        feature=_feature(result, rule, locator.store),
        speaks_of=SPEAKS_OF.get(result.constraint.speaks_of, ""),
        path=result.path,
        value=result.value,
        template=template,
        arguments=tuple(words.values()),
        meant=tuple(_meant(terms.get(name), display) for name in words),
        group=tuple(display.term(term) for name in rule.group_by if (term := terms.get(name))),
        extent=_size(terms.get(rule.worst)),
    )


def _text(term: Term | None) -> str:
    """Return what the literal *term* says; empty if it is none."""
    return literal_value(term) if term is not None and is_literal(term) else ""


def _feature(result: Result, rule: Rule, store: Store) -> str:
    """Return the name of the feature that *result* found; empty if it found none.

    Its query or its constraint tells it, or its place has one that *rule* reports.
    """
    found = result.bindings.get("feature", "")
    if named := iri_value(found) if is_iri(found) else result.constraint.feature:
        return named.removeprefix(FEATURE)
    about = [result.focus, result.bindings.get("at", result.focus)]
    about += [place for way in PLACES for place in store.values(result.focus, way)]
    written = (each for place in about for each in store.values(place, WRITTEN))
    names = sorted(iri_value(each).removeprefix(FEATURE) for each in written)
    return next((name for name in names if rule.name in _told_by(name)), "")


def _told_by(feature: str) -> frozenset[str]:
    from kinlint.targets.consumer_files import consumer_table  # noqa: PLC0415  few runs have targets

    return consumer_table().features[feature].told_by


def _number(term: Term | None) -> int:
    """Return the whole number that *term* is, else 0."""
    value = literal_value(term) if term is not None and is_literal(term) else ""
    return int(value) if value.isdecimal() else 0


def _size(term: Term | None) -> float:
    """Return the size of the number that *term* is, else 0."""
    try:
        return abs(float(literal_value(term))) if term is not None and is_literal(term) else 0.0
    except ValueError:
        return 0.0


def placeholder_terms(result: Result) -> Iterator[tuple[str, Term | None]]:
    """Yield the terms that placeholders of a message stand for, by name."""
    yield from result.bindings.items()
    yield from (("this", result.focus), ("path", result.path), ("value", result.value))


def _meant(term: Term | None, display: TermFormatter) -> str:
    """Return a spelling of *term* that does not depend on prefixes or on the name of its file."""
    if term is None:
        return ""
    if not is_iri(term):
        return display.term(term)
    if not is_address(term):
        return iri_value(term)
    return without_file(iri_value(term)) if "#" in term else display.term(term)


def _severity(constraint: Constraint, rule: Rule) -> Severity:
    """Return the severity of a constraint that stands in the rule itself, or else of the rule."""
    if constraint.shape != iri(rule.iri):
        return rule.severity
    return SEVERITY_BY_IRI.get(constraint.severity, rule.severity)
