"""Renaming over the protocol."""

import pytest
from lsprotocol import types
from pygls.exceptions import JsonRpcException
from robots import GOOD
from test_navigation import CONTEXT, HAND, PARTS, SRDF, asked, graph

pytestmark = [pytest.mark.slow, pytest.mark.asyncio]

SDF = """<sdf version="1.9"><model name="leg"><link name="hip"/><link name="shin"/>
  <joint name="j" type="fixed"><parent>hip</parent><child>shin</child></joint></model></sdf>
"""


async def renamed(editor, name, mark, at, new):
    """The texts after what is *at* characters into *mark* was called *new*."""
    where = asked(editor, name, mark, at)
    prepared = await editor.client.text_document_prepare_rename_async(
        types.PrepareRenameParams(**where)
    )
    assert editor.at(editor.texts[name], prepared.range) == prepared.placeholder
    edit = await editor.client.text_document_rename_async(types.RenameParams(**where, new_name=new))
    return editor.applied(edit)


async def test_a_link_in_an_unsaved_urdf_and_its_srdf(editor):
    editor.write("leg.srdf", SRDF)
    editor.open("leg.urdf", GOOD)
    found = await renamed(editor, "leg.urdf", 'link name="shin"', 12, "calf")
    assert found == {
        "leg.urdf": GOOD.replace('"shin"', '"calf"'),
        "leg.srdf": SRDF.replace('"shin"', '"calf"'),
    }


async def test_a_macro_in_a_file_that_is_included(editor):
    editor.write("parts.xacro", PARTS)
    editor.open("hand.urdf.xacro", HAND)
    found = await renamed(editor, "hand.urdf.xacro", "xacro:tip", 7, "finger")
    assert found == {
        "parts.xacro": PARTS.replace('"tip"', '"finger"'),
        "hand.urdf.xacro": HAND.replace("xacro:tip", "xacro:finger"),
    }


async def test_a_link_in_sdf(editor):
    editor.open("leg.sdf", SDF)
    found = await renamed(editor, "leg.sdf", "<child>shin", 9, "calf")
    assert found == {"leg.sdf": SDF.replace("shin", "calf")}


async def test_a_node_in_two_files_of_json_ld(editor):
    assert CONTEXT
    frame = graph({"@id": "ex:base", "@type": "Frame", "origin": "ex:o"})
    point = graph({"@id": "ex:o", "@type": "Point"})
    editor.open("frame.jsonld", frame, "json")
    editor.open("point.jsonld", point, "json")
    found = await renamed(editor, "point.jsonld", '"ex:o"', 4, "origin-of-base")
    assert found == {
        "frame.jsonld": frame.replace('"ex:o"', '"ex:origin-of-base"'),
        "point.jsonld": point.replace('"ex:o"', '"ex:origin-of-base"'),
    }


async def test_a_reason_is_given_where_nothing_is_renamed(editor):
    editor.open("parts.xacro", PARTS)
    editor.open("leg.urdf", GOOD)
    where = asked(editor, "leg.urdf", 'link name="shin"', 12)
    with pytest.raises(JsonRpcException, match="link 'hip' exists already"):
        await editor.client.text_document_rename_async(types.RenameParams(**where, new_name="hip"))
    where = asked(editor, "leg.urdf", "effort", 2)
    with pytest.raises(JsonRpcException, match="nothing that can be renamed"):
        await editor.client.text_document_prepare_rename_async(types.PrepareRenameParams(**where))


async def test_a_file_outside_of_the_workspace(stranger):
    """It is read, as it is in the same working copy, but not changed."""
    (stranger.here / ".git").mkdir()
    inside = stranger.here / "inside"
    inside.mkdir()
    editor = await stranger.begin([inside])
    editor.write("parts.xacro", PARTS)
    text = HAND.replace("parts.xacro", "../parts.xacro")
    editor.write("inside/hand.urdf.xacro", text)
    editor.open("inside/hand.urdf.xacro")
    where = asked(editor, "inside/hand.urdf.xacro", "xacro:tip", 7)
    with pytest.raises(JsonRpcException, match="outside of the workspace"):
        await editor.client.text_document_prepare_rename_async(types.PrepareRenameParams(**where))
