"""A pipeline that finds what a test says, to look at the command around it."""

from __future__ import annotations

from dataclasses import dataclass, field

from kinlint.catalogue.rulebook import Rulebook
from kinlint.cli import check_command
from kinlint.configuration.settings import Settings
from kinlint.errors import SourceError
from kinlint.finding import Finding
from kinlint.report import Report
from kinlint.rule import Rule, Severity
from kinlint.text import Location, SourceText, Span

RULES = tuple(
    Rule(
        f"https://w3id.org/kinlint/rules/{name}",
        code,
        name,
        f"{name} is at fault",
        "Because.",
        severity,
        ("AP5",),
        ("jsonld",),
        messages=(f"{name} is at fault.",),
        path=f"rules/{name}.ttl",
    )
    for code, name, severity in (
        ("UNI001", "missing-unit", Severity.WARNING),
        ("UNI002", "unit-quantity-mismatch", Severity.ERROR),
        ("LD001", "dropped-term", Severity.ERROR),
        ("LIM009", "tight-limit", Severity.INFO),
    )
)
BOOK = Rulebook(RULES, (), (), (), ())


@dataclass
class Pipeline:
    """Finds the rules of `found` in the first input; remembers what it was given."""

    found: list[str] = field(default_factory=list)
    suppressed: list[str] = field(default_factory=list)
    errors: list[SourceError] = field(default_factory=list)
    settings: Settings | None = None
    inputs: list[str] = field(default_factory=list)

    def report(self, run, *_):
        self.settings, found, book = run.settings, run.found, run.book
        self.inputs = [one.name for one in found.inputs]
        return Report(
            findings=tuple(self._finding(code) for code in self.found),
            suppressed=tuple(self._finding(code, "a toy") for code in self.suppressed),
            files=tuple(self.inputs),
            errors=(*found.errors, *self.errors),
            rules=book.rules,
        )

    def _finding(self, code, suppressed=None):
        rule = BOOK.by_code[code]
        name = self.inputs[0]
        return Finding(
            rule,
            rule.severity,
            rule.messages[0],
            Location(SourceText(name, '{"@id": "x"}'), Span(1, 6)),
            "https://example.org/x",
            "<https://example.org/x>",
            template=rule.messages[0],
            suppressed=suppressed,
        )


def install(monkeypatch):
    """Put the pipeline in the place of the true one."""
    pipeline = Pipeline()

    def report(run, *given):
        return pipeline.report(run, *given)

    monkeypatch.setattr(check_command.LintRun, "report", report)
    monkeypatch.setattr(check_command.rulebook, "load", lambda *_: BOOK)
    return pipeline
