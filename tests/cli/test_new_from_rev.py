"""`--new-from-rev` and `--new-from-merge-base`: what was not found at a revision."""

import io
import os
import sys

import pytest
from gitting import commit, git, needs_git

pytestmark = needs_git

ARM = """\
<robot name="{name}">
  <link name="base"/>
  <link name="hand"/>
  <joint name="elbow" type="revolute">
    <parent link="base"/><child link="hand"/><axis xyz="0 0 1"/>
    <limit lower="{lower}" upper="-2.6" effort="10" velocity="1"/>
  </joint>
</robot>
"""
ONLY = ("--select", "LIM001", "--output-format", "concise")


def arm(name="arm", lower="2.6"):
    return ARM.format(name=name, lower=lower)


@pytest.fixture
def tree(here, write):
    """A repository with a robot that has a fault, and one that has none."""
    git(here, "init", "--quiet")
    write("old ü.urdf", arm("old"))
    write("good.urdf", arm("good", "-3"))
    commit(here)
    return here


def test_what_was_there_is_known(kinlint, tree, write):
    """Though it moved; and it is counted."""
    write("old ü.urdf", "\n\n<!-- more -->" + arm("old").replace("  <", "\t<"))
    code, out, _ = kinlint("--new-from-rev", "HEAD", *ONLY)
    assert code == 0
    assert "1 in the baseline" in out


def test_what_came_is_new(kinlint, tree, write):
    """In files that changed, and in those that git was never told of."""
    write("good.urdf", arm("good"))
    write("new, file.urdf", arm("new"))
    code, out, _ = kinlint("--new-from-rev", "HEAD", *ONLY)
    assert code == 1
    assert [line.partition(":")[0] for line in out.splitlines()[:-1]] == [
        "good.urdf",
        "new, file.urdf",
    ]
    commit(tree)
    assert kinlint("--new-from-rev", "HEAD~1", *ONLY)[0] == 1
    assert kinlint("--new-from-rev", "HEAD", *ONLY)[0] == 0


def test_a_renamed_robot_is_known(kinlint, tree):
    """Whether git was told of it or not."""
    (tree / "old ü.urdf").rename(tree / "renamed.urdf")
    assert kinlint("--new-from-rev", "HEAD", *ONLY)[0] == 0
    git(tree, "add", "--all")
    assert kinlint("--new-from-rev", "HEAD", *ONLY)[0] == 0


@pytest.mark.slow
def test_what_a_link_leads_to_is_known(kinlint, tree, write):
    """By the name of the link, which the findings bear."""
    (tree / "link.urdf").symlink_to("old ü.urdf")
    commit(tree)
    for given in ("link.urdf", "."):
        code, out, _ = kinlint(given, "--new-from-rev", "HEAD", *ONLY)
        assert (code, "1 in the baseline" in out) == (0, True)
    write("old ü.urdf", arm("old", "2.7"))
    assert kinlint("link.urdf", "--new-from-rev", "HEAD", *ONLY)[0] == 1


@pytest.mark.slow
def test_from_elsewhere(kinlint, tree, write, monkeypatch):
    """From a directory below, from outside, and for one file alone."""
    write("sub/new.urdf", arm("new"))
    monkeypatch.chdir(tree / "sub")
    assert kinlint("--new-from-rev", "HEAD", *ONLY)[0] == 1
    assert kinlint("../old ü.urdf", "../good.urdf", "--new-from-rev", "HEAD", *ONLY)[0] == 0
    monkeypatch.chdir("/")
    assert kinlint(tree / "old ü.urdf", "--new-from-rev", "HEAD", *ONLY)[0] == 0
    assert kinlint(tree, "--new-from-rev", "HEAD", *ONLY)[0] == 1


@pytest.mark.slow
def test_since_a_branch_was_left(kinlint, tree, write):
    """What the other branch mends meanwhile makes nothing new here."""
    git(tree, "checkout", "--quiet", "-b", "mine")
    git(tree, "checkout", "--quiet", "main")
    write("old ü.urdf", arm("old", "-3"))
    commit(tree)
    git(tree, "checkout", "--quiet", "mine")
    assert kinlint("--new-from-rev", "main", *ONLY)[0] == 1
    assert kinlint("--new-from-merge-base", "main", *ONLY)[0] == 0


