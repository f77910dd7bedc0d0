"""A SHACL validation report in Turtle, with repairs as DASH suggests them.

Each result says beyond SHACL where it lies (`kl:file`, `kl:line`, `kl:column`), since a node has
no place. Fixes are `dash:suggestion`s: graph updates of triples to add and to delete
(https://datashapes.org/suggestions.html), the preferred first by `sh:order`.
"""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.addresses import document_iri
from kinlint.errors import SourceError
from kinlint.finding import Finding, Fix
from kinlint.report import Report
from kinlint.reporters.terminal_style import Style
from kinlint.reporters.turtle_text import encodable, node, term
from kinlint.rule import Applicability, Severity
from kinlint.terms import Triple, is_blank, is_iri, literal
from kinlint.text import Position
from kinlint.vocabulary import DASH, KL, RDFS, SH

PREFIXES = {
    "dash": DASH,
    "kl": KL,
    "rdf": "http://www.w3.org/1999/02/22-rdf-syntax-ns#",
    "rdfs": RDFS,
    "sh": SH,
}
_SEVERITIES = {
    Severity.ERROR: "sh:Violation",
    Severity.WARNING: "sh:Warning",
    Severity.INFO: "sh:Info",
}
_APPLICABILITY = {
    Applicability.SAFE: "kl:safe",
    Applicability.UNSAFE: "kl:unsafe",
    Applicability.DISPLAY: "kl:displayOnly",
}


def render(report: Report, style: Style) -> Iterator[str]:
    """The report, a result at a time."""
    return (encodable(piece, style) for piece in _pieces(report))


def _pieces(report: Report) -> Iterator[str]:
    for prefix, namespace in PREFIXES.items():
        yield f"@prefix {prefix}: <{namespace}> .\n"
    results = [*map(_result, report.unsuppressed), *map(_unread, report.errors)]
    conforms = str(not results).lower()
    yield f"\n[] a sh:ValidationReport ;\n  sh:conforms {conforms}"
    for lines in results:
        yield f" ;\n  sh:result {node(lines, 4)}"
    yield " .\n"


def _result(finding: Finding) -> list[str]:
    shape = finding.rule.iri
    lines = [
        "a sh:ValidationResult",
        f"sh:focusNode {term(finding.focus)}",
        f"sh:resultSeverity {_SEVERITIES[finding.severity]}",
        f"sh:resultMessage {literal(finding.message)}",
        f"sh:sourceShape {term(shape if is_blank(shape) else f'<{shape}>')}",
        "sh:sourceConstraintComponent sh:SPARQLConstraintComponent",
        *_place(finding.location.source.name, finding.location.start),
    ]
    if finding.path is not None and is_iri(finding.path):
        lines.append(f"sh:resultPath {term(finding.path)}")
    if finding.value is not None:
        lines.append(f"sh:value {term(finding.value)}")
    for order, fix in enumerate(finding.fixes, 1):
        lines.append(f"dash:suggestion {node(_suggestion(fix, order), 6)}")
    return lines


def _unread(error: SourceError) -> list[str]:
    """The result for a file that cannot be read: whether it conforms, nobody can tell."""
    return [
        "a sh:ValidationResult",
        f"sh:focusNode {document_iri(error.name)}",
        "sh:resultSeverity sh:Violation",
        f"sh:resultMessage {literal(error.cause)}",
        "sh:sourceConstraintComponent kl:ReadableConstraintComponent",
        *_place(error.name, Position(error.line or 1, error.column or 1)),
    ]


def _place(name: str, start: Position) -> list[str]:
    return [f"kl:file {literal(name)}", f"kl:line {start.line}", f"kl:column {start.column}"]


def _suggestion(fix: Fix, order: int) -> list[str]:
    lines = [
        "a dash:GraphUpdate",
        f"sh:order {order}",
        f"sh:message {literal(fix.title)}",
        f"kl:applicability {_APPLICABILITY[fix.applicability]}",
    ]
    if fix.why:
        lines.append(f"rdfs:comment {literal(fix.why)}")
    lines += (f"dash:deletedTriple {_statement(triple)}" for triple in fix.removed)
    lines += (f"dash:addedTriple {_statement(triple)}" for triple in fix.added)
    return lines


def _statement(triple: Triple) -> str:
    subject, predicate, value = map(term, triple)
    return f"[ rdf:subject {subject} ; rdf:predicate {predicate} ; rdf:object {value} ]"
