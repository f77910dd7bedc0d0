"""Symbols of the whole workspace: links, joints, frames, nodes and macros by their names."""

from __future__ import annotations

from collections.abc import Sequence

from lsprotocol import types

from kinlint.navigation.workspace_names import WorkspaceName, workspace_names
from kinlint.server.app import KinlintServer
from kinlint.server.document_symbols import KINDS
from kinlint.text import SourceText

MOST = 500
"""Most symbols of an answer; a longer query finds fewer."""


def register(server: KinlintServer) -> None:
    """Have *server* find symbols by name."""
    known: dict[str, tuple[SourceText, Sequence[WorkspaceName]]] = {}

    @server.feature(types.WORKSPACE_SYMBOL)
    async def symbols(params: types.WorkspaceSymbolParams) -> list[types.WorkspaceSymbol] | None:
        library = server.scheduler.library

        def found() -> list[types.WorkspaceSymbol]:
            listed: list[types.WorkspaceSymbol] = []
            texts = library.texts()
            for name in known.keys() - texts.keys():
                del known[name]
            for name, (source, places) in sorted(texts.items()):
                if name not in known or known[name][0] is not source:
                    known[name] = source, tuple(workspace_names(source))
                listed += [
                    types.WorkspaceSymbol(
                        places.location(each.location),
                        each.name,
                        KINDS[each.sort],
                        container_name=each.holder or None,
                    )
                    for each in known[name][1]
                    if each.fits(params.query)
                ]
            exact = params.query.casefold()
            listed.sort(key=lambda each: exact not in each.name.casefold())
            return listed[:MOST]

        await server.scheduler.wait_until_settled(next((b.path for b in server.buffers), None))
        return await server.worker.run(found)