@pytest.mark.slow
def test_included_files_are_those_of_the_revision(kinlint, here, write):
    """A macro that changed is read as it was, and a mesh that is deleted is missed anew."""
    git(here, "init", "--quiet")
    macro = '<robot xmlns:xacro="http://ros.org/wiki/xacro">{}</robot>'
    inside = '<limit lower="{}" upper="1" effort="1" velocity="1"/>'
    limit = f'<xacro:macro name="limits">{inside}</xacro:macro>'
    write("limits.xacro", macro.format(limit.format("-1")))
    body = arm("arm").replace(
        '<limit lower="2.6" upper="-2.6" effort="10" velocity="1"/>', "<xacro:limits/>"
    )
    space = ' xmlns:xacro="http://ros.org/wiki/xacro"'
    include = '<xacro:include filename="limits.xacro"/>'
    body = body.replace('"arm">', f'"arm"{space}>{include}', 1)
    write("arm.urdf.xacro", body)
    commit(here)
    assert kinlint("arm.urdf.xacro", "--new-from-rev", "HEAD", *ONLY)[0] == 0
    write("limits.xacro", macro.format(limit.format("2")))
    assert kinlint("arm.urdf.xacro", "--new-from-rev", "HEAD", *ONLY)[0] == 1
    commit(here)
    assert kinlint("arm.urdf.xacro", "--new-from-rev", "HEAD", *ONLY)[0] == 0


def test_the_rules_and_settings_of_today_judge_both(kinlint, tree, write):
    """A rule that is asked only now finds nothing new in what did not change."""
    write("kinlint.toml", 'select = ["LIM001"]\n')
    code, out, _ = kinlint("--new-from-rev", "HEAD", "--output-format", "concise")
    assert (code, "1 in the baseline" in out) == (0, True)


@pytest.mark.slow
def test_standard_input_is_a_newer_state(kinlint, tree, monkeypatch):
    """Of the file that it is called after."""
    for text, code in (
        (arm("old"), 0),
        (arm("other"), 0),
        (arm("old").replace("elbow", "knee"), 1),
    ):
        monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(text.encode())))
        got = kinlint("-", "--stdin-filename", "old ü.urdf", "--new-from-rev", "HEAD", *ONLY)
        assert got[0] == code


def test_fix_leaves_what_is_known(kinlint, tree, write):
    """It mends only what came."""
    path = write("good.urdf", arm("good"))
    code, _, _ = kinlint("--fix", "--unsafe-fixes", "--new-from-rev", "HEAD", *ONLY)
    assert code == 0
    assert 'lower="-2.6" upper="2.6"' in path.read_text("utf-8")
    assert (tree / "old ü.urdf").read_text("utf-8") == arm("old")


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--new-from-rev", "mian"], "unknown revision 'mian', did you mean 'main'?"),
        (["--new-from-rev=--output=x"], "unknown revision '--output=x'"),
        (["--new-from-rev", "main", "--new-from-merge-base", "main"], "exclude each other"),
        (["--new-from-rev", "main", "--write-baseline"], "exclude each other"),
    ],
)
def test_what_cannot_be(kinlint, tree, arguments, said):
    """Exit code 2 and a sentence."""
    code, _, err = kinlint(*arguments, *ONLY)
    assert code == 2
    assert said in err


def test_without_a_repository(kinlint, write):
    """Or without git."""
    write("arm.urdf", arm())
    code, _, err = kinlint("--new-from-rev", "HEAD", *ONLY)
    assert (code, "not a git repository" in err) == (2, True)


def test_the_working_tree_and_git_stay_as_they_are(kinlint, tree, write):
    """No checkout, no lock, no index written."""
    write("good.urdf", arm("good"))
    (tree / "old ü.urdf").rename(tree / "renamed.urdf")

    def state():
        files = [path for path in sorted(tree.rglob("*")) if path.is_file()]
        return [(path, path.stat().st_mtime_ns, path.read_bytes()) for path in files]

    before = state()
    kinlint("--new-from-rev", "HEAD", *ONLY)
    assert state() == before
    assert os.listdir(tree / ".git/refs/heads") == ["main"]  # noqa: PTH208
