"""Folding, selection, workspace symbols and inlay hints over the protocol."""

import pytest
from lsprotocol import types
from robots import GOOD
from test_navigation import WIDE, asked, graph

pytestmark = [pytest.mark.slow, pytest.mark.asyncio]


async def test_folding_and_selection_of_a_text_that_is_broken(editor):
    editor.open("leg.urdf", GOOD)
    editor.replace("leg.urdf", '<child link="shin"/>', f'<!-- {WIDE} --><child link="')
    which = types.TextDocumentIdentifier(editor.uri("leg.urdf"))
    found = await editor.client.text_document_folding_range_async(types.FoldingRangeParams(which))
    folded = [(each.start_line, each.end_line) for each in found]
    assert (3, 7) in folded
    place = asked(editor, "leg.urdf", WIDE, 2)["position"]
    params = types.SelectionRangeParams(which, [place])
    (at,) = await editor.client.text_document_selection_range_async(params)
    texts = []
    while at is not None:
        texts.append(editor.at(editor.texts["leg.urdf"], at.range))
        at = at.parent
    assert f"<!-- {WIDE} -->" in texts
    assert texts[-1] == editor.texts["leg.urdf"]


async def test_symbols_of_all_files(editor):
    """Files that are not open count as well."""
    editor.write("arm.jsonld", graph({"@id": "ex:knee-frame", "@type": "Frame"}))
    editor.write(
        "model.sdf", '<sdf version="1.9"><model name="m"><link name="knee"/></model></sdf>'
    )
    editor.open("leg.urdf", f"<!-- {WIDE} -->" + GOOD.partition("?>")[2])
    params = types.WorkspaceSymbolParams("kne")
    found = await editor.client.workspace_symbol_async(params)
    shown = {(each.location.uri.rpartition("/")[2], each.name) for each in found}
    assert shown == {("leg.urdf", "knee"), ("model.sdf", "knee"), ("arm.jsonld", "ex:knee-frame")}
    urdf = next(each for each in found if each.location.uri.endswith("urdf"))
    assert editor.at(editor.texts["leg.urdf"], urdf.location.range) == "knee"


async def test_degrees_beside_radians(editor):
    editor.open("leg.urdf", GOOD)
    everything = types.Range(types.Position(0, 0), types.Position(99, 0))
    which = types.TextDocumentIdentifier(editor.uri("leg.urdf"))
    found = await editor.client.text_document_inlay_hint_async(
        types.InlayHintParams(which, everything)
    )
    assert [each.label for each in found] == ["-57.3°", "57.3°"]
    before = GOOD[: editor.offset(GOOD, found[0].position)]
    assert before.endswith('lower="-1')
