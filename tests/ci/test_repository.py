"""What this repository does for those who work on it agrees with what it says elsewhere."""

import re
import shutil
import subprocess
import tomllib

import pytest
import yaml
from workflow import ROOT

OWN = yaml.safe_load((ROOT / ".pre-commit-config.yaml").read_text("utf-8"))
OFFERED = yaml.safe_load((ROOT / ".pre-commit-hooks.yaml").read_text("utf-8"))
GATE = yaml.safe_load((ROOT / ".github/workflows/gate.yml").read_text("utf-8"))
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]


def test_the_repository_uses_a_hook_that_it_offers():
    """By the same name and entry, on some folders instead of on all."""
    (own,) = (
        hook for each in OWN["repos"] for hook in each["hooks"] if hook["id"] == "kinlint-project"
    )
    (offered,) = (hook for hook in OFFERED if hook["id"] == "kinlint-project")

    assert own["name"] == offered["name"]
    assert own["pass_filenames"] is offered["pass_filenames"] is False
    assert own["entry"].startswith(f".venv/bin/{offered['entry'].removesuffix(' .')} ")
    for folder in own["entry"].split()[3:]:
        assert (ROOT / folder).is_dir()


def test_the_gate_runs_on_each_python_from_the_oldest_that_is_supported():
    """And on Windows and macOS."""
    matrix = GATE["jobs"]["tests"]["strategy"]["matrix"]

    assert PROJECT["requires-python"] == f">={matrix['python'][0]}"
    for version in matrix["python"]:
        assert f"Programming Language :: Python :: {version}" in PROJECT["classifiers"]
    assert {each["os"] for each in matrix["include"]} == {"windows-latest", "macos-latest"}


def test_the_gate_runs_the_test_command_of_the_readme():
    """So that what a newcomer types is what is tried."""
    text = (ROOT / "README.md").read_text("utf-8")
    (command,) = re.findall(r"\.venv/bin/(pytest .*)", text)
    runs = [step.get("run", "") for step in GATE["jobs"]["tests"]["steps"]]

    assert f"python -m {command}" in runs
    assert f"$(BIN)/{command}" in (ROOT / "Makefile").read_text("utf-8")


@pytest.mark.external
@pytest.mark.skipif(shutil.which("make") is None, reason="there is no make")
@pytest.mark.parametrize("word", ["setup", "test", "check", "bench", "docs"])
def test_a_word_of_the_makefile_is_a_list_of_commands(word, tmp_path):
    """Tried without running them: make finds what they need."""
    done = subprocess.run(
        ["make", "-n", "-C", ROOT, word], capture_output=True, text=True, check=False
    )

    assert done.returncode == 0, done.stderr
    assert ".venv/bin" in done.stdout


def test_generated_pages_are_marked():
    """What says that a command made it is collapsed in reviews."""
    marked = re.findall(
        r"^(\S+) linguist-generated", (ROOT / ".gitattributes").read_text(), re.MULTILINE
    )
    pages = [ROOT / "linter/kinlint.schema.json", *ROOT.glob("rules/*/README.md")]
    pages += [each for each in ROOT.glob("*/*.md") if "Made by `" in each.read_text("utf-8")]
    pages.remove(ROOT / "rules/README.md")

    for page in pages:
        assert any(page.relative_to(ROOT).match(pattern) for pattern in marked), page
