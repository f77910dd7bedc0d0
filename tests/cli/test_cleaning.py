"""`kinlint clean`, and the bar for those who wait."""

import io
import re
import sys

import pytest

from kinlint.cli.progress import PATIENCE, ProgressBar

ROBOT = '<robot name="r"><link name="a"/></robot>'


def test_what_earlier_runs_kept_goes(kinlint, write, here):
    """And nothing else; a second time there is nothing to remove."""
    write("r.urdf", ROBOT)
    cache = here / "a cache"
    (cache / "reports").mkdir(parents=True)
    (cache / "reports" / "report-1.json").write_text("x" * 2**20)
    (cache / "catalogue-1.jsonl").write_text("{}")
    mine = cache / "mine.json"
    mine.touch()
    code, out, err = kinlint("clean", "--cache-dir", cache)
    assert (code, err) == (0, "")
    assert out == f"Removed 1 report and 1 catalogue (1.0 MiB) from {cache}\n"
    assert list(cache.iterdir()) == [mine]
    mine.unlink()
    assert kinlint("clean", "--cache-dir", cache) == (0, f"Nothing to remove in {cache}\n", "")
    assert not cache.exists()
    assert kinlint("clean", "--cache-dir", cache)[0] == 0
    assert (here / "r.urdf").exists()


def test_the_cache_of_the_environment_is_meant(kinlint, here, monkeypatch):
    """As runs use it."""
    monkeypatch.setenv("KINLINT_CACHE_DIR", str(here / "c"))
    assert kinlint("clean") == (0, f"Nothing to remove in {here / 'c'}\n", "")


def test_what_cannot_be_removed_is_told(kinlint, here, monkeypatch):
    """In one line, with exit code 2."""
    (here / "c").mkdir()
    (here / "c" / "catalogue-1.jsonl").mkdir()
    code, out, err = kinlint("clean", "--cache-dir", here / "c")
    assert (code, out) == (2, "")
    assert "catalogue-1.jsonl" in err
    assert err.count("\n") == 1


class Terminal(io.StringIO):
    def isatty(self):
        return True


@pytest.fixture
def clock(monkeypatch):
    """A clock that stands still but for what a test adds."""
    now = [0.0]
    monkeypatch.setattr("kinlint.cli.progress.time.monotonic", lambda: now[0])
    monkeypatch.setenv("TERM", "xterm")
    return now


def test_a_bar_comes_late_and_goes(clock, monkeypatch):
    """After about a second; nothing of it is left on the screen."""
    monkeypatch.setattr(sys, "stderr", Terminal())
    with ProgressBar(10, wanted=True) as bar:
        assert list(bar.reading(range(10))) == list(range(10))
        assert sys.stderr.getvalue() == ""
        clock[0] += 2 * PATIENCE
        bar.advance(5)
        assert "75%" in sys.stderr.getvalue()
        bar.advance(5)
    assert sys.stderr.getvalue().rstrip().endswith("\x1b[2K")


def test_a_bar_says_what_is_done(clock, monkeypatch):
    monkeypatch.setattr(sys, "stderr", Terminal())
    with ProgressBar(2, wanted=True, title="Loading") as bar:
        clock[0] += 2 * PATIENCE
        bar.advance(1)
        assert "Loading" in sys.stderr.getvalue()
        bar.advance(1, "Asking for SRC003")
    assert "Asking for SRC003" in sys.stderr.getvalue()


@pytest.mark.parametrize("reason", ["unwanted", "no terminal", "dumb", "quick"])
def test_nobody_sees_a_bar_who_has_no_use_for_it(clock, monkeypatch, reason):
    """Who reads a file, asked for silence, or does not wait."""
    monkeypatch.setattr(sys, "stderr", io.StringIO() if reason == "no terminal" else Terminal())
    if reason == "dumb":
        monkeypatch.setenv("TERM", "dumb")
    with ProgressBar(10, wanted=reason != "unwanted") as bar:
        clock[0] += PATIENCE / 2 if reason == "quick" else 2 * PATIENCE
        for _ in range(20):
            bar.advance(1)
    assert sys.stderr.getvalue() == ""


@pytest.mark.parametrize(
    ("said", "color", "colored"),
    [("", "auto", True), ("1", "auto", False), ("", "never", False), ("1", "always", True)],
)
def test_colour_is_left_to_the_user(clock, monkeypatch, said, color, colored):
    """NO_COLOR and `--color` decide whether the bar has any."""
    monkeypatch.setenv("NO_COLOR", said)
    monkeypatch.setattr(sys, "stderr", Terminal())
    with ProgressBar(2, wanted=True, color=color) as bar:
        clock[0] += 2 * PATIENCE
        bar.advance(2)
    assert bool(re.search(r"\x1b\[[\d;]*m", sys.stderr.getvalue())) == colored
    assert "50%" in sys.stderr.getvalue()


@pytest.mark.parametrize(
    ("arguments", "wanted"),
    [((), True), (("-q",), False), (("-s",), False), (("--output-format", "json"), False)],
)
def test_a_bar_is_for_people_who_want_a_summary(kinlint, write, monkeypatch, arguments, wanted):
    """Not for programs, nor with `-q` and `-s`."""
    write("r.urdf", ROBOT)
    seen = []

    class Watched(ProgressBar):
        def __init__(self, files, *, wanted, color):
            seen.append((wanted, color))
            super().__init__(files, wanted=wanted, color=color)

    monkeypatch.setattr("kinlint.cli.lint_run.ProgressBar", Watched)
    kinlint("r.urdf", "--isolated", "--color", "never", *arguments)
    assert seen == [(wanted, "never")]
