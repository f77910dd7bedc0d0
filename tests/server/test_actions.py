"""What an editor can do about findings: as `kinlint --fix` does, and never to another text."""

import subprocess

import pytest
from editor import KINLINT
from lsprotocol import types
from robots import LEG, XACRO

pytestmark = [pytest.mark.slow, pytest.mark.asyncio]
FIX_ALL = "source.fixAll.kinlint"
AXIS = LEG.replace('xyz="0 1 0"', 'xyz="0 2 0"').replace('lower="2"', 'lower="0"')
"""An axis can be made as long as 1 without changing what is meant."""


def mended(editor, name, *options):
    """What `kinlint --fix` makes of the file."""
    command = [KINLINT, "--fix", "--isolated", *options, str(editor.here / name)]
    subprocess.run(command, cwd=editor.here, check=False, capture_output=True)
    return (editor.here / name).read_bytes().decode()


@pytest.mark.parametrize("end", ["\n", "\r\n"])
async def test_a_quick_fix_is_the_fix_of_the_command(editor, end):
    """Unsafe, so it is not preferred."""
    text = LEG.replace("\n", end)
    editor.write("leg.urdf", text)
    editor.open("leg.urdf")
    found = await editor.diagnostics("leg.urdf")

    fix, ignore = await editor.actions("leg.urdf", 'lower="2"', diagnostics=found)

    assert fix.title == "kinlint (LIM001): Swap the two limits"
    assert fix.kind == "quickfix"
    assert not fix.is_preferred
    assert [one.code for one in fix.diagnostics] == ["LIM001"]
    assert ignore.title == "kinlint (LIM001): Ignore LIM001 here"
    new = editor.applied(fix.edit)["leg.urdf"]
    assert new == mended(editor, "leg.urdf", "--unsafe-fixes", "--select", "LIM001")
    assert 'lower="1" upper="2"' in new


async def test_a_safe_fix_is_preferred(editor):
    """And nothing is offered where nothing was found."""
    editor.write("leg.urdf", AXIS)
    editor.open("leg.urdf")
    await editor.diagnostics("leg.urdf")

    fix, *_ = await editor.actions("leg.urdf", "0 2 0")

    assert fix.is_preferred
    assert editor.applied(fix.edit)["leg.urdf"] == mended(editor, "leg.urdf")
    assert not await editor.actions("leg.urdf", "hip", ["quickfix"])


async def test_all_safe_fixes_at_once(editor):
    """Worked out when it is chosen, if the client can wait for it, and equal to `--fix`."""
    text = AXIS.replace("</robot>", AXIS[AXIS.index("  <joint") :].replace("knee", "toe"))
    text = text.replace('<child link="shin"/>', '<child link="foot"/>', 1)
    text = text.replace("  <joint", '  <link name="foot"/>\n  <joint', 1)
    editor.write("leg.urdf", text)
    editor.open("leg.urdf")

    (action,) = await editor.actions("leg.urdf", "<robot", [FIX_ALL])
    if action.edit is None:
        action = await editor.resolved(action)

    assert action.kind == FIX_ALL
    assert editor.applied(action.edit)["leg.urdf"] == mended(editor, "leg.urdf")


async def test_only_the_kinds_that_are_asked_for(editor):
    """A kind stands for all below it."""
    editor.open("leg.urdf", AXIS)

    async def kinds(*only):
        return {one.kind for one in await editor.actions("leg.urdf", "0 2 0", list(only))}

    everything = await editor.actions("leg.urdf", "0 2 0", None)
    assert {one.kind for one in everything} >= {"quickfix"}
    assert await kinds("quickfix") == {"quickfix"}
    assert await kinds("refactor") == set()
    assert await kinds("source") == await kinds("source.fixAll") == {FIX_ALL}
    assert await kinds("source.fixAll.other") == set()


async def test_fix_all_makes_nothing_unsafe(editor):
    """Swapping limits takes a decision."""
    editor.open("leg.urdf", LEG)

    found = await editor.actions("leg.urdf", "<robot", [FIX_ALL])

    edits = [one.edit or (await editor.resolved(one)).edit for one in found]
    assert not any(edits)


async def test_ignore_here_in_xml(editor):
    """A comment, after which nothing is found."""
    editor.open("leg.urdf", LEG)

    _, ignore = await editor.actions("leg.urdf", 'lower="2"')
    new = editor.applied(ignore.edit)["leg.urdf"]
    editor.rewrite("leg.urdf", new)

    assert "kinlint: ignore" in new
    assert await editor.codes("leg.urdf") == []


JSON_LD = """{
  "@context": ["https://w3id.org/kinlint/composable.json", {"ex": "https://example.org/arm#"}],
  "@graph": [
    { "name 🦾": 1, "@id": "ex:p", "@type": ["PositionCoordinate", "VectorXYZ"],
      "of-position": "ex:q", "as-seen-by": "ex:f", "x": 1.0, "y": 2.0, "z": 3.0 }
  ]
}
"""


