"""The steps of action.yml, run in bash as a runner does."""

import json
import re
import sys

import pytest
from ci_robots import AXIS, BAD, GOOD
from workflow import ACTION, ROOT

from kinlint import __version__

pytestmark = pytest.mark.external

NAME = "a robot, [1]; 100%.urdf"


def lint(runner, files=None, **inputs):
    for name, text in (files or {NAME: BAD}).items():
        path = runner.workspace / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(text, "utf-8")
    return runner.run(**{"version": "installed", "src": NAME, **inputs})


def test_findings_fail_the_step_and_all_outputs_are_set(runner):
    """Annotated, summarised and written as SARIF."""
    code, outputs = lint(runner)
    assert code == 1
    assert outputs == {
        "findings": "2",
        "sarif-file": "kinlint.sarif",
        "kinlint-version": __version__,
    }
    annotations = [line for line in runner.log.splitlines() if line.startswith("::")]
    place = f"file={runner.workspace}/a robot%2C [1]; 100%25.urdf,line=2,"
    assert [place in line for line in annotations] == [True, False]
    log = json.loads((runner.workspace / "kinlint.sarif").read_text("utf-8"))
    assert len(log["runs"][0]["results"]) == 2
    summary = runner.summary.read_text("utf-8")
    assert "INE003" in summary
    assert "```mermaid" in summary
    assert list(runner.temporary.iterdir()) == []


def test_a_clean_robot_passes(runner):
    """No finding, and an output that says so."""
    code, outputs = lint(runner, {NAME: GOOD})
    assert (code, outputs["findings"]) == (0, "0")
    assert "All checks passed" in runner.summary.read_text("utf-8")


@pytest.mark.parametrize(("fail_on", "code"), [("none", 0), ("error", 0), ("info", 1)])
def test_fail_on(runner, fail_on, code):
    """An axis that is left out is a warning."""
    found = lint(runner, {NAME: AXIS}, fail_on=fail_on, args="--select FRM007")
    assert found[0] == code
    assert found[1]["findings"] == "1"


def test_options_are_words_as_in_a_shell(runner):
    """With quotes, and nothing that a shell would do besides."""
    args = (
        """--select INE003 --exclude 'no, such' --per-file-ignores "$(touch x):INE003" `touch x`"""
    )
    code, outputs = lint(runner, args=args.replace(" `touch x`", ""))
    assert (code, outputs["findings"]) == (1, "1")
    assert lint(runner, args=args)[0] == 2
    assert lint(runner, args="--select 'INE003")[0] == 2
    assert "::error title=kinlint::The input args cannot be read: ValueError" in runner.log
    assert not (runner.workspace / "x").exists()


def test_sources_are_paths_by_lines(runner):
    """Whatever characters they have; none is an option, and none a command."""
    names = ["one two.urdf", "--fix.urdf", "$(touch x).urdf"]
    code, outputs = lint(runner, dict.fromkeys(names, BAD), src="\r\n".join(["", *names, ""]))
    assert (code, outputs["findings"]) == (1, "6")
    assert not (runner.workspace / "x").exists()
    assert lint(runner, {"sub/a.urdf": GOOD}, src="sub")[1]["findings"] == "0"
    files = {"sub/a.urdf": GOOD, "b.urdf": BAD}
    assert lint(runner, files, src=" sub/a.urdf  b.urdf\n")[1]["findings"] == "2"
    assert lint(runner, src=".")[1]["findings"] == "10"


def test_without_annotations_the_log_has_lines(runner):
    """And the summary is there all the same."""
    lint(runner, annotations="false")
    assert f"{NAME}:2:" in runner.log
    assert "::error" not in runner.log
    assert "INE003" in runner.summary.read_text("utf-8")


def test_the_sarif_file_may_lie_anywhere(runner):
    """Its directory is made; a name that would forge outputs is refused."""
    _, outputs = lint(runner, sarif_file="out put/k.sarif")
    assert outputs["sarif-file"] == "out put/k.sarif"
    assert (runner.workspace / "out put/k.sarif").is_file()
    code, outputs = lint(runner, sarif_file="k.sarif\nfindings=0")
    assert (code, outputs["findings"]) == (2, "")


