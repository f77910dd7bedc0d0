"""The inlay hint request."""

from __future__ import annotations

from collections.abc import Sequence

from lsprotocol import types

from kinlint.navigation.navigator import Navigator
from kinlint.server.app import KinlintServer
from kinlint.server.navigators import ask_navigator
from kinlint.server.request_context import RequestContext


def register(server: KinlintServer) -> None:
    """Have *server* show values beside what is written."""

    @server.feature(types.TEXT_DOCUMENT_INLAY_HINT)
    async def hints(params: types.InlayHintParams) -> Sequence[types.InlayHint] | None:
        def shown(view: RequestContext, navigator: Navigator) -> Sequence[types.InlayHint]:
            found = navigator.inlay_hints(view.source.name, view.span(params.range))
            codec = view.places.codec(view.source)
            return [
                types.InlayHint(codec.position(each.offset), each.text, padding_left=True)
                for each in found
            ]

        return await ask_navigator(server, params.text_document.uri, shown)