async def test_ignore_here_in_json_ld(editor):
    """A triple on the node."""
    editor.open("arm.jsonld", JSON_LD, "json")
    codes = await editor.codes("arm.jsonld")
    assert "UNI001" in codes
    found = await editor.diagnostics("arm.jsonld")
    mark = next(editor.marked("arm.jsonld", one) for one in found if one.code == "UNI001")

    title = "kinlint (UNI001): Ignore UNI001 here"
    actions = await editor.actions("arm.jsonld", mark)
    ignore = next(one for one in actions if one.title == title)
    new = editor.applied(ignore.edit)["arm.jsonld"]
    editor.rewrite("arm.jsonld", new)

    assert "ignore" in new
    assert "UNI001" not in await editor.codes("arm.jsonld")


async def test_a_stale_diagnostic_leads_to_no_wrong_edit(editor):
    """The client still has diagnostics of a text that is no more."""
    editor.open("leg.urdf", LEG)
    old = await editor.diagnostics("leg.urdf")

    editor.replace("leg.urdf", "<robot", "<!-- 🦿 -->\n\n<robot")
    fix, _ = await editor.actions("leg.urdf", 'lower="2"', diagnostics=old)

    assert 'lower="1" upper="2"' in editor.applied(fix.edit)["leg.urdf"]
    editor.replace("leg.urdf", 'lower="2"', 'lower="0"')
    assert not await editor.actions("leg.urdf", "<limit", ["quickfix"], diagnostics=old)


async def test_a_fix_in_an_included_file(editor):
    """The finding lies in a macro that another file uses, and that is open, too, and unsaved."""
    main, macro = XACRO
    editor.write("macro.xacro", macro)
    editor.write("robot.urdf.xacro", main)
    editor.open("robot.urdf.xacro")
    assert await editor.codes("robot.urdf.xacro") == []
    editor.open("macro.xacro")
    assert await editor.codes("macro.xacro") == []

    editor.replace("macro.xacro", 'lower="0"', 'lower="2"')
    assert await editor.codes("macro.xacro", ["LIM001"].__eq__)
    fix, *_ = await editor.actions("macro.xacro", 'lower="2"')

    assert 'lower="1" upper="2"' in editor.applied(fix.edit)["macro.xacro"]


async def test_apply_autofix(editor):
    """The command asks the client to make the edit."""
    editor.write("leg.urdf", AXIS)
    editor.open("leg.urdf")

    done = await editor.command("kinlint.applyAutofix", {"uri": editor.uri("leg.urdf")})

    assert done is True
    (edit,) = editor.client.applied
    assert editor.applied(edit)["leg.urdf"] == mended(editor, "leg.urdf")


async def test_debug_information_and_graph(editor):
    """Texts for people."""
    editor.open("leg.urdf", LEG)

    told = await editor.command("kinlint.printDebugInformation")
    drawn = await editor.command("kinlint.showGraph", editor.uri("leg.urdf"))

    assert told.startswith("kinlint 0.")
    assert editor.encoding in told
    assert "flowchart" in drawn
    assert "knee" in drawn
    picture = await editor.command("kinlint.showRobot", editor.uri("leg.urdf"))
    assert "<svg" in picture
    assert "knee" in picture


async def test_the_page_of_a_robot_has_the_theme_of_the_editor(editor):
    """Webviews of editors do not tell pages which one they have."""
    editor.open("leg.urdf", LEG)
    pages = {
        theme: await editor.command("kinlint.showRobotPage", editor.uri("leg.urdf"), theme)
        for theme in ("dark", "light", "<none>")
    }
    assert all("LIM001" in page for page in pages.values())
    for theme, query in (("dark", "@media screen {"), ("light", "@media not all {")):
        assert f'<meta name="color-scheme" content="{theme}">' in pages[theme]
        assert query in pages[theme]
        assert "prefers-color-scheme" not in pages[theme]
    assert "prefers-color-scheme" in pages["<none>"]
    assert "<none>" not in pages["<none>"]
    nothing = await editor.command("kinlint.showRobotPage", editor.uri("nothing.urdf"))
    assert nothing is None


async def test_the_page_of_a_rule_is_there_without_network(editor):
    """By its code; there is none of a code that no rule has."""
    editor.open("leg.urdf", LEG)
    uri = editor.uri("leg.urdf")
    page = await editor.command("kinlint.showRulePage", uri, "LIM001")
    assert page.startswith("# LIM001 inverted-limit")
    assert await editor.command("kinlint.showRulePage", uri, "LIM999") is None


async def test_clients_without_versions_get_plain_changes(stranger):
    """As the protocol has it."""
    edits = types.WorkspaceEditClientCapabilities(document_changes=False)
    stranger.capabilities.workspace.workspace_edit = edits
    stranger.capabilities.text_document.code_action.resolve_support = None
    editor = await stranger.begin()
    editor.open("leg.urdf", LEG)

    fix, _ = await editor.actions("leg.urdf", 'lower="2"')

    assert fix.edit.document_changes is None
    assert 'lower="1" upper="2"' in editor.applied(fix.edit)["leg.urdf"]
