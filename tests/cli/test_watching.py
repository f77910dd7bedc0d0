"""`--watch`: what a user sees who saves files while it runs."""

import os
import queue
import re
import select
import signal
import subprocess
import sys
import threading

import pytest
from support.interrupts import accept_interrupts

from kinlint.cli.watch import CLEAR

ROBOT = '<robot name="{0}"><link name="a"/>{1}</robot>\n'
WAITING = "Watching for changes"
SOON = 90
"""Seconds after which nothing comes any more, on the slowest of machines."""
pytestmark = pytest.mark.skipif(os.name == "nt", reason="signals of POSIX")


class Session:
    """A watching process, whose rounds of output are taken one by one."""

    def __init__(self, *arguments):
        self.process = subprocess.Popen(
            [sys.executable, "-m", "kinlint", "--watch", *arguments],
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            bufsize=1,
            env={**os.environ, "PYTHONUNBUFFERED": "1", "KINLINT_TRACEBACK": "1"},
            preexec_fn=accept_interrupts,  # noqa: PLW1509  no other thread runs then
        )
        self.lines = queue.Queue()
        self.reader = threading.Thread(target=self._read, daemon=True)
        self.reader.start()

    def _read(self):
        for line in self.process.stdout:
            self.lines.put(line)
        self.lines.put(None)

    def round(self):
        """All that is said until it waits again."""
        said = []
        while (line := self.lines.get(timeout=SOON)) is not None:
            if WAITING in line:
                return "".join(said)
            said.append(line)
        raise AssertionError(f"it ended: {''.join(said)}")

    def until(self, text):
        """Rounds until one says *text*; that one. A save may come to two changes."""
        while text not in (said := self.round()):
            pass
        return said

    def end(self):
        """Its exit code after an interrupt, and what it says at last."""
        self.process.send_signal(signal.SIGINT)
        left = []
        while (line := self.lines.get(timeout=SOON)) is not None:
            left.append(line)
        return self.process.wait(SOON), "".join(left)


@pytest.fixture
def watching():
    begun = []

    def begin(*arguments):
        begun.append(Session(*arguments))
        return begun[-1]

    yield begin
    for each in begun:
        each.process.kill()
        each.process.wait(SOON)
        each.reader.join(SOON)
        each.process.stdout.close()


@pytest.mark.slow
def test_what_changes_is_linted_again(watching, write, here):
    """Files that change, come and go, what they include, and what governs them."""
    write("a.urdf", ROBOT.format("a", ""))
    session = watching(".", "--output-format", "concise")
    assert "All checks passed" in session.round()
    write("a.urdf", ROBOT.format("a", '<link name="a"/>'))
    assert "a.urdf:1" in session.until("error")
    write("kinlint.toml", 'select = ["UNI"]\n')
    session.until("All checks passed")
    write("kinlint.toml", "selct = 1\n")
    assert "did you mean 'select'?" in session.until("kinlint: error")
    (here / "kinlint.toml").unlink()
    session.until("a.urdf:1")
    write("deep/er/b.urdf", ROBOT.format("b", '<lnik name="c"/>'))
    session.until("b.urdf:1")
    (here / "a.urdf").rename(here / "gone.txt")
    assert "a.urdf" not in session.until("Found")
    (here / "deep/er/b.urdf").unlink()
    session.until("no robot models found")
    assert session.end() == (0, "")


@pytest.mark.slow
def test_rules_of_ones_own_and_what_governs_from_elsewhere(watching, write, tmp_path):
    """They need not lie where the models are."""
    write("project/models/a.urdf", ROBOT.format("a", '<link name="a"/>'))
    write("project/rules/none.ttl", "")
    models = str(tmp_path / "project/models")
    session = watching(models, "--output-format", "concise", "--rules", "project/rules")
    session.until("a.urdf:1")
    write("project/kinlint.toml", 'select = ["UNI"]\n')
    session.until("All checks passed")
    write("project/rules/none.ttl", "this is no Turtle")
    assert "none.ttl" in session.until("kinlint: error")
    assert session.end() == (0, "")


@pytest.mark.slow
def test_a_terminal_is_cleared_and_nothing_else(watching, write):
    """Who keeps the output wants all of it.

    Where no line can be taken back, no progress is shown, however long the run takes.
    """
    write("a.urdf", ROBOT.format("a", ""))
    assert "\x1b" not in watching("a.urdf").round()

    master, terminal = os.openpty()
    command = [sys.executable, "-m", "kinlint", "--watch", "a.urdf", "--color", "never"]
    dumb = os.environ | {"TERM": "dumb"}
    run = subprocess.Popen(
        command,
        stdout=terminal,
        stderr=terminal,
        stdin=terminal,
        env=dumb,
        preexec_fn=accept_interrupts,  # noqa: PLW1509  no other thread runs then
    )
    try:
        said = b""
        while WAITING.encode() not in said:
            assert select.select([master], [], [], SOON)[0]
            said += os.read(master, 4096)
        run.send_signal(signal.SIGINT)
        assert run.wait(SOON) == 0
    finally:
        run.kill()
        run.wait(SOON)
        os.close(terminal)
        os.close(master)
    assert said.startswith(CLEAR.encode())
    assert said.count(b"\x1b") == CLEAR.count("\x1b")


REFUSED = {
    ("-",): "standard input",
    ("--stdin-filename", "a.urdf"): "standard input",
    ("-o", "report.txt"): "--output-file",
    ("--sarif-output", "report.sarif"): "--sarif-output",
    ("--output-format", "json"): "for people",
    ("--fix",): "--fix",
    ("--show-files",): "--show-files",
}


@pytest.mark.parametrize("arguments", REFUSED)
def test_what_makes_sense_only_once_is_refused(kinlint, write, arguments):
    """In one line, before anything is read."""
    write("a.urdf", ROBOT.format("a", ""))
    code, out, err = kinlint("--watch", *arguments)
    assert (code, out) == (2, "")
    assert REFUSED[arguments] in err
    assert re.fullmatch(r"kinlint: error: [^\n]*\n", err)
