"""What can be done about findings, proven on the texts as they are."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from kinlint.fixes.offers import offers
from kinlint.fixes.rounds import mended
from kinlint.model import Applicability, Finding, Fix, TextEdit
from kinlint.server.cancellation import Interruptible
from kinlint.server.request_context import View
from kinlint.server.session import named
from kinlint.server.workspace_edit import difference

MOST = 100
"""So many findings at most are looked after at once: each fix is tried."""


def remedies(view: View, findings: Iterable[Finding]) -> list[tuple[Finding, tuple[Fix, ...]]]:
    """The fixes that are offered for *findings* of *view*, as `kinlint` offers them."""
    asked = [each for each in findings if each.rule.repairs][:MOST]
    known = view.bench.fixes
    missing = {named(each) for each in asked} - known.keys()
    if missing:
        phases = Interruptible(view.cancelled)

        def wanted(found: Sequence[Finding]) -> Sequence[Finding]:
            return [each for each in found if named(each) in missing]

        examination = view.bench.repairing(phases)
        made = offers(
            examination, view.bench.texts, view.settings, view.rulebook,
            least=Applicability.UNSAFE, wanted=wanted, phases=phases,
        )  # fmt: skip
        known.update(dict.fromkeys(missing, ()))
        known.update({named(each): each.fixes for each in wanted(made.report.findings)})
    return [(each, known[named(each)]) for each in asked if known[named(each)]]


def all_safe(view: View) -> list[TextEdit]:
    """The edits that make all safe fixes of what was found in the file of *view*."""

    def wanted(found: Sequence[Finding]) -> Sequence[Finding]:
        return [each for each in found if each.location.source.name == view.source.name]

    texts, model = view.bench.texts, view.bench.model
    outcome = mended(
        texts.given,
        model.errors,
        view.settings,
        view.rulebook,
        Applicability.SAFE,
        Interruptible(view.cancelled),
        wanted=wanted,
        overlay=texts.changed,
    )
    return [edit for before, after in outcome.changed for edit in difference(before, after.text)]
