"""What is appended to `$GITHUB_STEP_SUMMARY`."""

import shutil
import subprocess

import pytest

from kinlint.cli import github_step_summary

JOINT = """  <joint name="j{n}" type="fixed"><parent link="base"/><child link="l{n}"/></joint>
  <link name="l{n}"/>
"""
ROBOT = '<robot name="{name}">\n  <link name="base"/>\n{more}</robot>\n'
FAULT = '  <joint name="e{n}" type="revolute"><parent link="base"/><child link="no{n}"/></joint>\n'


def robot(name, *, faults=0, joints=0):
    parts = [FAULT.format(n=n) for n in range(faults)] + [JOINT.format(n=n) for n in range(joints)]
    return ROBOT.format(name=name, more="".join(parts))


@pytest.fixture(autouse=True)
def workflow(here, monkeypatch):
    """A step of a workflow, whose summary has something in it already."""
    for name in ("SERVER_URL", "REPOSITORY", "SHA", "BASE_REF"):
        monkeypatch.delenv(f"GITHUB_{name}", raising=False)
    file = here / "summary.md"
    file.write_text("# before\n", "utf-8")
    monkeypatch.setenv("GITHUB_STEP_SUMMARY", str(file))
    return file


@pytest.fixture
def summary(kinlint, workflow):
    """Run the command, and what was appended."""

    def run(*arguments, form="github"):
        kinlint(".", "--output-format", form, *arguments)
        text = workflow.read_text("utf-8")
        assert text.startswith("# before\n")
        return text.removeprefix("# before\n")

    return run


def git(*words):
    if shutil.which("git") is None:
        pytest.skip("there is no git")
    own = ["-c", "user.name=t", "-c", "user.email=t@example.org"]
    subprocess.run(["git", *own, *words], check=True, capture_output=True)


def test_it_has_the_table_and_the_tree(write, summary, workflow):
    """And nothing that is annotated anyway; each run adds its own."""
    write("a robot.urdf", robot("arm", faults=1))
    text = summary()
    assert "| [TOP001](https://w3id.org/kinlint/rules/undefined-link-reference) |" in text
    assert "Not annotated" not in text
    assert "<summary>arm (a robot.urdf): 2 links, 1 joint</summary>\n\n```mermaid\n" in text
    assert text.count("```") == 2
    assert summary() == text * 2


def test_what_is_not_annotated_is_told(write, summary, monkeypatch):
    """With links to where GitHub has the files."""
    write("a|b.urdf", robot("arm", faults=12))
    text = summary("--select", "TOP001")
    assert "\n### Not annotated: 2 errors\n\n#### a\\|b.urdf (2 errors)\n\n- 13:" in text
    assert text.count("**error**") == 2
    monkeypatch.setenv("GITHUB_SERVER_URL", "https://github.com")
    monkeypatch.setenv("GITHUB_REPOSITORY", "some/one")
    monkeypatch.setenv("GITHUB_SHA", "f00d")
    assert "](https://github.com/some/one/blob/f00d/a%7Cb.urdf#L14)" in summary()


@pytest.mark.slow
def test_only_the_format_github_writes_one(write, summary, here):
    """Also as a copy; a run that is to be silent says nothing here either."""
    write("arm.urdf", robot("arm", faults=1))
    assert summary(form="concise") == ""
    assert summary("--silent") == ""
    assert "TOP001" in summary(f"--github-output={here / 'out.txt'}", form="concise")


def test_names_are_text(write, summary):
    """A robot may be called anything."""
    write("x.urdf", robot("&lt;img src=x&gt;```|[x](y)&quot;]", faults=1))
    text = summary()
    assert "<img" not in text
    assert text.count("```") == 2 + 1  # The name in a line of its own cannot close the chart.
    assert "\n```|" not in text


@pytest.mark.slow
def test_robots_without_findings_are_left_out_unless_they_changed(write, summary):
    """Git tells, against the base of a pull request or else the last commit."""
    for name in ("good", "bad", "fresh"):
        write(f"{name}.urdf", robot(name, faults=name == "bad"))
    text = summary()
    assert "<summary>bad (" in text
    assert text.count("<summary>") == 1
    git("init", "-q", "-b", "main")
    git("add", "bad.urdf")
    git("commit", "-q", "-m", "one")
    git("add", "good.urdf")
    git("commit", "-q", "-m", "two")
    shown = summary().removeprefix(text)
    assert [name in shown for name in ("<summary>good (", "<summary>fresh (")] == [True, True]
    assert "<summary>bad (" not in shown


@pytest.mark.slow
def test_the_base_of_a_pull_request_decides(write, summary, monkeypatch):
    """What changed since the branch left it."""
    for name in ("first", "second", "third"):
        write(f"{name}.urdf", robot(name))
    git("init", "-q", "-b", "main")
    for name in ("first", "second", "third"):
        git("add", f"{name}.urdf")
        git("commit", "-q", "-m", name)
    git("update-ref", "refs/remotes/origin/main", "HEAD~2")
    monkeypatch.setenv("GITHUB_BASE_REF", "main")
    text = summary()
    shown = [f"<summary>{name} (" in text for name in ("first", "second", "third")]
    assert shown == [False, True, True]
    monkeypatch.setenv("GITHUB_BASE_REF", "gone")
    assert "<summary>" not in summary().removeprefix(text)


@pytest.mark.slow
def test_it_stays_below_what_github_takes(write, summary, monkeypatch, workflow):
    """What there is no room for is said to be left out."""
    write("arm.urdf", robot("arm", faults=60))
    monkeypatch.setattr(github_step_summary, "LIMIT", 2_000)
    text = summary()
    assert "The rest is too long for this summary" in text
    assert workflow.stat().st_size < 2_000
    assert text.count("**error**") > 0
    monkeypatch.setattr(github_step_summary, "LIMIT", 100)
    assert summary() == text


@pytest.mark.slow
def test_a_robot_that_is_too_large_is_not_drawn(write, summary):
    """GitHub would show an error instead."""
    write("arm.urdf", robot("arm", faults=1, joints=260))
    text = summary()
    assert "Too large for GitHub to draw" in text
    assert "```" not in text


def test_a_summary_that_cannot_be_written_is_a_warning(write, kinlint, here, monkeypatch):
    """The findings are told all the same."""
    write("arm.urdf", robot("arm", faults=1))
    monkeypatch.setenv("GITHUB_STEP_SUMMARY", str(here / "no" / "summary.md"))
    code, out, err = kinlint("arm.urdf", "--output-format", "github")
    assert code == 1
    assert "::error" in out
    assert "kinlint: warning: no summary of the step: " in err
