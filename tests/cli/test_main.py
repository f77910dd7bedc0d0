"""Whatever happens, the command ends in a code and at most a line."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from kinlint import __version__
from kinlint.cli import commands
from kinlint.errors import RuleInvalid, UsageError


@pytest.mark.parametrize(
    "arguments",
    [["--version"], ["-V"], ["version"], ["check", "--version"], ["version", "--"]],
)
def test_the_version(kinlint, arguments):
    """By option and by command."""
    assert kinlint(*arguments) == (0, f"kinlint {__version__}\n", "")


@pytest.mark.parametrize(
    ("word", "message"),
    [
        ("-q", "unknown option '-q'; kinlint version --help lists them"),
        ("now", "unexpected argument 'now'"),
    ],
)
def test_the_version_takes_nothing(kinlint, word, message):
    """An option or argument is a mistake."""
    assert kinlint("version", word) == (2, "", f"kinlint: error: {message}\n")


def test_the_version_imports_nothing_slow():
    """Not even the parser of arguments."""
    program = (
        "import sys; from kinlint.cli.main import main; main(['--version']);"
        "print(*{'argparse', 'json', 'dataclasses', 'pyoxigraph', 'rdflib'} & set(sys.modules))"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], check=False, capture_output=True, text=True
    )

    assert done.stdout == f"kinlint {__version__}\n\n"


@pytest.mark.parametrize(
    ("error", "line"),
    [
        (UsageError("no such thing"), "kinlint: error: no such thing\n"),
        (RuleInvalid("a.ttl: no Turtle"), "kinlint: error: a.ttl: no Turtle\n"),
        (MemoryError(), "kinlint: error: out of memory\n"),
    ],
)
def test_what_kinlint_raises_is_one_line(kinlint, monkeypatch, error, line):
    """And exit code 2."""

    def run(_):
        raise error

    monkeypatch.setattr(commands, "run", run)

    assert kinlint("a.jsonld") == (2, "", line)


def test_what_nobody_foresaw_is_one_line_and_a_request(kinlint, monkeypatch):
    """No traceback, unless it is asked for."""

    def run(_):
        raise ZeroDivisionError("first\nsecond")

    monkeypatch.setattr(commands, "run", run)
    code, out, err = kinlint("a.jsonld")

    assert (code, out, err.count("\n")) == (2, "", 1)
    assert err.startswith("kinlint: error: ZeroDivisionError: first second (")
    assert "please report" in err

    monkeypatch.setenv("KINLINT_TRACEBACK", "1")
    with pytest.raises(ZeroDivisionError):
        kinlint("a.jsonld")


def test_an_interruption_is_quiet(kinlint, monkeypatch):
    """The code is the one that shells give."""

    def run(_):
        raise KeyboardInterrupt

    monkeypatch.setattr(commands, "run", run)

    assert kinlint("a.jsonld") == (130, "", "")


def test_a_reader_that_goes_away_is_no_error(write):
    """`kinlint --show-files | head -0`."""
    write("arm.jsonld")
    reading, writing = os.pipe()
    os.close(reading)
    done = subprocess.run(
        check=False,
        args=[sys.executable, "-m", "kinlint", "--show-files"],
        stdout=writing,
        stderr=subprocess.PIPE,
    )
    os.close(writing)

    assert (done.returncode, done.stderr) == (141, b"")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no device that is always full")
@pytest.mark.parametrize("arguments", [["--help"], ["--show-files"], ["rules"]])
def test_a_full_disk_is_no_error_of_kinlint(write, arguments):
    """One line says what happened."""
    write("arm.jsonld")
    with Path("/dev/full").open("wb") as full:
        done = subprocess.run(
            check=False,
            args=[sys.executable, "-m", "kinlint", *arguments],
            stdout=full,
            stderr=subprocess.PIPE,
        )

    assert done.returncode == 2
    assert done.stderr.startswith(b"kinlint: error: cannot write")
    assert done.stderr.endswith(b"No space left on device\n")
    assert done.stderr.count(b"\n") == 1


def test_closed_streams_are_no_error(write):
    """`kinlint --show-files >&- 2>&-`."""
    write("arm.jsonld")
    line = f"{sys.executable} -m kinlint --show-files >&- 2>&-"
    assert subprocess.run(["sh", "-c", line], check=False).returncode == 0


def test_names_that_cannot_be_printed_are_escaped(here):
    """Where the locale knows ASCII alone."""
    done = subprocess.run(
        check=False,
        args=[sys.executable, "-m", "kinlint", "grün.jsonld"],
        env={**os.environ, "PYTHONIOENCODING": "ascii", "PYTHONUTF8": "0"},
        cwd=here,
        capture_output=True,
    )

    assert done.returncode == 2
    assert b"gr\\u00fcn.jsonld: no such file" in done.stdout + done.stderr


def test_help_fits_on_one_screen_and_names_every_command(kinlint):
    """On standard output, and with success; the options are below `check`."""
    code, out, err = kinlint("--help")

    assert (code, err) == (0, "")
    for word in (*commands.COMMANDS, "--select", "--output FORMAT[=FILE]", "Exit code"):
        assert word in out
    assert len(out.splitlines()) <= 40
    assert max(map(len, out.splitlines())) <= 80
    assert kinlint("-h") == kinlint("help") == kinlint("arm.urdf", "--help") == (0, out, "")
    options = kinlint("check", "--help")
    assert kinlint("--help-all") == kinlint("help", "check") == kinlint("lint", "-h") == options
    assert "--new-from-merge-base REV" in options[1]
    assert "--sarif-output" not in options[1]


@pytest.mark.slow
def test_names_that_other_tools_have_for_commands_answer(kinlint, here):
    """Unless a file is called so."""
    assert kinlint("explain", "LIM001") == kinlint("rule", "LIM001")
    assert kinlint("list", "LIM001") == kinlint("rules", "LIM001")
    assert kinlint("lsp", "--help") == kinlint("server", "--help")
    (here / "arm.urdf").write_text('<robot name="arm"><link name="base"/></robot>')
    assert kinlint("fix", "arm.urdf") == kinlint("--fix", "arm.urdf")
    (here / "list").mkdir()
    assert "no robot models found in 'list'" in kinlint("list")[2]


@pytest.mark.parametrize("command", commands.COMMANDS)
def test_every_command_has_help(kinlint, command):
    """Of its own."""
    code, out, err = kinlint(command, "-h")

    assert (code, err) == (0, "")
    assert "usage: kinlint" in out
