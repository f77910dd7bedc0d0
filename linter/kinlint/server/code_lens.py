"""A line above each file that counts what was found in it."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from lsprotocol import types

from kinlint.reporters.summary import plural
from kinlint.rule import Applicability
from kinlint.server.app import KinlintServer
from kinlint.server.quick_fixes import fixes_of
from kinlint.server.request_context import RequestContext

MEND = "kinlint.applyAutofix"
TOP = types.Range(types.Position(0, 0), types.Position(0, 0))


def register(server: KinlintServer) -> None:
    """Have *server* count; how many can be fixed is worked out when the line is looked at."""

    @server.feature(types.TEXT_DOCUMENT_CODE_LENS, types.CodeLensOptions(resolve_provider=True))
    async def lenses(params: types.CodeLensParams) -> Sequence[types.CodeLens] | None:
        uri = params.text_document.uri
        view = await server.request_context(uri)
        found = view is not None and view.findings
        return [types.CodeLens(TOP, data={"uri": uri})] if found else []

    @server.feature(types.CODE_LENS_RESOLVE)
    async def resolve(lens: types.CodeLens) -> types.CodeLens:
        uri = lens.data["uri"] if isinstance(lens.data, dict) else ""
        lens.command = await server.consult(uri, partial(_command, uri))
        return lens


def _command(uri: str, view: RequestContext) -> types.Command:
    """Return the title of the line and its command, which makes the safe fixes if there are any."""
    title = plural(len(view.findings), "finding", "findings")
    offered = [fixes for _, fixes in fixes_of(view, view.findings)]
    safe = any(fix.applicability is Applicability.SAFE for each in offered for fix in each)
    if offered:
        title += f", {len(offered)} fixable"
    return types.Command(title, MEND if safe else "", arguments=[uri])
