"""Hover, definition, references, symbols, links and the count above a file."""

import json

import pytest
from lsprotocol import types
from robots import GOOD, LEG

pytestmark = [pytest.mark.slow, pytest.mark.asyncio]

WIDE = "🤖𝔄é"
"""Characters of two, two and one units in UTF-16, and of four, four and two in UTF-8."""
SRDF = f"""<robot name="leg"><!-- {WIDE} -->
  <group name="all"><!-- {WIDE} --><joint name="knee"/><link name="shin"/></group>
</robot>
"""
PARTS = f"""<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><!-- {WIDE} -->
  <!-- {WIDE} --><xacro:macro name="tip" params="name"><link name="${{name}}_tip"/></xacro:macro>
</robot>
"""
HAND = f"""<robot name="hand" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <!-- {WIDE} --><xacro:include filename="parts.xacro"/><link name="palm"/>
  <!-- {WIDE} --><xacro:tip name="left"/><xacro:tip name="right"/>
</robot>
"""
CONTEXT = ["https://w3id.org/kinlint/composable.json", {"ex": "https://example.org/arm#"}]


def graph(*nodes):
    return json.dumps({"@context": CONTEXT, "@graph": nodes}, ensure_ascii=False)


def asked(editor, name, mark, at=0):
    """The place that is *at* characters into the first *mark* of the text *name*."""
    text = editor.texts[name]
    return {
        "text_document": types.TextDocumentIdentifier(editor.uri(name)),
        "position": editor.position(text, text.index(mark) + at),
    }


async def definitions(editor, name, mark, at=0):
    params = types.DefinitionParams(**asked(editor, name, mark, at))
    return shown(editor, await editor.client.text_document_definition_async(params))


async def references(editor, name, mark, at=0, *, described=False):
    context = types.ReferenceContext(include_declaration=described)
    params = types.ReferenceParams(context, **asked(editor, name, mark, at))
    return shown(editor, await editor.client.text_document_references_async(params))


async def hover(editor, name, mark, at=0):
    params = types.HoverParams(**asked(editor, name, mark, at))
    return await editor.client.text_document_hover_async(params)


def shown(editor, locations):
    """Each place as the name of its file and what is written there."""
    found = []
    for each in locations or ():
        name = next(one for one in editor._names() if editor.uri(one) == each.uri)
        text = editor.texts.get(name) or (editor.here / name).read_bytes().decode()
        found.append((name, editor.at(text, each.range)))
    return found


async def test_hover_on_a_finding_is_short(editor):
    editor.open("leg.urdf", LEG)
    found = await hover(editor, "leg.urdf", 'lower="2"', 7)
    assert found.contents.kind == types.MarkupKind.Markdown
    assert found.contents.value.startswith("**error**: ")
    assert "[LIM001](https://" in found.contents.value
    assert editor.at(LEG, found.range) == "2"


async def test_hover_on_a_name_shows_what_it_is(editor):
    """What the buffer says counts, not what it said before."""
    editor.open("leg.urdf", GOOD)
    found = await hover(editor, "leg.urdf", 'name="knee"', 7)
    assert "**joint knee**: revolute about y, -57.3 to 57.3°" in found.contents.value
    assert editor.at(GOOD, found.range) == "knee"
    editor.replace("leg.urdf", 'type="revolute"', 'type="prismatic"')
    found = await hover(editor, "leg.urdf", 'name="knee"', 7)
    assert "**joint knee**: prismatic along y, -1 to 1 m" in found.contents.value


async def test_hover_on_what_is_ignored_shows_the_rule(editor):
    text = LEG.replace("<axis", f"<!-- {WIDE} --><!-- kinlint: ignore[LIM001] later --><axis")
    editor.open("leg.urdf", text)
    found = await hover(editor, "leg.urdf", "LIM001", 3)
    assert "# LIM001" in found.contents.value


async def test_nothing_is_shown_for_what_is_no_model(editor):
    editor.open("notes.txt", "knee")
    assert await hover(editor, "notes.txt", "knee") is None
    assert await definitions(editor, "notes.txt", "knee") == []


async def test_an_srdf_leads_into_the_unsaved_urdf(editor):
    """Both are only open, and what stands before the names is wide."""
    urdf = GOOD.replace('<link name="shin"', f'<!-- {WIDE} --><link name="shin"')
    editor.open("leg.urdf", urdf)
    editor.open("leg.srdf", SRDF)
    assert await definitions(editor, "leg.srdf", '"shin"', 2) == [("leg.urdf", "shin")]
    assert await definitions(editor, "leg.srdf", '"knee"', 2) == [("leg.urdf", "knee")]
    found = await references(editor, "leg.urdf", 'link name="shin"', 12)
    assert sorted(found) == [("leg.srdf", "shin"), ("leg.urdf", "shin")]


async def test_an_srdf_leads_into_a_urdf_that_is_not_open(editor):
    """It lies beside, with a byte order mark and lines that end with two characters."""
    urdf = GOOD.replace('<link name="shin">', f'<!-- {WIDE} --><link name="shin">')
    editor.write("leg.urdf", "\ufeff" + urdf.replace("\n", "\r\n"))
    editor.open("leg.srdf", SRDF)
    assert await definitions(editor, "leg.srdf", '"shin"', 2) == [("leg.urdf", "shin")]
    assert "**link shin**" in (await hover(editor, "leg.srdf", '"shin"', 2)).contents.value


