"""The first minutes: `kinlint demo` explains findings, `kinlint init` sets up a project."""

import io
import os
import tomllib

import pytest
import yaml

from kinlint.cli.init_command import with_entry

REPOSITORY = ("--repository", "https://github.com/acme/kinlint")
HOOKS = """\
# Hooks of the team.
default_stages: [pre-commit]
repos:
  # Formatting
  - repo: https://example.org/black
    rev: v1  # pinned
    hooks:
      - id: black
        args:
          - --fast

  # Nothing else yet.
ci:
  autofix_prs: false
"""


def test_nothing_is_written_unasked(kinlint, here):
    """Where nobody can answer, the files are shown."""
    code, out, _ = kinlint("init")
    assert code == 0
    assert "kinlint.toml (new file):" in out
    assert "is not written: there is no terminal to ask on, and --yes is not given" in out
    assert "OWNER stands for whoever keeps the repository" in out
    assert list(here.iterdir()) == []


def test_a_project_is_set_up(kinlint, here):
    """With files that those read who are meant, and nothing the second time."""
    assert kinlint("init", "--yes", *REPOSITORY)[0] == 0
    assert tomllib.loads((here / "kinlint.toml").read_text("utf-8")) == {"fail-on": "error"}
    hooks = yaml.safe_load((here / ".pre-commit-config.yaml").read_text("utf-8"))
    (repository,) = hooks["repos"]
    assert repository["repo"] == "https://github.com/acme/kinlint"
    assert repository["hooks"] == [{"id": "kinlint"}]
    workflow = yaml.safe_load((here / ".github/workflows/kinlint.yml").read_text("utf-8"))
    assert workflow["jobs"]["kinlint"]["steps"][1]["uses"].startswith("acme/kinlint@v")
    before = {path: path.read_bytes() for path in here.rglob("*") if path.is_file()}
    out = kinlint("init", "--yes")[1]
    assert out.count("is there already") == 2
    assert "has the hook already" in out
    assert {path: path.read_bytes() for path in before} == before
    assert kinlint("config", "fail-on")[0] == 0


def test_links_out_of_the_project_are_not_followed(kinlint, here, tmp_path_factory):
    """Neither those of directories nor those of files; what they lead to stays as it is."""
    elsewhere = tmp_path_factory.mktemp("elsewhere")
    (elsewhere / "hooks.yaml").write_text(HOOKS, "utf-8")
    (here / ".github").symlink_to(elsewhere)
    (here / "kinlint.toml").symlink_to(elsewhere / "new.toml")
    (here / ".pre-commit-config.yaml").symlink_to(elsewhere / "hooks.yaml")

    code, out, _ = kinlint("init", "--yes", *REPOSITORY)

    assert code == 0
    assert "links lead out of the project" in out
    assert [path.name for path in elsewhere.iterdir()] == ["hooks.yaml"]
    assert (elsewhere / "hooks.yaml").read_text("utf-8") == HOOKS


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="there are no named pipes here")
def test_pipes_are_not_read(kinlint, here):
    """Nobody may ever write to them."""
    os.mkfifo(here / ".pre-commit-config.yaml")
    os.mkfifo(here / "kinlint.toml")

    code, out, _ = kinlint("init", "--yes", *REPOSITORY)

    assert code == 0
    assert ".pre-commit-config.yaml is not a file of the project" in out
    assert "kinlint.toml is there already" in out


def test_a_user_who_is_asked_may_say_no(kinlint, here, monkeypatch):
    """To some, and yes to others."""
    answers = io.StringIO("n\ny\n\n")
    monkeypatch.setattr(answers, "isatty", lambda: True)
    monkeypatch.setattr("sys.stdin", answers)
    monkeypatch.setattr("sys.stdout.isatty", lambda: True, raising=False)
    kinlint("init")
    assert [path.name for path in here.iterdir()] == [".pre-commit-config.yaml"]


def test_hooks_are_added_and_all_else_stays(kinlint, write):
    """Comments, blank lines, and the way in which lists are indented."""
    path = write(".pre-commit-config.yaml", HOOKS)
    kinlint("init", "--yes", *REPOSITORY)
    text = path.read_text("utf-8")
    found = yaml.safe_load(text)
    assert [each["hooks"][0]["id"] for each in found["repos"]] == ["black", "kinlint"]
    assert found["ci"] == {"autofix_prs": False}
    kept = [line for line in text.splitlines() if line in HOOKS.splitlines()]
    assert kept == HOOKS.splitlines()


@pytest.mark.parametrize("text", ["repos: []\n", "fail_fast: true\n", "repos:\n"])
def test_hooks_in_another_form_are_left_alone(kinlint, write, text):
    """What to add is said."""
    path = write(".pre-commit-config.yaml", text)
    out = kinlint("init", "--yes")[1]
    if with_entry(text, "-   repo: x\n") is None:
        assert "is not written as usual. Add to its repos:" in out
        assert path.read_text("utf-8") == text
    else:
        assert yaml.safe_load(path.read_text("utf-8"))["repos"][0]["hooks"]


def test_the_demo_shows_three_faults_and_explains_them(kinlint, here):
    """With fixes; in the directory of the user nothing is written."""
    code, out, err = kinlint("demo")
    assert (code, err) == (0, "")
    for word in ("error[INE001]", "error[LIM001]", "error[TOP001]", "Swap the two limits"):
        assert word in out
    assert "Found 3 errors in 1 file" in out
    assert "How to read it:" in out
    assert list(here.iterdir()) == []


def test_the_robot_of_the_demo_is_written_once(kinlint, here):
    """To try it: its fixes leave one error."""
    assert kinlint("demo", "-o", "arm.urdf")[0] == 0
    code, _, err = kinlint("demo", "-o", "arm.urdf")
    assert (code, "is there already" in err) == (2, True)
    code, out, _ = kinlint("arm.urdf", "--fix", "--unsafe-fixes", "--output-format", "concise")
    assert code == 1
    assert [line.rpartition(" ")[2] for line in out.splitlines()[:-1]] == ["[INE001]"]
