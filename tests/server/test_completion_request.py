"""Completion over the protocol, in texts that cannot be parsed at the moment."""

import json

import pytest
from lsprotocol import types
from robots import GOOD

pytestmark = [pytest.mark.slow, pytest.mark.asyncio]

WIDE = "🤖𝔄é"
SRDF = (
    f'<robot name="leg">\n <group name="all"><!-- {WIDE} --><link name="shin"/></group>\n</robot>\n'
)
XACRO = f"""<robot name="leg" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="size" value="1"/><!-- {WIDE} -->
  <link name="${{'shin'}}"/><link name="foot"/>
  <joint name="j" type="fixed"><parent link="shin"/><child link="foot"/></joint>
</robot>
"""
SDF = f"""<sdf version="1.9"><model name="leg"><!-- {WIDE} -->
  <link name="hip"/><link name="shin"/>
  <joint name="j" type="fixed"><parent>hip</parent><child>shin</child></joint>
</model></sdf>
"""
NODES = [
    {"@id": "ex:a", "@type": "Frame", "origin": "ex:o"},
    {"@id": "ex:o", "@type": "Point", "name": WIDE},
]
CONTEXT = ["https://w3id.org/kinlint/composable.json", {"ex": "https://example.org/arm#"}]
JSON = json.dumps({"@context": CONTEXT, "@graph": NODES}, ensure_ascii=False)
TURTLE = f"""@prefix ex: <https://example.org/arm#> . # {WIDE}
@prefix geom: <https://comp-rob2b.github.io/metamodels/geometry/structural-entities#> .
ex:a a geom:Frame ; geom:origin ex:o .
ex:o a geom:Point .
"""
CASES = {
    "leg.urdf": (GOOD, '<child link="shin"/>', '<child link="', "shin", '<child link="shin'),
    "leg.srdf": (SRDF, '<link name="shin"/>', '<link name="', "shin", '<link name="shin'),
    "leg.xacro": (XACRO, '<child link="foot"/>', '<child link="', "shin", '<child link="shin'),
    "leg.sdf": (SDF, "<child>shin</child>", "<child>sh", "shin", "<child>shin"),
    "leg.jsonld": (JSON, '"origin": "ex:o"', '"origin": "', "ex:o", '"origin": "ex:o"'),
    "leg.ttl": (TURTLE, "geom:origin ex:o", "geom:origin e", "ex:o", "geom:origin ex:o"),
}


async def completed(editor, name, old, new):
    """The items after *new* was typed over *old*, at its end."""
    at = editor.texts[name].index(old) + len(new)
    editor.replace(name, old, new)
    place = editor.position(editor.texts[name], at)
    params = types.CompletionParams(types.TextDocumentIdentifier(editor.uri(name)), place)
    found = await editor.client.text_document_completion_async(params)
    return list(found.items)


def accepted(editor, name, item):
    """The text with *item* in it."""
    text, edit = editor.texts[name], item.text_edit
    start, end = (editor.offset(text, each) for each in (edit.range.start, edit.range.end))
    return text[:start] + edit.new_text + text[end:]


@pytest.mark.parametrize("name", CASES)
async def test_names_in_a_text_that_is_broken_meanwhile(editor, name):
    text, old, typed, label, wanted = CASES[name]
    if name == "leg.srdf":
        editor.write("leg.urdf", GOOD)
    editor.open(name, text, "json" if name.endswith("jsonld") else "xml")
    await editor.diagnostics(name)
    items = await completed(editor, name, old, typed)
    item = next(each for each in items if each.label == label)
    assert wanted in accepted(editor, name, item)


async def test_items_come_in_order(editor):
    """What is missing comes first, whatever its name."""
    editor.open("leg.urdf", GOOD)
    items = await completed(editor, "leg.urdf", '<parent link="hip"/>', "<")
    first = min(items, key=lambda each: each.sort_text)
    assert first.label == "parent"
    known = editor.capabilities.text_document.completion
    snippets = known.completion_item and known.completion_item.snippet_support
    assert ("$1" in first.text_edit.new_text) == bool(snippets)


async def test_nothing_is_offered_in_the_middle_of_a_number(editor):
    editor.open("leg.urdf", GOOD)
    assert await completed(editor, "leg.urdf", 'effort="1"', 'effort="1') == []
