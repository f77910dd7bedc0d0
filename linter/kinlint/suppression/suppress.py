"""Applies suppressions to findings, and reports faulty suppressions.

Two sources silence findings. A model says `kl:ignore` on a node: findings about that node, and if a
comment says so also those within; on the name of the file's graph: findings in that file. A
configuration says so for files, for a JSON Pointer in a file, or for an entity's IRI
(`settings.Ignore`). Nothing here removes a finding: `Finding.suppressed` tells why it is not to be
shown.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

from kinlint.configuration.selection import Policies
from kinlint.document import Document
from kinlint.finding import Finding
from kinlint.light_dataclasses import replace
from kinlint.suppression.config_ignores import ConfigIgnores
from kinlint.suppression.directive import Directive, find_directives
from kinlint.suppression.interval_index import IntervalIndex
from kinlint.suppression.suppression_faults import (
    FAULTS,
    UNUSED,
    SuppressionFault,
    fault_finding,
    faults,
)
from kinlint.terms import Term
from kinlint.text import Span

if TYPE_CHECKING:
    from datetime import date


def apply_suppressions(
    findings: Iterable[Finding],
    documents: Sequence[Document],
    policies: Policies,
    *,
    complete: bool = True,
    today: date | None = None,
) -> list[Finding]:
    """The *findings*, silenced where they are to be, and those about the suppressions.

    *findings* are judged already (`Policies.apply_severities`). *complete* tells that everything
    was read and checked; otherwise no suppression is called unused. *today* decides what
    expired; by default it is the day of the run.
    """
    settings = policies.settings
    if settings.ignore_suppressions:
        return list(findings)
    stated = find_directives(documents, policies.catalogue, today)
    about = {s: o for each in documents for s, o in each.about.items()} if stated else {}
    marked, used = _silence(findings, stated, about)
    wrong = [
        fault
        for fault in faults(stated, used, policies)
        if fault.rule != UNUSED or (complete and not settings.partial)
    ]
    ignores = ConfigIgnores(policies)
    found = [
        *ignores.mark_silenced(marked),
        *ignores.mark_silenced(_own(wrong, stated, used, policies, about)),
    ]
    if complete and not settings.partial:
        rules = {rule.name: rule for rule in policies.rules}
        found += ignores.unused((document.source.name for document in documents), rules)
    return found


def _own(
    wrong: Iterable[SuppressionFault],
    stated: Sequence[Directive],
    used: frozenset[Directive],
    policies: Policies,
    about: Mapping[Term, Term],
) -> list[Finding]:
    """Findings about suppressions, which other suppressions may silence, but never their own.

    A suppression of these rules is unused only if it silences none of them, so it comes last.
    """
    rules = {rule.name: rule for rule in policies.rules}
    own = frozenset(rules[name].code for name in FAULTS if name in rules)
    out: list[Finding] = []
    for fault in sorted(wrong, key=lambda one: one.rule == UNUSED and one.directive.names(own)):
        finding = fault_finding(fault, rules)
        if finding is None or (fault.rule == UNUSED and fault.directive in used):
            continue
        others = [one for one in stated if one is not fault.directive]
        marked, more = _silence(policies.apply_severities([finding]), others, about)
        used |= more
        out += marked
    return out


def _silence(
    findings: Iterable[Finding], stated: Sequence[Directive], about: Mapping[Term, Term]
) -> tuple[list[Finding], frozenset[Directive]]:
    out, used = [], set()
    on_node: dict[Term, list[Directive]] = {}
    in_file: dict[str, list[Directive]] = {}
    extents: dict[str, list[tuple[Span, Directive]]] = {}
    for one in stated:
        if one.whole_file:
            in_file.setdefault(one.document.location(one.span).source.name, []).append(one)
        else:
            on_node.setdefault(one.node, []).append(one)
            if one.extent is not None:
                extents.setdefault(one.extent.source.name, []).append((one.extent.span, one))
    within = {name: IntervalIndex.from_spans(found) for name, found in extents.items()}
    for finding in findings:
        nest = within.get(finding.location.source.name)
        candidates = [
            *on_node.get(finding.focus, ()),
            *on_node.get(about.get(finding.focus, ""), ()),
            *(() if nest is None else nest.containing(finding.location.span)),
            *in_file.get(finding.location.source.name, ()),
        ]
        meant = [one for one in candidates if one.active and finding.rule.code in one.codes]
        used.update(meant)
        out.append(replace(finding, suppressed=meant[0].justification) if meant else finding)
    return out, frozenset(used)
