"""Code actions: a fix for a finding, all safe fixes of a file, and silence."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial

from lsprotocol import types

from kinlint.edits import NotExpressible
from kinlint.finding import Finding
from kinlint.fixes.fix_circles import circle_warning
from kinlint.ignoring.suppression_generator import SuppressionGenerator
from kinlint.rule import Applicability
from kinlint.server.app import KinlintServer
from kinlint.server.diagnostic_conversion import diagnostic
from kinlint.server.quick_fixes import MOST, fixes_of, safe_edits
from kinlint.server.request_context import RequestContext
from kinlint.server.workspace_edit import workspace_edit

FIX_ALL = "source.fixAll.kinlint"
TITLE = "kinlint: Make all safe fixes"
QUICK_FIX = types.CodeActionKind.QuickFix.value
OPTIONS = types.CodeActionOptions([types.CodeActionKind.QuickFix, FIX_ALL], resolve_provider=True)


def register(server: KinlintServer) -> None:
    """Offer actions; what takes long to work out is worked out when one is chosen."""

    @server.feature(types.TEXT_DOCUMENT_CODE_ACTION, OPTIONS)
    async def actions(params: types.CodeActionParams) -> list[types.CodeAction] | None:
        uri, only = params.text_document.uri, params.context.only
        found: list[types.CodeAction] = []
        if _asked(QUICK_FIX, only):
            found += await server.consult(uri, partial(_quick_fixes, server, params)) or ()
        if _asked(FIX_ALL, only):
            action = types.CodeAction(TITLE, FIX_ALL, data={"uri": uri})
            if server.supports_resolve:
                found.append(action)
            elif only:
                found += [done] if (done := await fix_all(server, action)).edit else []
        return found

    @server.feature(types.CODE_ACTION_RESOLVE)
    async def resolve(action: types.CodeAction) -> types.CodeAction:
        if action.kind == FIX_ALL and action.edit is None:
            return await fix_all(server, action)
        return action


async def fix_all(server: KinlintServer, action: types.CodeAction) -> types.CodeAction:
    """Return *action* with the edit that makes all safe fixes of its file, if there are any."""
    uri = action.data["uri"] if isinstance(action.data, dict) else ""

    found = await server.consult(uri, partial(_safe_edit, server))
    action.edit, restless = found or (None, ())
    if restless:
        server.warn(circle_warning(restless))
    return action


def _safe_edit(
    server: KinlintServer, view: RequestContext
) -> tuple[types.WorkspaceEdit | None, Sequence[str]]:
    edits, restless = safe_edits(view)
    if not edits:
        return None, restless
    versioned = server.supports_versioned_edits
    return workspace_edit(edits, view.places, versioned=versioned), restless


def _asked(kind: str, only: Sequence[types.CodeActionKind | str] | None) -> bool:
    """Tell whether the client asked for actions of *kind*, or of a kind that contains it."""
    names = [each.value if isinstance(each, types.CodeActionKind) else each for each in only or ()]
    return not names or any(kind == name or kind.startswith(f"{name}.") for name in names)


def _quick_fixes(
    server: KinlintServer, params: types.CodeActionParams, view: RequestContext
) -> list[types.CodeAction]:
    """The actions for what was found in the range that *params* asks about."""
    start, end = view.span(params.range)
    findings = [
        each
        for each in view.findings
        if each.location.span.start <= end and start <= each.location.span.end
    ]
    return [*_fixes(server, view, findings), *_ignores(server, view, findings)]


def _fixes(
    server: KinlintServer, view: RequestContext, findings: Sequence[Finding]
) -> Iterator[types.CodeAction]:
    for finding, fixes in fixes_of(view, findings):
        preferred = next((one for one in fixes if one.applicability is Applicability.SAFE), None)
        for fix in fixes:
            safe = fix.applicability is Applicability.SAFE
            if not safe and not server.preferences.unsafe_fixes:
                continue
            yield types.CodeAction(
                title=f"kinlint ({finding.rule.code}): {fix.title}",
                kind=types.CodeActionKind.QuickFix,
                diagnostics=[diagnostic(finding, view.places, related=False)],
                is_preferred=fix is preferred,
                edit=workspace_edit(
                    fix.edits, view.places, versioned=server.supports_versioned_edits
                ),
            )


def _ignores(
    server: KinlintServer, view: RequestContext, findings: Sequence[Finding]
) -> Iterator[types.CodeAction]:
    """Yield an action for each of *findings* that suppresses it in place."""
    generator = SuppressionGenerator(
        view.examination, view.session.texts, view.settings, view.rulebook
    )
    for finding in findings[:MOST]:
        try:
            edits = generator.suppression([finding]).text_edits
        except NotExpressible:
            continue
        yield types.CodeAction(
            title=f"kinlint ({finding.rule.code}): Ignore {finding.rule.code} here",
            kind=types.CodeActionKind.QuickFix,
            diagnostics=[diagnostic(finding, view.places, related=False)],
            is_preferred=False,
            edit=workspace_edit(edits, view.places, versioned=server.supports_versioned_edits),
        )
