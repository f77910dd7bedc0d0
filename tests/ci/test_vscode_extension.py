"""The extension for VS Code: its settings are those of the server, and it builds."""

import json
import shutil
import subprocess
import zipfile
from pathlib import Path

import pytest

from kinlint.formats.records import FORMATS
from kinlint.server.client_settings import KNOWN

FOLDER = Path(__file__).parents[2] / "editors" / "vscode"
MANIFEST = json.loads((FOLDER / "package.json").read_text("utf-8"))
PROPERTIES = MANIFEST["contributes"]["configuration"]["properties"]
OWN = {"command", "trace.server"}
"""Settings of the extension itself."""


def test_the_settings_are_those_of_the_server():
    names = {name.removeprefix("kinlint.") for name in PROPERTIES}
    assert names == {*KNOWN, *OWN}
    sent = (FOLDER / "src" / "settings.ts").read_text("utf-8")
    assert all(f'"{name}",' in sent for name in KNOWN)


def test_the_suffixes_are_those_of_the_formats():
    languages = MANIFEST["contributes"]["languages"]
    known = {suffix for each in languages for suffix in each["extensions"]}
    own = {s for each in FORMATS if each.searched for s in each.suffixes if s.count(".") == 1}
    ends = (".yaml", ".yml", ".rviz", ".py", ".xml")
    assert known >= {suffix for suffix in own if not suffix.endswith(ends)}


def test_commands_of_the_server_are_left_to_the_client():
    """A command of the same name could not be registered by both."""
    own = {each["command"] for each in MANIFEST["contributes"]["commands"]}
    commands = Path(__file__).parents[2] / "linter/kinlint/server/workspace_commands.py"
    assert not [each for each in own if f'"{each}"' in commands.read_text("utf-8")]


@pytest.mark.external
@pytest.mark.slow
def test_the_extension_is_tested_and_packed(tmp_path):
    if shutil.which("npm") is None:
        pytest.skip("npm is not installed")
    here = tmp_path / "vscode"
    shutil.copytree(FOLDER, here, ignore=shutil.ignore_patterns("node_modules", "out"))

    def npm(*arguments):
        return subprocess.run(
            ["npm", *arguments],
            cwd=here,
            capture_output=True,
            text=True,
            check=False,
        )

    installed = npm("ci", "--no-audit", "--no-fund")
    if installed.returncode:
        pytest.skip(f"the packages cannot be had: {installed.stderr[-200:]}")
    tested = npm("test")
    assert tested.returncode == 0, tested.stdout
    assert "# fail 0" in tested.stdout
    packed = npm("run", "package")
    assert packed.returncode == 0, packed.stderr
    with zipfile.ZipFile(here / "out" / "kinlint.vsix") as archive:
        assert {"extension/package.json", "extension/out/extension.js"} <= set(archive.namelist())
