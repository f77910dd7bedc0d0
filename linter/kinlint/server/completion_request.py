"""The completion request."""

from __future__ import annotations

from lsprotocol import types

from kinlint.formats.recognition import with_format
from kinlint.navigation.completion.candidate import Candidate, Completions, Kind
from kinlint.navigation.completion.dispatch import TRIGGERS, complete
from kinlint.navigation.completion.situation import Situation
from kinlint.server.app import KinlintServer
from kinlint.server.request_context import RequestContext

MOST = 500
"""Most candidates of an answer; an editor asks again when more is typed."""
OPTIONS = types.CompletionOptions(trigger_characters=list(TRIGGERS))
KINDS = {
    Kind.NAME: types.CompletionItemKind.Reference,
    Kind.ELEMENT: types.CompletionItemKind.Struct,
    Kind.ATTRIBUTE: types.CompletionItemKind.Property,
    Kind.WORD: types.CompletionItemKind.EnumMember,
    Kind.CLASS: types.CompletionItemKind.Class,
    Kind.UNIT: types.CompletionItemKind.Unit,
    Kind.VARIABLE: types.CompletionItemKind.Variable,
    Kind.FUNCTION: types.CompletionItemKind.Function,
    Kind.FILE: types.CompletionItemKind.File,
    Kind.FOLDER: types.CompletionItemKind.Folder,
    Kind.RULE: types.CompletionItemKind.Constant,
}
AGAIN = types.Command("Suggest", "editor.action.triggerSuggest")
"""Command of VS Code that asks for what comes next; other editors do not have it."""


def register(server: KinlintServer) -> None:
    """Have *server* complete what is typed."""

    def has_snippets() -> bool:
        known = server.client_capabilities.text_document
        item = known.completion.completion_item if known and known.completion else None
        return bool(item and item.snippet_support)

    @server.feature(types.TEXT_DOCUMENT_COMPLETION, OPTIONS)
    async def completion(params: types.CompletionParams) -> types.CompletionList | None:
        def items(view: RequestContext) -> types.CompletionList | None:
            situation = _situation(view, params.position)
            if situation is None:
                return None
            return _answer(view, complete(situation), snippets=has_snippets())

        return await server.consult(params.text_document.uri, items)


def _situation(view: RequestContext, position: types.Position) -> Situation | None:
    source = with_format(view.source)
    if source.format is None:
        return None
    return Situation(
        source,
        view.offset(position),
        source.format,
        view.readable,
        view.examination.options,
        view.rulebook,
        view.findings,
    )


def _answer(view: RequestContext, found: Completions, *, snippets: bool) -> types.CompletionList:
    place = view.range(found.span)
    typed = view.source.text[found.span.start : found.span.end]
    listed = found.candidates
    if len(listed) > MOST:
        listed = [each for each in listed if _fits(each, typed)]
    items = [_item(each, place, n, snippets) for n, each in enumerate(listed[:MOST])]
    return types.CompletionList(is_incomplete=len(listed) > MOST, items=items)


def _fits(candidate: Candidate, typed: str) -> bool:
    """Tell whether the letters of *typed* are in *candidate* in their order."""
    letters = iter((candidate.text or candidate.label).casefold())
    return all(letter in letters for letter in typed.casefold() if letter.isalnum())


def _item(
    candidate: Candidate,
    place: types.Range,
    order: int,
    snippets: bool,  # noqa: FBT001
) -> types.CompletionItem:
    plain = candidate.label if candidate.text is None else candidate.text
    snippet = candidate.snippet if snippets else None
    return types.CompletionItem(
        label=candidate.label,
        kind=KINDS[candidate.kind],
        detail=candidate.detail or None,
        documentation=candidate.documentation or None,
        sort_text=f"{order:04d}",
        filter_text=plain if plain != candidate.label else None,
        insert_text_format=types.InsertTextFormat.Snippet
        if snippet
        else types.InsertTextFormat.PlainText,
        text_edit=types.TextEdit(place, snippet or plain),
        command=AGAIN if candidate.again else None,
    )
