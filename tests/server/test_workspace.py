"""Diagnostics across the files of a robot, open or not, and what settings have to say of them."""

import asyncio
import os
from asyncio.subprocess import PIPE

import pytest
from editor import KINLINT, PATIENCE, Editor, started
from lsprotocol import types
from robots import GOOD, LEG, XACRO

pytestmark = [pytest.mark.slow, pytest.mark.asyncio]
SRDF = """<?xml version="1.0"?>
<robot name="leg"><group name="all"><chain base_link="hip" tip_link="shin"/></group></robot>
"""


async def pulled(editor, *known):
    """The reports of all files of the workspace, by their URIs."""
    before = [types.PreviousResultId(uri, value) for uri, value in known]
    params = types.WorkspaceDiagnosticParams(before)
    report = await editor.client.workspace_diagnostic_async(params)
    return {one.uri: one for one in report.items}


async def test_a_change_reaches_the_other_files_of_the_robot(editor):
    """The SRDF speaks of a link that the buffer of the URDF no longer has."""
    editor.write("leg.urdf", GOOD)
    editor.write("leg.srdf", SRDF)
    editor.open("leg.urdf")
    editor.open("leg.srdf")
    assert await editor.codes("leg.srdf") == []

    editor.replace("leg.urdf", '<link name="shin">', '<link name="tibia">')
    editor.replace("leg.urdf", '<child link="shin"/>', '<child link="tibia"/>')

    assert await editor.codes("leg.srdf", bool) == ["CMP001"]
    if editor.pulls and editor.capabilities.workspace.diagnostics:
        assert editor.client.diagnostic_refresh_count
    editor.replace("leg.urdf", '<link name="tibia">', '<link name="shin">')
    editor.replace("leg.urdf", '<child link="tibia"/>', '<child link="shin"/>')
    assert await editor.codes("leg.srdf", lambda codes: not codes) == []


async def test_limits_in_yaml_beside_the_only_robot(editor):
    """They are held against the robot as it is in its buffer, though nothing names both files."""
    limits = "joint_limits:\n  knee: {has_velocity_limits: true, max_velocity: 3.0}\n"
    editor.write("leg.urdf", GOOD)
    editor.write("limits.yaml", limits)
    editor.open("leg.urdf")
    editor.open("limits.yaml")
    assert await editor.codes("limits.yaml", bool) == ["CMP009"]

    editor.replace("leg.urdf", 'velocity="1"', 'velocity="5"')
    assert await editor.codes("limits.yaml", lambda codes: not codes) == []


async def test_the_buffer_counts_and_then_the_disk(editor):
    """What is included is read from where it was changed last."""
    main, macro = XACRO
    editor.write("robot.urdf.xacro", main)
    editor.write("macro.xacro", macro)
    editor.open("robot.urdf.xacro")
    assert await editor.codes("robot.urdf.xacro") == []
    editor.open("macro.xacro", macro.replace('lower="0"', 'lower="2"'))
    assert await editor.codes("macro.xacro", bool) == ["LIM001"]

    editor.close("macro.xacro")
    if not editor.pulls:
        assert await editor.codes("macro.xacro", lambda codes: not codes) == []
    editor.write("macro.xacro", macro.replace('lower="0"', 'lower="3"'))
    editor.touched("macro.xacro")
    assert await editor.codes("macro.xacro", bool) == ["LIM001"]


async def test_a_companion_outside_the_workspace(stranger):
    """A single file without a workspace: the URDF beside it is read, from the buffer if open."""
    editor = await stranger.begin(folders=[])
    editor.write("leg.urdf", GOOD)
    editor.open("leg.srdf", SRDF)
    assert await editor.codes("leg.srdf") == []

    editor.open("leg.urdf", GOOD.replace('"shin"', '"tibia"'))

    assert await editor.codes("leg.srdf", bool) == ["CMP001"]


async def test_closing_a_file_outside_the_workspace_takes_back_what_was_told(stranger):
    """Nobody looks at it any more."""
    editor = await stranger.begin(folders=[])
    editor.write("leg.urdf", LEG)
    editor.open("leg.urdf")
    assert await editor.codes("leg.urdf") == ["LIM001"]

    editor.close("leg.urdf")

    assert await editor.codes("leg.urdf", lambda codes: not codes) == []


