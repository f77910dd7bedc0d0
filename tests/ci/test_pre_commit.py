"""The hooks of this repository, installed and run by pre-commit as its users do.

Not everything that git knows of is committed while somebody works, so a copy of the working tree
becomes the repository that the hooks come from.
"""

import os
import re
import shutil
import subprocess
import sys

import pytest
import yaml
from ci_robots import BAD, GOOD, LONG_AXIS
from workflow import ROOT

from kinlint.cli.check_command import run as check
from kinlint.cli.check_options import parser
from kinlint.formats.records import SEARCHED

MANIFEST = ROOT / ".pre-commit-hooks.yaml"
HOOKS = yaml.safe_load(MANIFEST.read_text("utf-8"))
CONFIG = """repos:
-   repo: {repository}
    rev: {revision}
    hooks:
    -   id: {hook}
"""


def test_hooks_are_well_formed():
    """As pre-commit judges it."""
    pytest.importorskip("pre_commit")
    done = command(ROOT, sys.executable, "-m", "pre_commit", "validate-manifest", MANIFEST)
    assert done.returncode == 0, done.stdout
    assert [hook["id"] for hook in HOOKS] == ["kinlint", "kinlint-project", "kinlint-fix"]


@pytest.mark.parametrize("hook", HOOKS, ids=lambda hook: hook["id"])
def test_files_are_those_that_are_read(hook):
    """Each suffix that a search looks for, in any case, and nothing else."""
    for suffix in SEARCHED:
        assert re.search(hook["files"], f"a b/arm{suffix}")
        assert re.search(hook["files"], f"ARM{suffix.upper()}")
    for name in ("arm.stl", "arm.urdf.bak", "jsonld", "arm.ttl", "README.md"):
        assert not re.search(hook["files"], name)


@pytest.mark.parametrize("hook", HOOKS, ids=lambda hook: hook["id"])
def test_entries_are_command_lines(hook):
    """That kinlint knows, with excludes that hold for files that are named."""
    program, check, *words = hook["entry"].split()
    assert (program, check) == ("kinlint", "check")
    options = parser().read(words)
    assert options.force_exclude
    assert options.in_project is hook.get("pass_filenames", True)


def command(directory, *words, **environment):
    known = {name: value for name, value in os.environ.items() if not name.startswith("GIT_")}
    for name in ("author", "committer"):
        known |= {f"GIT_{name.upper()}_NAME": "t", f"GIT_{name.upper()}_EMAIL": "t@example.org"}
    return subprocess.run(
        list(map(str, words)),
        cwd=directory,
        env={**known, "GIT_CONFIG_GLOBAL": os.devnull, **environment},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
        timeout=900,
    )


def commit(directory):
    """Make *directory* a repository with all that is in it."""
    command(directory, "git", "init", "-q")
    command(directory, "git", "add", "-A")
    done = command(directory, "git", "commit", "-q", "-m", "all", "--no-verify")
    assert done.returncode == 0, done.stdout


def installs(test):
    """Mark a test that has pre-commit install the hooks: one environment for all of them."""
    return pytest.mark.external(pytest.mark.xdist_group("environment of pre-commit")(test))


@pytest.fixture(scope="module")
def repository(tmp_path_factory):
    """A repository with what is in the working tree, but for what git ignores."""
    pytest.importorskip("pre_commit")
    if shutil.which("git") is None:
        pytest.skip("there is no git")
    told = command(ROOT, "git", "ls-files", "-z", "-co", "--exclude-standard").stdout
    if told.startswith("fatal"):
        pytest.skip("this is no working tree of git")
    done = command(ROOT, sys.executable, "-m", "pip", "download", "-q", "--no-deps", "hatchling",
                   "-d", tmp_path_factory.mktemp("download"))  # fmt: skip
    if done.returncode:
        pytest.skip("pip reaches no index of packages")
    made = tmp_path_factory.mktemp("repository")
    for name in filter(None, told.split("\0")):
        if (ROOT / name).is_file() and not name.startswith("tests/"):
            (made / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, made / name)
    commit(made)
    return made


