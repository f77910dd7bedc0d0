"""What an editor is told of a text, and when."""

import pytest
from robots import GOOD, LEG

pytestmark = [pytest.mark.slow, pytest.mark.asyncio]


async def test_columns_count_in_the_units_of_the_client(editor, profile):
    """Each profile prefers another encoding, and what stands before takes 1, 2 or 4 units."""
    encodings = {"visual-studio-code": "utf-16", "neovim": "utf-8", "emacs": "utf-32"}
    assert editor.encoding == encodings[profile]
    editor.open("leg.urdf", LEG)

    (found,) = await editor.diagnostics("leg.urdf")

    assert editor.marked("leg.urdf", found) == "2"
    assert found.code == "LIM001"
    assert found.severity == 1
    assert found.source == "kinlint"
    assert found.code_description.href == "https://w3id.org/kinlint/rules/inverted-limit"
    assert "help" not in found.message
    for related in found.related_information or ():
        assert related.location.uri == editor.uri("leg.urdf")


async def test_each_change_is_answered(editor):
    """Typing before the finding, on its line, and beyond the end of the text."""
    editor.open("leg.urdf", LEG)
    await editor.codes("leg.urdf", ["LIM001"].__eq__)

    editor.replace("leg.urdf", "🦵é", "a 🦿🦿 b")
    (found,) = await editor.diagnostics("leg.urdf")
    assert editor.marked("leg.urdf", found) == "2"

    editor.replace("leg.urdf", 'lower="2"', 'lower="-2"')
    assert await editor.codes("leg.urdf") == []


async def test_broken_text_and_back(editor):
    """A text that cannot be read says where."""
    editor.open("leg.urdf", GOOD)
    assert await editor.codes("leg.urdf") == []

    editor.rewrite("leg.urdf", GOOD.replace("</robot>", "</robo"))
    found = await editor.diagnostics("leg.urdf")
    assert found
    assert all(one.severity == 1 for one in found)

    editor.rewrite("leg.urdf", LEG)
    assert await editor.codes("leg.urdf", ["LIM001"].__eq__)
    editor.rewrite("leg.urdf", "")
    await editor.diagnostics("leg.urdf")
    editor.rewrite("leg.urdf", GOOD)
    assert await editor.codes("leg.urdf") == []


async def test_json_ld_that_is_no_json(editor):
    """The place is that of the error, in the units of the client."""
    text = '{"@id": "🤖", "x": }'
    editor.open("arm.jsonld", text, "json")

    (found,) = await editor.diagnostics("arm.jsonld")

    assert found.code is None
    assert editor.offset(text, found.range.start) == text.index("}")


@pytest.mark.parametrize("end", ["\r\n", "\r", "\n"])
async def test_line_ends(editor, end):
    """CRLF and CR end lines; what only Python takes for a line end does not."""
    editor.open("leg.urdf", LEG.replace("\n", end).replace("é", "\u2028\x85"))
    (found,) = await editor.diagnostics("leg.urdf")
    assert editor.marked("leg.urdf", found) == "2"

    editor.replace("leg.urdf", f'<axis xyz="0 1 0"/>{end}', f"{end}<axis{end}xyz='0 1 0'/>{end}")
    (found,) = await editor.diagnostics("leg.urdf")
    assert editor.marked("leg.urdf", found) == "2"


async def test_a_byte_order_mark_in_the_buffer(editor):
    """Some clients keep it in the text."""
    text = "\ufeff" + LEG.replace("\n", " ")
    editor.open("leg.urdf", text)
    (found,) = await editor.diagnostics("leg.urdf")
    assert editor.marked("leg.urdf", found) == "2"

    editor.replace("leg.urdf", "<robot", "  <robot")
    (found,) = await editor.diagnostics("leg.urdf")
    assert editor.marked("leg.urdf", found) == "2"


async def test_what_is_no_model_has_no_diagnostics(editor):
    """Whatever else the editor sends."""
    editor.open("package.json", '{"name": "x"}', "json")
    editor.open("world.xml", "<html/>")

    assert await editor.diagnostics("package.json") == () if editor.pulls else True
    editor.open("leg.urdf", LEG)
    assert await editor.codes("leg.urdf") == ["LIM001"]


async def test_a_text_without_a_file(editor):
    """An untitled buffer is told by what it says."""
    editor.uri = lambda name: f"untitled:{name}"
    editor.open("Untitled-1", LEG)

    assert await editor.codes("Untitled-1") == ["LIM001"]
