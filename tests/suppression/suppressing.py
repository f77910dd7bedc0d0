"""A catalogue, findings and documents to try suppressions on."""

from datetime import date

from kinlint.configuration.selection import Policies
from kinlint.configuration.settings import Settings
from kinlint.document import Document, NodeSpans, SourceMap
from kinlint.finding import Finding
from kinlint.formats.turtle.format import TURTLE
from kinlint.rule import Rule, Severity
from kinlint.suppression import suppress
from kinlint.terms import iri, literal
from kinlint.text import Location, SourceText, Span
from kinlint.vocabulary import KL, RULE

TODAY = date(2026, 6, 1)
PLACE = Span(50, 60)
ARM, LEG = iri("https://example.org/arm"), iri("https://example.org/leg")


def rule(code, name, *messages):
    iri_, title = f"{RULE}{name}", f"about {name}"
    return Rule(iri_, code, name, title, "", Severity.WARNING, ("AP5",), messages=messages)


UNUSED_MESSAGES = (
    "The suppression of '{?rule}' silences nothing.",
    "The suppression of '{?rule}' for '{?place}' silences nothing.",
)
UNIT, DROPPED = rule("UNI001", "missing-unit"), rule("LD001", "dropped-term")
RULES = (
    UNIT,
    DROPPED,
    rule("LNT001", "unused-suppression", *UNUSED_MESSAGES),
    rule(
        "LNT002",
        "suppression-of-unknown-rule",
        "No rule is called '{?rule}'.",
        "This suppression names no rule.",
        "No rule is called '{?rule}', the nearest is '{?suggestion}'.",
    ),
    rule("LNT003", "suppression-without-reason", "'{?rule}' has no reason."),
    rule("LNT004", "expired-suppression", "'{?rule}' ended '{?until}'.", "'{?written}' is odd."),
)


def kl(name):
    return iri(f"{KL}{name}")


def document(*statements, name="arm.jsonld", text="x" * 100):
    """Each statement is written at its own number."""
    triples = {triple: Span(at, at + 1) for at, triple in enumerate(statements)}
    nodes = {triple[0]: NodeSpans(Span(90, 99)) for triple in statements}
    graph = f"<urn:kinlint:document:{name}>"
    return Document(
        SourceText(name, text), graph, statements, SourceMap(triples, nodes), format=TURTLE
    )


def finding(one, node=ARM, name="arm.jsonld", text="x" * 100, span=PLACE):
    return Finding(one, one.severity, "", Location(SourceText(name, text), span), node[1:-1], node)


def applied(findings, documents, *, complete=True, **settings):
    policies = Policies(Settings(**settings), RULES)
    return suppress.apply_suppressions(
        findings, documents, policies, complete=complete, today=TODAY
    )


def told(outcome):
    """The codes of what is reported, with a minus sign if it is silenced."""
    return [("-" if one.suppressed is not None else "") + one.rule.code for one in outcome]


def noted(*extra, rule="UNI001"):
    note = "_:note"
    return document(
        (ARM, kl("ignore"), note),
        (note, kl("rule"), literal(rule)),
        *((note, kl(name), literal(value)) for name, value in extra),
    )
