"""What git ignores is ignored, and nothing else."""

import subprocess

import pytest
from gitting import git, needs_git

from kinlint.files.gitignore import GitIgnore

PATHS = (
    "arm.urdf", "old/arm.urdf", "old/kept/arm.urdf", "gen/a.urdf", "models/gen/a.urdf",
    "models/b.xacro", "models/deep/b.xacro", "models/deep/c.sdf", "build.urdf", "#a.urdf",
    "models/only/here.urdf", "only/here.urdf", "space /a.urdf", "models/not.urdf",
)  # fmt: skip
TOP = "gen/\n*.sdf\n/old/*\n!/old/kept/\n\\#a.urdf\n# no.urdf\nmodels/**/b.xacro\n/only\n[\n"
BELOW = "!deep/b.xacro\nonly/*\nnot.urdf\n!not.urdf\n"


@pytest.fixture
def tree(tmp_path):
    """A directory with files, and patterns at two levels."""
    for name in PATHS:
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text("")
    (tmp_path / ".gitignore").write_text(TOP)
    (tmp_path / "models" / ".gitignore").write_text(BELOW)
    return tmp_path


def ignored(top, outer=None):
    """The paths that a walk of *top* does not come to."""
    rules = GitIgnore(top, outer or top)

    def passed_over(path):
        above = [each for each in path.parents if each != top and each.is_relative_to(top)]
        return any(rules.ignores(each, directory=True) for each in above) or rules.ignores(
            path, directory=False
        )

    files = [each for each in top.rglob("*.*") if each.name[0] != "." and ".git" not in each.parts]
    return sorted(each.relative_to(top).as_posix() for each in files if passed_over(each))


@needs_git
def test_as_git_does(tree):
    """With patterns of both files and of `.git/info/exclude`."""
    git(tree, "init", "--quiet")
    (tree / ".git" / "info" / "exclude").write_text("build.*\n")
    done = subprocess.run(
        ["git", "check-ignore", "--stdin", "-z"],
        cwd=tree, input="\0".join(PATHS), capture_output=True, text=True, check=True,
    )  # fmt: skip
    by_git = sorted(filter(None, done.stdout.split("\0")))
    assert ignored(tree) == by_git
    assert "build.urdf" in by_git
    assert "arm.urdf" not in by_git


def test_without_a_repository(tree):
    """Patterns count from the outermost directory that is asked for."""
    assert "gen/a.urdf" in ignored(tree)
    assert "gen/a.urdf" in ignored(tree / "models", tree)
    assert "gen/a.urdf" not in ignored(tree / "models")


def test_a_repository_within_has_patterns_of_its_own(tree):
    """Those of the outer one end there."""
    (tree / "models" / ".git").mkdir()
    assert "models/gen/a.urdf" not in ignored(tree)
    assert "models/only/here.urdf" in ignored(tree)


def test_a_directory_that_is_ignored_can_be_named(tree):
    """Patterns within count still."""
    (tree / "gen" / ".gitignore").write_text("b.urdf\n")
    (tree / "gen" / "b.urdf").write_text("")
    assert ignored(tree / "gen", tree) == ["b.urdf"]


@pytest.mark.parametrize("pattern", ["src/", "src/*", "/src"])
def test_repositories_that_were_checked_out_into_a_workspace(tmp_path, pattern):
    """A repository of nothing but a list of others ignores these, which are worked on."""
    (tmp_path / ".git").mkdir()
    (tmp_path / ".gitignore").write_text(f"{pattern}\nother/\n")
    for name in ("src/arm/.git", "src/plain", "other/arm/.git"):
        (tmp_path / name).mkdir(parents=True)
    for name in ("src/arm/a.urdf", "src/plain/a.urdf", "other/arm/a.urdf"):
        (tmp_path / name).write_text("")
    assert ignored(tmp_path) == ["other/arm/a.urdf", "src/plain/a.urdf"]
