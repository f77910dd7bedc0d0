"""Results as assertions of EARL 1.0, the W3C's Evaluation and Report Language, in Turtle.

Each finding is an assertion that its rule failed for a file, with the place as a pointer
(Pointer Methods in RDF 1.0); each rule without findings passed for all files of the run; of a file
that cannot be read nothing can be told. https://www.w3.org/TR/EARL10-Schema/
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinlint.addresses import document_iri
from kinlint.report import Report
from kinlint.reporters.terminal_style import Style
from kinlint.reporters.turtle_text import encodable, node, term
from kinlint.rule import Rule
from kinlint.terms import is_blank, literal
from kinlint.text import Position
from kinlint.vocabulary import KINLINT, KL

PREFIXES = {
    "dct": "http://purl.org/dc/terms/",
    "doap": "http://usefulinc.com/ns/doap#",
    "earl": "http://www.w3.org/ns/earl#",
    "kl": KL,
    "ptr": "http://www.w3.org/2009/pointers#",
}
ASSERTOR, RUN = "_:kinlint", "_:run"
"""The nodes of the tool, and of all files together."""


def render(report: Report, style: Style) -> Iterator[str]:
    """Yield the report, an assertion at a time."""
    return (encodable(piece, style) for piece in _pieces(report))


def _pieces(report: Report) -> Iterator[str]:
    for prefix, namespace in PREFIXES.items():
        yield f"@prefix {prefix}: <{namespace}> .\n"
    about = f'doap:name "kinlint" ; doap:revision {literal(report.version)}'
    yield f"\n{ASSERTOR} a earl:Software ; {about} ; doap:homepage <{KINLINT}> .\n"
    names = (*report.files, *(error.name for error in report.errors))
    files = [term(document_iri(name)) for name in dict.fromkeys(names)]
    parts = "".join(f" ;\n  dct:hasPart {file}" for file in files)
    yield f"{RUN} a earl:TestSubject{parts} .\n"
    for finding in report.unsuppressed:
        name = finding.location.source.name
        result = [
            "a earl:TestResult",
            "earl:outcome earl:failed",
            f"kl:severity {literal(finding.severity.label)}",
            f"dct:description {literal(finding.message)}",
            f"earl:pointer {_pointer(name, finding.location.start)}",
        ]
        yield _assertion(_test(finding.rule), term(document_iri(name)), result)
    failed = {finding.rule.code for finding in report.findings}
    for rule in report.rules:
        if rule.code not in failed and report.files:
            yield _assertion(_test(rule), RUN, ["a earl:TestResult", "earl:outcome earl:passed"])
    for error in report.errors:
        place = Position(error.line or 1, error.column or 1)
        result = [
            "a earl:TestResult",
            "earl:outcome earl:cantTell",
            f"dct:description {literal(error.cause)}",
            f"earl:pointer {_pointer(error.name, place)}",
        ]
        yield _assertion(f"<{KL}readable>", term(document_iri(error.name)), result)


def _assertion(test: str, subject: str, result: Sequence[str]) -> str:
    lines = [
        "a earl:Assertion",
        f"earl:assertedBy {ASSERTOR}",
        f"earl:subject {subject}",
        f"earl:test {test}",
        "earl:mode earl:automatic",
        f"earl:result {node(result, 4)}",
    ]
    return f"\n{node(lines, 2)} .\n"


def _test(rule: Rule) -> str:
    """Return the node of *rule*, which of a shape without a name is blank."""
    return term(rule.iri if is_blank(rule.iri) else f"<{rule.iri}>")


def _pointer(name: str, start: Position) -> str:
    """Return a pointer to the place *start* in the file called *name*, in characters from 1."""
    return (
        f"[ a ptr:LineCharPointer ; ptr:reference {term(document_iri(name))} ; "
        f"ptr:lineNumber {start.line} ; ptr:charNumber {start.column} ]"
    )
