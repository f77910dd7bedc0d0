"""Diagnostics for clients that ask for them, of a file or of all."""

from __future__ import annotations

import asyncio
from pathlib import Path

from lsprotocol import types

from kinlint.server.app import KinlintServer
from kinlint.server.buffers import path_of
from kinlint.server.diagnostic_conversion import FileDiagnostics


def register(server: KinlintServer) -> None:
    """Answer with what is known as soon as it is known, and tell when to ask again."""

    @server.feature(
        types.TEXT_DOCUMENT_DIAGNOSTIC,
        types.DiagnosticOptions(
            inter_file_dependencies=True, workspace_diagnostics=True, identifier="kinlint"
        ),
    )
    async def pull(params: types.DocumentDiagnosticParams) -> types.DocumentDiagnosticReport:
        path = path_of(params.text_document.uri)
        await server.wait_until_settled(path)
        told = server.diagnostics(path)
        answered[path] = told.result_id, _version(server, path)
        if told.result_id == params.previous_result_id:
            return types.RelatedUnchangedDocumentDiagnosticReport(told.result_id)
        return types.RelatedFullDocumentDiagnosticReport(told.items, result_id=told.result_id)

    @server.feature(types.WORKSPACE_DIAGNOSTIC)
    async def pull_all(params: types.WorkspaceDiagnosticParams) -> types.WorkspaceDiagnosticReport:
        before = {each.uri: each.value for each in params.previous_result_ids}
        await server.wait_until_settled(None)
        items = [
            _report(server.buffers.uri(path), server.diagnostics(path), before)
            for path in sorted(server.told)
        ]
        items += [
            types.WorkspaceFullDocumentDiagnosticReport(uri, ())
            for uri in before
            if path_of(uri) not in server.told
        ]
        return types.WorkspaceDiagnosticReport(items)

    answered: dict[Path, tuple[str, int | None]] = {}

    def refresh(paths: frozenset[Path], _settled: bool) -> None:  # noqa: FBT001
        """Have the client ask again for files that it does not know to have changed."""
        for path in paths.intersection(answered):
            result_id, version = answered[path]
            if result_id != server.diagnostics(path).result_id and version == _version(
                server, path
            ):
                answered.clear()
                asyncio.ensure_future(_refresh(server))  # noqa: RUF006  nothing depends on its end
                return

    known = server.client_capabilities.workspace
    if known and known.diagnostics and known.diagnostics.refresh_support:
        server.listeners.append(refresh)


def _version(server: KinlintServer, path: Path) -> int | None:
    buffer = server.buffers.at_path(path)
    return None if buffer is None else buffer.version


async def _refresh(server: KinlintServer) -> None:
    try:
        await server.workspace_diagnostic_refresh_async(None)
    except Exception as error:  # noqa: BLE001  the client will ask again in its own time
        server.log(f"diagnostics may be old: {error}", types.MessageType.Warning)


def _report(
    uri: str, told: FileDiagnostics, before: dict[str, str]
) -> types.WorkspaceFullDocumentDiagnosticReport | types.WorkspaceUnchangedDocumentDiagnosticReport:
    if before.get(uri) == told.result_id:
        return types.WorkspaceUnchangedDocumentDiagnosticReport(uri, told.result_id, told.version)
    return types.WorkspaceFullDocumentDiagnosticReport(
        uri, told.items, told.version, result_id=told.result_id
    )
