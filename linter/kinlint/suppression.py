"""Which findings are silenced, by whom, and which suppressions are themselves at fault.

Two sources silence findings. A model says `kl:ignore` on a node: findings about that node; on the
name of the file's graph: findings in that file. A configuration says so for files, for a JSON
Pointer in a file, or for an entity's IRI (`config.Ignore`). Nothing here removes a finding:
`Finding.suppressed` tells why it is not to be shown.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from datetime import date

from kinlint import pointer
from kinlint.config import Ignore
from kinlint.directive import ABOUT, Directive, directives
from kinlint.document import Document
from kinlint.model import Finding, Rule
from kinlint.selection import Policies
from kinlint.suppression_fault import FAULTS, UNUSED, Fault, faults, reported
from kinlint.terms import Term, iri
from kinlint.text import Span


def apply(
    findings: Iterable[Finding],
    documents: Sequence[Document],
    policies: Policies,
    *,
    complete: bool = True,
    today: date | None = None,
) -> list[Finding]:
    """The *findings*, silenced where they are to be, and those about the suppressions.

    *findings* are judged already (`Policies.judged`). *complete* tells that everything was
    read and checked; otherwise no suppression is called unused. *today* decides what expired.
    """
    settings = policies.settings
    if settings.ignore_suppressions:
        return list(findings)
    stated = directives(documents, policies.catalogue, today or date.today())  # noqa: DTZ011
    about = _about(documents) if stated else {}
    marked, used = _silence(findings, stated, about)
    wrong = [
        fault
        for fault in faults(stated, used, policies)
        if fault.rule != UNUSED or (complete and not settings.partial)
    ]
    late = _own(wrong, stated, used, policies, about)
    return [*_configured(marked, policies), *_configured(late, policies)]


def _own(
    wrong: Iterable[Fault],
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
        finding = reported(fault, rules)
        if finding is None or (fault.rule == UNUSED and fault.directive in used):
            continue
        others = [one for one in stated if one is not fault.directive]
        marked, more = _silence(policies.judged([finding]), others, about)
        used |= more
        out += marked
    return out


def _silence(
    findings: Iterable[Finding], stated: Sequence[Directive], about: Mapping[Term, Term]
) -> tuple[list[Finding], frozenset[Directive]]:
    out, used = [], set()
    on_node: dict[Term, list[Directive]] = {}
    in_file: dict[str, list[Directive]] = {}
    for one in stated:
        if one.whole_file:
            in_file.setdefault(one.document.source.name, []).append(one)
        else:
            on_node.setdefault(one.node, []).append(one)
    for finding in findings:
        candidates = [
            *on_node.get(finding.focus, ()),
            *on_node.get(about.get(finding.focus, ""), ()),
            *in_file.get(finding.location.source.name, ()),
        ]
        meant = [one for one in candidates if one.active and finding.rule.code in one.codes]
        used.update(meant)
        out.append(replace(finding, suppressed=meant[0].excuse) if meant else finding)
    return out, frozenset(used)


def _about(documents: Iterable[Document]) -> dict[Term, Term]:
    """The domain node that each statement of the source layer speaks of."""
    return {s: o for document in documents for s, p, o in document.statements if p == ABOUT}


@dataclass(frozen=True)
class _Pointers:
    """What JSON Pointers lead to, keys included, each looked up once."""

    known: dict[tuple[str, str], Span | None]

    def covers(self, path: str, finding: Finding) -> bool:
        source, span = finding.location.source, finding.location.span
        key = (source.name, path)
        if key not in self.known:
            place = pointer.locate(source.text, path)
            self.known[key] = place and place.member
        whole = self.known[key]
        return whole is not None and whole.start <= span.start and span.end <= whole.end


def _configured(findings: Iterable[Finding], policies: Policies) -> list[Finding]:
    """*findings* with those marked that the configuration silences."""
    pointers = _Pointers({})
    out = []
    for finding in findings:
        name = finding.location.source.name
        for ignore in policies.settings.of(name).ignores:
            if finding.suppressed is None and _matches(ignore, finding, policies, pointers):
                excuse = f"ignored by {ignore.origin}: {ignore.key}"
                finding = replace(finding, suppressed=excuse)  # noqa: PLW2901
        out.append(finding)
    return out


def _matches(ignore: Ignore, finding: Finding, policies: Policies, pointers: _Pointers) -> bool:
    if not any(_names(selector, finding.rule, policies) for selector in ignore.selectors):
        return False
    if ignore.iri is not None:
        return iri(ignore.iri) == finding.focus or ignore.iri == finding.iri
    return ignore.pointer is None or pointers.covers(ignore.pointer, finding)


def _names(selector: str, rule: Rule, policies: Policies) -> bool:
    return rule.code in policies.catalogue.find(selector)[1]
