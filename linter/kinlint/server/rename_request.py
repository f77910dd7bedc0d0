"""The rename requests."""

from __future__ import annotations

from pathlib import Path
from typing import NoReturn

from lsprotocol import types
from pygls.exceptions import JsonRpcException

from kinlint.files.pathname import real
from kinlint.navigation.navigator import Navigator
from kinlint.navigation.renaming.renaming_error import NotRenamable
from kinlint.server.app import KinlintServer
from kinlint.server.navigators import ask_navigator
from kinlint.server.request_context import RequestContext
from kinlint.server.workspace_edit import workspace_edit

Answer = tuple[types.PrepareRenamePlaceholder | types.WorkspaceEdit | None, str]


def register(server: KinlintServer) -> None:
    """Have *server* rename what has a name."""

    def is_ours(path: Path) -> bool:
        """Tell whether the file at *path* is in a folder of the workspace, or open."""
        roots = [real(root) for root in server.roots]
        folders = [each.path for each in server.buffers]
        return path in folders or any(real(path).is_relative_to(root) for root in roots)

    @server.feature(types.TEXT_DOCUMENT_PREPARE_RENAME)
    async def prepare(params: types.PrepareRenameParams) -> types.PrepareRenameResult | None:
        def place(view: RequestContext, navigator: Navigator) -> Answer:
            try:
                renaming, span = navigator.renamer(is_ours).prepare(
                    view.source.name, view.offset(params.position)
                )
            except NotRenamable as error:
                return None, str(error)
            return types.PrepareRenamePlaceholder(view.range(span), renaming.name), ""

        found, reason = await ask_navigator(server, params.text_document.uri, place) or (None, "")
        if reason:
            _refuse(reason)
        assert not isinstance(found, types.WorkspaceEdit)
        return found

    @server.feature(types.TEXT_DOCUMENT_RENAME, types.RenameOptions(prepare_provider=True))
    async def rename(params: types.RenameParams) -> types.WorkspaceEdit | None:
        def edit(view: RequestContext, navigator: Navigator) -> Answer:
            renamer = navigator.renamer(is_ours)
            try:
                renaming, _ = renamer.prepare(view.source.name, view.offset(params.position))
                edits = renamer.edits(
                    renaming,
                    params.new_name,
                    view.examination,
                    view.session.texts,
                    view.settings,
                )
            except NotRenamable as error:
                return None, str(error)
            return workspace_edit(edits, view.places, versioned=server.supports_versioned_edits), ""

        found, reason = await ask_navigator(server, params.text_document.uri, edit) or (None, "")
        if reason:
            _refuse(reason)
        assert not isinstance(found, types.PrepareRenamePlaceholder)
        return found


def _refuse(reason: str) -> NoReturn:
    """Have the client show *reason*."""
    raise JsonRpcException(reason, code=types.LSPErrorCodes.RequestFailed.value)
