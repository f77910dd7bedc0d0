"""Links from a file to those that it includes, and to contexts, meshes and textures."""

from __future__ import annotations

from collections.abc import Sequence

from lsprotocol import types

from kinlint.navigation.file_links import Link
from kinlint.navigation.navigator import Navigator
from kinlint.server.app import KinlintServer
from kinlint.server.buffers import uri_of
from kinlint.server.navigators import ask_navigator
from kinlint.server.request_context import RequestContext


def register(server: KinlintServer) -> None:
    """Have *server* tell of links."""

    @server.feature(types.TEXT_DOCUMENT_DOCUMENT_LINK)
    async def links(params: types.DocumentLinkParams) -> Sequence[types.DocumentLink] | None:
        def found(view: RequestContext, navigator: Navigator) -> Sequence[types.DocumentLink]:
            return [
                types.DocumentLink(view.range(each.location.span), target=_target(view, each))
                for each in navigator.links(view.source.name)
            ]

        return await ask_navigator(server, params.text_document.uri, found)


def _target(view: RequestContext, link: Link) -> str:
    if link.source is not None:
        return view.places.uri(link.source.name)
    return link.target if isinstance(link.target, str) else uri_of(link.target)
