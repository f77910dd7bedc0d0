"""Entries of a baseline that are found no more, as findings: suppressions that silence nothing."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator

from kinlint.baseline.baseline_file import Baseline
from kinlint.baseline.entry_identity import Entry
from kinlint.baseline.ledger import Ledger
from kinlint.finding import Finding
from kinlint.report import Report
from kinlint.rule import Rule
from kinlint.suppression.suppression_faults import UNUSED, fill_message
from kinlint.text import Location


def stale_entries(
    left: Iterable[Entry], report: Report, ledger: Ledger, searched: Callable[[str], bool]
) -> list[Entry]:
    """The entries of *ledger* that are *left* and that *report* would have if they were there.

    Nothing is known of files that were not linted, of rules that were not asked, and of anything
    if a file could not be read. Where others were not linted that the ledger has, or that composed
    a model with them, what is said in several files need not be found either; a file of elements
    speaks for itself. Of a file that is gone all is found no more if the run *searched* where it
    lay.
    """
    if report.errors:
        return []
    files = {ledger.names.relative_path(name) for name in report.files}
    codes = {rule.code for rule in report.rules}
    paths = {*ledger.composed, *(one.path for one in ledger.entries)}
    whole = all(path in files or ledger.gone(path) for path in paths)
    return [
        one
        for one in left
        if one.rule in codes
        and (
            (whole or one.entity.startswith(f"{one.path}#"))
            if one.path in files
            else whole and ledger.gone(one.path) and searched(one.path)
        )
    ]


def stale_findings(
    entries: Iterable[Entry], baseline: Baseline, rules: Collection[Rule]
) -> Iterator[Finding]:
    """A finding in the file of *baseline* for each of its *entries*; none if no rule is asked."""
    rule = next((rule for rule in rules if rule.name == UNUSED), None)
    if rule is None:
        return
    for one in entries:
        values = {"rule": one.rule, "known": one.entity or one.path}
        message, template, arguments = fill_message(rule, values)
        yield Finding(
            rule=rule,
            severity=rule.severity,
            message=message,
            location=Location(baseline.source, one.span),
            iri="",
            focus="",
            template=template,
            arguments=arguments,
        )
