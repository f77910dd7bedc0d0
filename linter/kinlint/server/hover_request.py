"""The hover request."""

from __future__ import annotations

from lsprotocol import types

from kinlint.navigation.navigator import Navigator
from kinlint.server.app import KinlintServer
from kinlint.server.navigators import ask_navigator
from kinlint.server.request_context import RequestContext


def register(server: KinlintServer) -> None:
    """Have *server* answer hovers."""

    def kind() -> types.MarkupKind:
        """Markdown, unless the client says that it shows other things only."""
        known = server.client_capabilities.text_document
        shown = known.hover.content_format if known and known.hover else None
        plain = shown and types.MarkupKind.Markdown not in shown
        return types.MarkupKind.PlainText if plain else types.MarkupKind.Markdown

    @server.feature(types.TEXT_DOCUMENT_HOVER)
    async def hover(params: types.HoverParams) -> types.Hover | None:
        def shown(view: RequestContext, navigator: Navigator) -> types.Hover | None:
            found = navigator.hover(view.source.name, view.offset(params.position))
            if found is None:
                return None
            page = types.MarkupContent(kind(), found.markdown)
            return types.Hover(page, view.range(found.span))

        return await ask_navigator(server, params.text_document.uri, shown)
