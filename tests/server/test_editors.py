"""The settings in the README of the server, tried in the editors that they are for.

Each editor opens a robot with its limits swapped, asks about the finding, and takes the quick fix.
What is set is taken out of the documentation.
"""

import json
import os
import re
import shutil
import subprocess
import sysconfig
import tomllib
from pathlib import Path

import pytest
from editor import Editor, started
from robots import LEG

from kinlint.formats.records import FORMATS

pytestmark = pytest.mark.external

HERE = Path(__file__).parent
README = HERE.parents[1] / "linter/kinlint/server/README.md"
SCRIPTS = sysconfig.get_path("scripts")
SUFFIXES = {
    suffix[1:]
    for each in FORMATS
    if each.searched and each.fence not in ("yaml", "python")
    for suffix in each.suffixes
} | {"dae"}
"""Suffixes that editors are told of; YAML and launch files are checked from the command line.

COLLADA is opened by hand: folders are not searched for it, as nearly all of it is meshes.
"""
FENCE = re.compile(r"^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def settings(editor, language):
    """The blocks in *language* of the section about *editor*."""
    text = README.read_text("utf-8")
    section = re.search(rf"^### {editor}\n(.*?)(?=^##)", text, re.MULTILINE | re.DOTALL)
    assert section is not None
    return [body for kind, body in FENCE.findall(section[1]) if kind == language]


@pytest.fixture
def desk(tmp_path, rules_cache, monkeypatch):
    """A folder with the robot, and an environment without anybody's settings, but with kinlint."""
    folder = tmp_path / "a robot, mit Ümläut"
    folder.mkdir()
    (folder / "leg.urdf").write_text(LEG, "utf-8")
    (folder / "kinlint.toml").touch()
    monkeypatch.chdir(folder)
    monkeypatch.setenv("PATH", SCRIPTS, prepend=os.pathsep)
    monkeypatch.setenv("HOME", str(tmp_path))
    for name in ("CONFIG", "DATA", "STATE"):
        monkeypatch.setenv(f"XDG_{name}_HOME", str(tmp_path / name))
    return tmp_path


def told(command):
    """What an editor tells, by name."""
    process = subprocess.run(command, capture_output=True, timeout=240, check=False)
    lines = process.stdout.decode().splitlines()
    found = dict(line.split("\t", 1) for line in lines if "\t" in line)
    assert found, process.stderr.decode()
    return {name: json.loads(value) for name, value in found.items()}


def check(said):
    """That the editor marked the finding, showed the rule, offered the fix, and made it."""
    assert "fault" not in said, said["fault"]
    assert said["marked"] == "2"
    assert "inverted-limit" in said["hover"]
    assert "kinlint (LIM001): Swap the two limits" in said["actions"]
    assert said["line"] == LEG.splitlines()[said_line()].replace('"2" upper="1"', '"1" upper="2"')
    assert said["mended"] is True


def said_line():
    return next(i for i, line in enumerate(LEG.splitlines()) if "<limit" in line)


def neovims():
    """The Neovims of this machine with their versions."""
    folders = dict.fromkeys([SCRIPTS, *os.environ["PATH"].split(os.pathsep)])
    found = (shutil.which("nvim", path=folder) for folder in folders)
    for path in dict.fromkeys(filter(None, found)):
        output = subprocess.run([path, "--version"], capture_output=True, text=True, check=False)
        if version := re.match(r"NVIM v(\d+)\.(\d+)", output.stdout):
            yield path, (int(version[1]), int(version[2]))


@pytest.mark.parametrize(("number", "first", "last"), [(0, (0, 11), (9, 0)), (1, (0, 7), (0, 10))])
def test_neovim(desk, number, first, last):
    """There are settings for versions from 0.11 on, and for older ones."""
    fitting = [path for path, version in neovims() if first <= version <= last]
    if not fitting:
        pytest.skip(f"no Neovim from {first} to {last}")
    init = desk / "init.lua"
    init.write_text(settings("Neovim", "lua")[number], "utf-8")
    drive = HERE / "driving" / "neovim.lua"
    check(told([fitting[0], "--headless", "--clean", "-u", init, "-c", f"luafile {drive}"]))


def test_emacs(desk):
    """With Eglot, which Emacs 29 has and Debian has for older ones."""
    emacs = shutil.which("emacs")
    if emacs is None:
        pytest.skip("no Emacs")
    begin = [emacs, "--batch", "-q", "--eval", "(package-initialize)"]
    asked = [*begin, "--eval", "(kill-emacs (if (require 'eglot nil t) 0 1))"]
    if subprocess.run(asked, capture_output=True, check=False).returncode:
        pytest.skip("Emacs without Eglot")
    (init,) = settings("Emacs", "elisp")
    (desk / "init.el").write_text(init, "utf-8")
    check(told([*begin, "-l", desk / "init.el", "-l", HERE / "driving" / "emacs.el"]))


def test_helix_settings_name_all_files_and_the_server():
    (text,) = settings("Helix", "toml")
    said = tomllib.loads(text)
    server = said["language-server"]["kinlint"]
    assert shutil.which(server["command"], path=SCRIPTS)
    assert server["args"] == ["server"]
    assert {each for one in said["language"] for each in one["file-types"]} == SUFFIXES
    assert all(one["language-servers"] == ["kinlint"] for one in said["language"])


def test_helix(desk):
    """It knows the languages, and finds the server."""
    helix = shutil.which("hx") or shutil.which("helix")
    if helix is None:
        pytest.skip("no Helix")
    (text,) = settings("Helix", "toml")
    place = desk / "CONFIG" / "helix" / "languages.toml"
    place.parent.mkdir(parents=True)
    place.write_text(text, "utf-8")
    for language in ("robot-xml", "robot-json"):
        command = [helix, "--health", language]
        said = subprocess.run(command, capture_output=True, text=True, check=True).stdout
        assert "kinlint" in said
        assert "✘ kinlint" not in said


@pytest.mark.asyncio
async def test_vs_code_settings_start_the_server(desk):
    """The extension starts what is set, for the languages that are set, with these options."""
    (text,) = settings("VS Code", "json")
    said = json.loads(text)
    kinds = {key.removeprefix("*."): kind for key, kind in said["files.associations"].items()}
    assert kinds.keys() == SUFFIXES
    assert set(kinds.values()) == set(said["glspc.server.languageId"])
    command = [shutil.which(said["glspc.server.command"]), *said["glspc.server.commandArguments"]]
    client, capabilities = await started("visual-studio-code", dict(os.environ), command)
    editor = Editor(client, capabilities, Path.cwd())
    await editor.begin(options=said["glspc.server.initializationOptions"])
    editor.open("leg.urdf", language=kinds["urdf"])
    assert "LIM001" in await editor.codes("leg.urdf", lambda codes: "LIM001" in codes)
    assert not client.messages
    await client.shutdown_session()
    await client.stop()
