"""Fixes and suppressions of findings, proven on the current texts."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from kinlint.finding import Finding, Fix, TextEdit
from kinlint.fixes.fix_generator import FixGenerator
from kinlint.fixes.offers import offer_fixes
from kinlint.fixes.rounds import fix_in_rounds
from kinlint.rule import Applicability
from kinlint.server.cancellation import CancellablePhases
from kinlint.server.request_context import RequestContext
from kinlint.server.workspace_edit import difference

MOST = 100
"""Number of findings for which fixes are computed at once; each fix is tried."""


def fixes_of(
    view: RequestContext, findings: Iterable[Finding]
) -> list[tuple[Finding, tuple[Fix, ...]]]:
    """The fixes that are offered for *findings* of *view*, as `kinlint` offers them."""
    asked = [each for each in findings if each.rule.repairs][:MOST]
    known = view.session.fixes
    missing = {each.key for each in asked} - known.keys()
    if missing:
        phases = CancellablePhases(view.cancelled)

        def wanted(found: Sequence[Finding]) -> Sequence[Finding]:
            return [each for each in found if each.key in missing]

        examination, analyzer = view.session.repairing(phases)
        made = offer_fixes(
            FixGenerator(examination, view.session.texts, view.settings, view.rulebook),
            analyzer,
            least=Applicability.UNSAFE,
            wanted=wanted,
            phases=phases,
        )
        known.update(dict.fromkeys(missing, ()))
        known.update({each.key: each.fixes for each in wanted(made.report.findings)})
    return [(each, known[each.key]) for each in asked if known[each.key]]


def safe_edits(view: RequestContext) -> tuple[list[TextEdit], Sequence[str]]:
    """The edits that make all safe fixes of what was found in the file of *view*.

    With the codes of the rules whose fixes undo or feed each other, and are left out.
    """

    def wanted(found: Sequence[Finding]) -> Sequence[Finding]:
        return [each for each in found if each.location.source.name == view.source.name]

    texts, model = view.session.texts, view.session.model
    outcome = fix_in_rounds(
        texts.given,
        model.errors,
        view.settings,
        view.rulebook,
        Applicability.SAFE,
        CancellablePhases(view.cancelled),
        wanted=wanted,
        overlay=texts.changed,
    )
    edits = [edit for before, after in outcome.changed for edit in difference(before, after.text)]
    return edits, outcome.restless
