"""Go to definition, find references and document highlights, across the files of a model."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from lsprotocol import types

from kinlint.navigation.navigator import Navigator
from kinlint.navigation.occurrence import Role
from kinlint.server.app import KinlintServer
from kinlint.server.navigators import ask_navigator
from kinlint.server.request_context import RequestContext
from kinlint.text import Location

HIGHLIGHTS = {
    Role.DESCRIPTION: types.DocumentHighlightKind.Write,
    Role.REFERENCE: types.DocumentHighlightKind.Read,
}


def register(server: KinlintServer) -> None:
    """Have *server* lead to descriptions and to references."""

    @server.feature(types.TEXT_DOCUMENT_DEFINITION)
    async def definition(params: types.DefinitionParams) -> Sequence[types.Location] | None:
        def places(view: RequestContext, navigator: Navigator) -> Sequence[types.Location]:
            name, offset = view.source.name, view.offset(params.position)
            return _locations(view, navigator.definitions(name, offset))

        return await ask_navigator(server, params.text_document.uri, places)

    @server.feature(types.TEXT_DOCUMENT_REFERENCES)
    async def references(params: types.ReferenceParams) -> Sequence[types.Location] | None:
        described = params.context.include_declaration

        def places(view: RequestContext, navigator: Navigator) -> Sequence[types.Location]:
            name, offset = view.source.name, view.offset(params.position)
            return _locations(view, navigator.references(name, offset, described=described))

        return await ask_navigator(server, params.text_document.uri, places)

    @server.feature(types.TEXT_DOCUMENT_DOCUMENT_HIGHLIGHT)
    async def highlights(
        params: types.DocumentHighlightParams,
    ) -> Sequence[types.DocumentHighlight] | None:
        def places(view: RequestContext, navigator: Navigator) -> Sequence[types.DocumentHighlight]:
            found = navigator.highlights(view.source.name, view.offset(params.position))
            return [
                types.DocumentHighlight(view.range(each.location.span), HIGHLIGHTS[each.role])
                for each in found
            ]

        return await ask_navigator(server, params.text_document.uri, places)


def _locations(view: RequestContext, places: Iterable[Location]) -> list[types.Location]:
    return [view.location(each) for each in places]