async def test_several_folders(stranger):
    """Each is a run of its own, with its own configuration."""
    editor = stranger
    editor.write("one/leg.urdf", LEG)
    editor.write("two/leg.urdf", LEG)
    editor.write("two/kinlint.toml", 'ignore = ["LIM001"]\n')
    await editor.begin(folders=[editor.here / "one", editor.here / "two"])
    for name in ("one/leg.urdf", "two/leg.urdf"):
        editor.open(name)

    assert await editor.codes("one/leg.urdf") == ["LIM001"]
    assert await editor.codes("two/leg.urdf") == []

    gone = types.WorkspaceFolder((editor.here / "two").as_uri(), "two")
    event = types.WorkspaceFoldersChangeEvent(added=[], removed=[gone])
    params = types.DidChangeWorkspaceFoldersParams(event)
    editor.client.workspace_did_change_workspace_folders(params)
    editor.replace("two/leg.urdf", "<robot", " <robot")
    assert await editor.codes("two/leg.urdf") == []


async def test_a_configuration_file_that_changes(editor):
    """The client tells that files changed, or the file is saved."""
    editor.write("leg.urdf", LEG)
    editor.open("leg.urdf")
    assert await editor.codes("leg.urdf") == ["LIM001"]

    editor.write("kinlint.toml", 'ignore = ["LIM"]\n')
    editor.touched("kinlint.toml")
    assert await editor.codes("leg.urdf", lambda codes: not codes) == []

    editor.write("kinlint.toml", 'ignore = ["NONE999"]\n')
    editor.touched("kinlint.toml")
    await asyncio.wait_for(editor.client.complaint.wait(), 30)
    assert "NONE999" in editor.client.messages[0].message

    (editor.here / "kinlint.toml").unlink()
    editor.save("leg.urdf")
    assert await editor.codes("leg.urdf", bool) == ["LIM001"]


@pytest.mark.parametrize(
    "options",
    [
        {"ignore": ["LIM001"]},
        {"settings": {"select": ["UNI"]}},
        {"kinlint": {"configuration": {"ignore": ["LIM"]}}},
        {"configuration": "other.toml"},
    ],
)
async def test_initialization_options(stranger, options):
    """Settings of the editor are on top of configuration files."""
    stranger.write("other.toml", 'ignore = ["LIM001"]\n')
    editor = await stranger.begin(options=options)

    editor.open("leg.urdf", LEG)

    assert await editor.codes("leg.urdf") == []


async def test_settings_that_the_client_is_asked_for(stranger, profile):
    """By workspace/configuration where the client can, or with the change."""
    stranger.client.set_configuration({"kinlint": {"ignore": ["LIM001"]}})
    editor = await stranger.begin(options={"ignore": ["LIM001"]})
    editor.open("leg.urdf", LEG)
    assert await editor.codes("leg.urdf", lambda codes: not codes) == []

    said = {"kinlint": {"ignore": [], "sellect": ["ALL"]}}
    editor.client.set_configuration(said)
    params = types.DidChangeConfigurationParams(settings=said)
    editor.client.workspace_did_change_configuration(params)

    assert await editor.codes("leg.urdf", bool) == ["LIM001"]
    assert "did you mean 'select'" in editor.client.messages[0].message


async def test_on_save(stranger):
    """What is typed is examined when it is saved."""
    editor = await stranger.begin(options={"run": "onSave"})
    editor.write("leg.urdf", LEG)
    editor.open("leg.urdf")
    assert await editor.codes("leg.urdf") == ["LIM001"]

    editor.replace("leg.urdf", 'lower="2"', 'lower="0"')
    if editor.pulls:
        assert await editor.codes("leg.urdf") == ["LIM001"]
    editor.save("leg.urdf")
    assert await editor.codes("leg.urdf", lambda codes: not codes) == []


async def test_a_pulled_report_that_did_not_change(stranger):
    """Neither of a file nor of all; closed files are told of, too."""
    stranger.capabilities.text_document.diagnostic = types.DiagnosticClientCapabilities()
    editor = await stranger.begin()
    assert editor.said.capabilities.diagnostic_provider.inter_file_dependencies
    assert editor.said.capabilities.diagnostic_provider.workspace_diagnostics
    editor.write("leg.urdf", GOOD)
    editor.write("arm/arm.urdf", LEG.replace('name="leg"', 'name="arm"'))
    editor.open("leg.urdf", LEG)

    reports = await pulled(editor)
    assert {uri: len(one.items) for uri, one in reports.items()} == {
        editor.uri("leg.urdf"): 1,
        editor.uri("arm/arm.urdf"): 1,
    }
    assert reports[editor.uri("leg.urdf")].version == 1

    known = [(uri, one.result_id) for uri, one in reports.items()]
    assert {one.kind for one in (await pulled(editor, *known)).values()} == {"unchanged"}
    which = types.TextDocumentIdentifier(editor.uri("leg.urdf"))
    params = types.DocumentDiagnosticParams(which, previous_result_id=dict(known)[which.uri])
    assert (await editor.client.text_document_diagnostic_async(params)).kind == "unchanged"

    editor.replace("leg.urdf", 'lower="2"', 'lower="0"')
    after = await pulled(editor, *known)
    assert after[editor.uri("leg.urdf")].items == ()
    assert after[editor.uri("arm/arm.urdf")].kind == "unchanged"
    assert not editor.client.published