def test_an_input_that_is_empty_is_as_if_it_were_not_given(runner):
    """As where a workflow passes on what nobody said."""
    names = [name for name in ACTION["inputs"] if name != "version"]
    code, outputs = lint(runner, **{name.replace("-", "_"): "" for name in names})
    assert (code, outputs["findings"], outputs["sarif-file"]) == (1, "2", "kinlint.sarif")
    assert "::error" in runner.log


def test_a_sarif_file_that_cannot_be_is_no_finding(runner):
    """Exit code 2: a directory, or below a file."""
    (runner.workspace / "there").mkdir()
    assert lint(runner, sarif_file="there")[0] == 2
    assert lint(runner, sarif_file=f"{NAME}/k.sarif")[0] == 2
    assert list(runner.temporary.iterdir()) == []


def test_what_cannot_be_linted_is_no_finding(runner):
    """Exit code 2, as everywhere; what the last run wrote is not taken for an outcome."""
    lint(runner)
    code, outputs = lint(runner, src="missing.urdf")
    assert code == 2
    assert outputs["findings"] == "0"
    assert lint(runner, args="--slect UNI") == (
        2,
        {"findings": "", "sarif-file": "", "kinlint-version": __version__},
    )


PYTHON = """#!/bin/sh
case "$1 $2" in
"-m venv") mkdir -p "$3/bin" && cp "$0" "$3/bin/python" && cp "{bin}/kinlint" "$3/bin/kinlint" ;;
"-m pip") printf '%s\\n' "$@" > "{temporary}/pip" ;;
*) exec '{python}' "$@" ;;
esac
"""


def installed(runner, **inputs):
    """What pip is asked for; nothing is installed."""
    text = PYTHON.format(bin=runner.bin, temporary=runner.temporary, python=sys.executable)
    runner.install("python3", text)
    asked = runner.temporary / "pip"
    asked.unlink(missing_ok=True)
    code, outputs = runner.run(**{"fail_on": "none", **inputs})
    assert (code, outputs["kinlint-version"]) in {(0, __version__), (2, ""), (1, "")}
    return asked.read_text("utf-8").splitlines()[-1] if asked.exists() else None


def test_what_is_installed(runner):
    """The action's own checkout, or the release that is asked for or pinned."""
    (runner.workspace / "arm.urdf").write_text(GOOD, "utf-8")
    (runner.workspace / "re quirements.txt").write_text(
        "# kinlint==9\nmy-kinlint==8\nkinlint == 0.3.1\n", "utf-8"
    )
    (runner.workspace / "none.txt").write_text("ruff==1\n", "utf-8")
    assert installed(runner) == str(ROOT)
    assert installed(runner, version="v0.2.0") == "kinlint==0.2.0"
    assert installed(runner, version_file="re quirements.txt") == "kinlint==0.3.1"
    assert installed(runner, version_file="none.txt") is None
    assert installed(runner, version="1 --index-url=x") is None
    assert installed(runner, version="1;touch x") is None


def test_no_input_reaches_a_script_but_by_the_environment():
    """Expressions are pasted into scripts before the shell reads them."""
    for step in ACTION["runs"]["steps"]:
        assert "${{" not in step.get("run", "")
        assert step.get("shell", "bash") == "bash"


def test_actions_are_pinned_by_commits():
    """With the release in a comment, for people and for what updates it."""
    text = (ROOT / "action.yml").read_text("utf-8")
    used = re.findall(r"uses: (.*)", text)
    assert len(used) == 2
    for each in used:
        assert re.fullmatch(r"[\w/-]+@[0-9a-f]{40} # v\d+\.\d+\.\d+", each)


def test_sarif_is_uploaded_also_of_a_step_that_fails():
    """If that is asked for and there is some."""
    *_, upload = ACTION["runs"]["steps"]
    assert upload["if"].startswith("always() && inputs.upload-sarif == 'true' &&")
    assert upload["with"]["sarif_file"] == "${{ steps.lint.outputs.sarif-file }}"
