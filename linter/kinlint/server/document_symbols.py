"""The outline of a file: the kinematic trees in it, as symbols."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from lsprotocol import types

from kinlint.navigation.navigator import Navigator
from kinlint.navigation.outline import Sort, Symbol
from kinlint.server.app import KinlintServer
from kinlint.server.navigators import ask_navigator
from kinlint.server.request_context import RequestContext

KINDS = {
    Sort.ROBOT: types.SymbolKind.Module,
    Sort.LINK: types.SymbolKind.Struct,
    Sort.JOINT: types.SymbolKind.Event,
    Sort.FRAME: types.SymbolKind.Variable,
    Sort.MACRO: types.SymbolKind.Function,
    Sort.PROPERTY: types.SymbolKind.Constant,
    Sort.OTHER: types.SymbolKind.Object,
}


def register(server: KinlintServer) -> None:
    """Have *server* tell of symbols."""

    @server.feature(types.TEXT_DOCUMENT_DOCUMENT_SYMBOL)
    async def symbols(
        params: types.DocumentSymbolParams,
    ) -> Sequence[types.DocumentSymbol] | Sequence[types.SymbolInformation] | None:
        uri = params.text_document.uri
        known = server.client_capabilities.text_document
        nested = known.document_symbol if known else None
        if nested and nested.hierarchical_document_symbol_support:
            return await ask_navigator(server, uri, _tree)
        return await ask_navigator(server, uri, _list)


def _tree(view: RequestContext, navigator: Navigator) -> Sequence[types.DocumentSymbol]:
    return [_symbol(view, each) for each in navigator.outline(view.source.name)]


def _list(view: RequestContext, navigator: Navigator) -> Sequence[types.SymbolInformation]:
    """The same in a row, for clients that show no trees."""
    return list(_flat(view, navigator.outline(view.source.name), None))


def _flat(
    view: RequestContext, symbols: Sequence[Symbol], holder: str | None
) -> Iterator[types.SymbolInformation]:
    for each in symbols:
        place = types.Location(view.uri, view.range(each.whole))
        yield types.SymbolInformation(place, each.name, KINDS[each.sort], container_name=holder)
        yield from _flat(view, each.below, each.name)


def _symbol(view: RequestContext, symbol: Symbol) -> types.DocumentSymbol:
    return types.DocumentSymbol(
        name=symbol.name,
        detail=symbol.detail,
        kind=KINDS[symbol.sort],
        range=view.range(symbol.whole),
        selection_range=view.range(symbol.identifier),
        children=[_symbol(view, each) for each in symbol.below],
    )