async def test_pushed_for_the_newest_version_only(stranger):
    """A burst of changes is answered once, at its end."""
    stranger.capabilities.text_document.diagnostic = None
    editor = await stranger.begin()
    editor.open("leg.urdf", GOOD)
    seen = []

    for number in range(2, 40):
        editor.replace("leg.urdf", "<robot", " <robot")
        seen.append(number)
    editor.replace("leg.urdf", 'lower="-1"', 'lower="2"')

    assert await editor.codes("leg.urdf", bool) == ["LIM001"]
    assert editor.client.published[editor.uri("leg.urdf")].version == 40


async def test_the_same_as_the_command_finds(editor):
    """In all files of a folder that says something of each other."""
    editor.write("leg.urdf", LEG.replace("shin", "tibia").replace('lower="-1"', 'lower="2"'))
    editor.write("leg.srdf", SRDF)
    command = [KINLINT, "--output-format", "concise", "--isolated", str(editor.here)]
    process = await asyncio.create_subprocess_exec(*command, cwd=editor.here, stdout=PIPE)
    out, _ = await process.communicate()
    for name in ("leg.urdf", "leg.srdf"):
        editor.open(name)

    for name in ("leg.urdf", "leg.srdf"):
        lines = [line for line in out.decode().splitlines() if line.startswith(name)]
        said = sorted(line.rpartition("[")[2].rstrip("]") for line in lines)
        assert await editor.codes(name) == said
        assert said


async def test_files_are_watched_where_the_client_can_watch(stranger):
    """Configuration, rules, contexts and robots."""
    watching = types.DidChangeWatchedFilesClientCapabilities(dynamic_registration=True)
    stranger.capabilities.workspace.did_change_watched_files = watching
    editor = await stranger.begin()
    editor.open("leg.urdf", LEG)
    await editor.codes("leg.urdf")

    (registered,) = editor.client.watched
    assert registered.method == types.WORKSPACE_DID_CHANGE_WATCHED_FILES


async def test_a_request_that_is_cancelled(stranger):
    """It is answered as cancelled, and the next one is answered as ever."""
    stranger.capabilities.text_document.diagnostic = types.DiagnosticClientCapabilities()
    editor = await stranger.begin()
    editor.open("leg.urdf", LEG)
    which = types.TextDocumentIdentifier(editor.uri("leg.urdf"))
    params = types.DocumentDiagnosticParams(which)
    with editor.in_one_piece():
        asked = editor.client.protocol.send_request(
            types.TEXT_DOCUMENT_DIAGNOSTIC, params, msg_id="one"
        )
        editor.client.cancel_request(types.CancelParams("one"))

    with pytest.raises(Exception, match="cancel"):
        await asyncio.wait_for(asyncio.wrap_future(asked), PATIENCE)
    assert await editor.codes("leg.urdf") == ["LIM001"]


async def test_the_server_ends_with_its_client(tmp_path, rules_cache):
    """The process that the client said it is, is no more; standard input stays open."""
    client, capabilities = await started("neovim", dict(os.environ))
    editor = Editor(client, capabilities, tmp_path)
    child = await asyncio.create_subprocess_exec("sleep", "600")
    params = types.InitializeParams(capabilities=capabilities, process_id=child.pid)
    await editor.client.initialize_session(params)
    child.kill()
    await child.wait()

    assert await asyncio.wait_for(client._server.wait(), PATIENCE) == 1


async def test_a_part_in_turtle_is_read(editor):
    """Turtle in the folder, open or not, may describe what a model only names."""
    model = """{"@context": ["https://w3id.org/kinlint/composable.json", {"arm": "https://example.org/arm#"}],
"@graph": [{"@id": "arm:tip", "@type": ["3D", "Frame"], "origin": "arm:tip-origin"},
{"@id": "arm:lid", "@type": ["3D", "Point"]}]}"""
    part = """@prefix arm: <https://example.org/arm#> .
@prefix geom: <https://comp-rob2b.github.io/metamodels/geometry/structural-entities#> .
arm:tip-origin a geom:3D, geom:Point .
"""
    editor.write("model.jsonld", model)
    editor.write("part.ttl", part)
    editor.open("model.jsonld")
    assert "LD006" not in await editor.codes("model.jsonld")

    editor.replace("model.jsonld", '"arm:tip-origin"', '"arm:tip-orgin"')
    assert "LD006" in await editor.codes("model.jsonld", lambda codes: "LD006" in codes)
    editor.replace("model.jsonld", '"arm:tip-orgin"', '"arm:tip-origin"')
    assert "LD006" not in await editor.codes("model.jsonld", lambda codes: "LD006" not in codes)