@pytest.fixture(scope="module")
def store(tmp_path_factory):
    """Where pre-commit keeps what it installs: once for all tests."""
    return tmp_path_factory.mktemp("store")


@pytest.fixture
def project(tmp_path):
    """A scratch project under git, with a robot that is good."""
    made = tmp_path / "pro ject"
    made.mkdir()
    (made / "good arm.urdf").write_text(GOOD, "utf-8")
    (made / "package.json").write_text('{"name": "no robot"}', "utf-8")
    return made


@pytest.fixture
def hook(repository, store, project):
    """Run a hook on all files of the project: the exit code and what is told."""
    revision = command(repository, "git", "rev-parse", "HEAD").stdout.strip()

    def run(name):
        config = CONFIG.format(repository=repository, revision=revision, hook=name)
        (project / ".pre-commit-config.yaml").write_text(config, "utf-8")
        commit(project)
        words = ("pre_commit", "run", "--all-files", "--color", "never")
        done = command(project, sys.executable, "-m", *words, PRE_COMMIT_HOME=str(store))
        return done.returncode, done.stdout

    return run


@installs
def test_try_repo(repository, project, tmp_path):
    """All hooks at once: each finds the bad robot, none the good one."""
    (project / "bad arm.urdf").write_text(BAD, "utf-8")
    commit(project)
    words = ("pre_commit", "try-repo", repository, "--all-files", "--color", "never")
    done = command(project, sys.executable, "-m", *words, PRE_COMMIT_HOME=str(tmp_path / "store"))
    assert done.returncode == 1, done.stdout
    assert done.stdout.count("error[INE003]") == len(HOOKS)
    assert "good arm" not in done.stdout
    assert done.stdout.count("Failed") == len(HOOKS)


@installs
def test_a_good_project_passes(hook):
    """Also where JSON is no robot."""
    for name in ("kinlint", "kinlint-project"):
        code, told = hook(name)
        assert (code, "Passed" in told) == (0, True), told


@installs
def test_an_exclude_holds(hook, project):
    """Although pre-commit names the file."""
    (project / "bad.urdf").write_text(BAD, "utf-8")
    assert hook("kinlint")[0] == 1
    (project / "kinlint.toml").write_text('extend-exclude = ["bad.urdf"]', "utf-8")
    for name in ("kinlint", "kinlint-project"):
        code, told = hook(name)
        assert code == 0, told


@installs
def test_a_fix_fails_the_run_once(hook, project):
    """As pre-commit wants it of a hook that changes files."""
    (project / "arm.urdf").write_text(LONG_AXIS, "utf-8")
    code, told = hook("kinlint-fix")
    assert code == 1
    assert "files were modified by this hook" in told
    assert '<axis xyz="1 0 0"/>' in (project / "arm.urdf").read_text("utf-8")
    code, told = hook("kinlint-fix")
    assert code == 0, told


@installs
def test_many_files_give_the_findings_of_one_run(hook, project, monkeypatch, capsys):
    """pre-commit splits them; what lies in one is told once, and as if all were named."""
    folder = project.joinpath(*("a folder with a long name ".ljust(240, "x") for _ in range(2)))
    folder.mkdir(parents=True)
    for number in range(300):
        text = BAD if number % 10 == 0 else GOOD
        name = "twin" if number % 20 == 0 else f"arm{number}"
        text = text.replace('name="arm"', f'name="{name}"')
        (folder / f"robot number {number:04}.urdf").write_text(text, "utf-8")
    monkeypatch.setenv("KINLINT_OUTPUT_FORMAT", "concise")
    code, told = hook("kinlint")
    assert code == 1
    assert told.count("Found ") + told.count("All checks passed") > 1
    monkeypatch.chdir(project)
    capsys.readouterr()
    assert check([]) == 1
    lines = [line for line in capsys.readouterr().out.splitlines() if line.endswith("]")]
    assert sorted(line for line in told.splitlines() if line.endswith("]")) == sorted(lines)
    assert len(lines) == 60