async def test_a_renamed_link_is_followed_at_once(editor):
    editor.write("leg.urdf", GOOD)
    editor.open("leg.srdf", SRDF)
    editor.open("leg.urdf")
    assert await definitions(editor, "leg.srdf", '"shin"', 2) == [("leg.urdf", "shin")]
    editor.replace("leg.urdf", '<link name="shin"', f'<!-- {WIDE} --><link name="calf"')
    assert await definitions(editor, "leg.srdf", '"shin"', 2) == []
    editor.replace("leg.srdf", '"shin"', '"calf"')
    assert await definitions(editor, "leg.srdf", '"calf"', 2) == [("leg.urdf", "calf")]


async def test_a_xacro_leads_to_macros_in_what_it_includes(editor):
    """The included file is open and not saved."""
    editor.write("parts.xacro", "<robot/>")
    editor.open("parts.xacro", PARTS)
    editor.open("hand.urdf.xacro", HAND)
    assert await definitions(editor, "hand.urdf.xacro", "xacro:tip", 8) == [("parts.xacro", "tip")]
    found = await references(editor, "parts.xacro", '"tip"', 2)
    assert found == [("hand.urdf.xacro", "tip"), ("hand.urdf.xacro", "tip")]
    (place,) = await definitions(editor, "hand.urdf.xacro", "parts.xacro", 3)
    assert place == ("parts.xacro", "")


async def test_json_ld_leads_from_file_to_file(editor):
    tip = {"http://e.org/note": WIDE, "@id": "ex:tip", "@type": "Frame"}
    body = {"http://e.org/n": WIDE, "@id": "ex:arm", "@type": "RigidBody", "simplices": "ex:tip"}
    editor.open("frames.jsonld", graph(tip))
    editor.open("bodies.jsonld", graph(body))
    found = await definitions(editor, "bodies.jsonld", '"ex:tip"', 4)
    assert found == [("frames.jsonld", '"ex:tip"')]
    found = await references(editor, "frames.jsonld", '"ex:tip"', 4, described=True)
    assert found == [("frames.jsonld", '"ex:tip"'), ("bodies.jsonld", '"ex:tip"')]


async def test_all_names_in_a_file_light_up(editor):
    editor.open("leg.urdf", GOOD)
    params = types.DocumentHighlightParams(**asked(editor, "leg.urdf", 'parent link="hip"', 14))
    found = await editor.client.text_document_document_highlight_async(params)
    assert [editor.at(GOOD, each.range) for each in found] == ["hip", "hip"]
    kinds = types.DocumentHighlightKind
    assert [each.kind for each in found] == [kinds.Write, kinds.Read]


async def test_symbols_are_the_kinematic_tree(editor):
    editor.open("leg.urdf", GOOD)
    which = types.TextDocumentIdentifier(editor.uri("leg.urdf"))
    (robot,) = await editor.client.text_document_document_symbol_async(
        types.DocumentSymbolParams(which)
    )
    way = [robot]
    while way[-1].children:
        (below,) = way[-1].children
        way.append(below)
    assert [each.name for each in way] == ["leg", "hip", "knee", "shin"]
    assert [each.detail for each in way] == ["robot", "link", "revolute joint", "link"]
    assert [editor.at(GOOD, each.selection_range) for each in way] == ["leg", "hip", "knee", "shin"]
    assert editor.at(GOOD, way[2].range).startswith('<joint name="knee"')
    assert editor.at(GOOD, way[2].range).endswith("</joint>")


async def test_clients_without_trees_get_a_list(stranger):
    stranger.capabilities.text_document.document_symbol = None
    stranger.capabilities.text_document.hover.content_format = [types.MarkupKind.PlainText]
    editor = await stranger.begin()
    editor.open("leg.urdf", GOOD)
    which = types.TextDocumentIdentifier(editor.uri("leg.urdf"))
    found = await editor.client.text_document_document_symbol_async(
        types.DocumentSymbolParams(which)
    )
    names = [(each.name, each.container_name) for each in found]
    assert names == [("leg", None), ("hip", "leg"), ("knee", "hip"), ("shin", "knee")]
    assert (await hover(editor, "leg.urdf", '"knee"', 2)).contents.kind == "plaintext"


async def test_links_lead_to_files_and_pages(editor):
    editor.write("parts.xacro", PARTS)
    editor.open("hand.urdf.xacro", HAND)
    (link,) = await links(editor, "hand.urdf.xacro")
    assert link.target == editor.uri("parts.xacro")
    assert editor.at(HAND, link.range) == "parts.xacro"
    editor.open("frames.jsonld", graph({"@id": "ex:tip", "@type": "Frame"}))
    (link,) = await links(editor, "frames.jsonld")
    assert link.target == CONTEXT[0]


async def links(editor, name):
    which = types.TextDocumentIdentifier(editor.uri(name))
    return await editor.client.text_document_document_link_async(types.DocumentLinkParams(which))


async def test_a_line_counts_what_was_found(editor):
    editor.open("leg.urdf", LEG)
    which = types.TextDocumentIdentifier(editor.uri("leg.urdf"))
    (lens,) = await editor.client.text_document_code_lens_async(types.CodeLensParams(which))
    lens = await editor.client.code_lens_resolve_async(lens)
    count = len(await editor.diagnostics("leg.urdf"))
    noun = "finding" if count == 1 else "findings"
    assert lens.command.title == f"{count} {noun}, 1 fixable"
    assert lens.range.start == types.Position(0, 0)
    editor.rewrite("leg.urdf", '<robot name="stone"><link name="stone"/></robot>')
    assert await editor.codes("leg.urdf", [].__eq__) == []
    assert not await editor.client.text_document_code_lens_async(types.CodeLensParams(which))
