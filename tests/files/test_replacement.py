"""Whoever looks finds the old content or the new, never a part."""

import os
import random
import signal
import stat
import subprocess
import sys
import time
from contextlib import ExitStack
from pathlib import Path

import pytest

from kinlint.files.atomic_write import SLOTS, replacement

WRITER = """
import sys
from pathlib import Path
from kinlint.files.atomic_write import replacement
target, size = Path(sys.argv[1]), int(sys.argv[2])
print("ready", flush=True)
for letter in "ab" * 100_000:
    with replacement(target) as stream:
        for _ in range(size):
            stream.write(letter.encode() * 1000)
"""


@pytest.mark.slow
def test_a_killed_process_leaves_one_content_or_the_other(tmp_path):
    """At whatever moment it is killed."""
    target = tmp_path / "arm.urdf"
    target.write_bytes(b"a" * 200_000)
    draw = random.Random(4)  # noqa: S311
    for _ in range(12):
        writer = subprocess.Popen(
            [sys.executable, "-c", WRITER, str(target), "200"], stdout=subprocess.PIPE
        )
        assert writer.stdout.readline() == b"ready\n"
        time.sleep(draw.uniform(0, 0.05))
        writer.send_signal(signal.SIGKILL)
        writer.communicate()

        assert target.read_bytes() in (b"a" * 200_000, b"b" * 200_000)


def test_an_error_leaves_the_file_as_it_was(tmp_path):
    """And nothing beside it."""
    target = tmp_path / "arm.urdf"
    target.write_bytes(b"old")

    def interrupted():
        with replacement(target) as stream:
            stream.write(b"new")
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        interrupted()

    assert target.read_bytes() == b"old"
    assert [each.name for each in tmp_path.iterdir()] == ["arm.urdf"]


def test_mode_and_links_stay(tmp_path):
    """The file that a link names is replaced, not the link."""
    target = tmp_path / "arm.urdf"
    target.write_bytes(b"old")
    target.chmod(0o640)
    link = tmp_path / "link.urdf"
    link.symlink_to(target.name)
    with replacement(link) as stream:
        stream.write(b"new")

    assert (link.is_symlink(), target.read_bytes()) == (True, b"new")
    assert stat.S_IMODE(target.stat().st_mode) == 0o640


@pytest.mark.skipif(not Path("/dev/fd").exists(), reason="open files have no paths here")
def test_a_pipe_is_written_to(tmp_path):
    """By whatever path it has, such as that of standard output."""
    end, start = os.pipe()
    with os.fdopen(end, "rb") as reader:
        with os.fdopen(start, "wb"), replacement(Path(f"/dev/fd/{start}")) as stream:
            stream.write(b"said")
        assert reader.read() == b"said"


def test_what_a_killed_process_left_goes_with_the_next_replacement(tmp_path):
    """What another process is writing at the moment stays."""
    target = tmp_path / "arm.urdf"
    target.write_bytes(b"old")
    writer = subprocess.Popen(
        [sys.executable, "-c", WRITER.replace("for _", "sys.stdin.read(1)\n        for _"),
         str(target), "1"],
        stdin=subprocess.PIPE, stdout=subprocess.PIPE,
    )  # fmt: skip
    writer.stdout.readline()
    while len(list(tmp_path.iterdir())) == 1:
        time.sleep(0.01)
    for _ in range(2):
        with replacement(target) as stream:
            stream.write(b"new")
        assert len(list(tmp_path.iterdir())) == 2
    writer.kill()
    writer.communicate()
    assert len(list(tmp_path.iterdir())) == 2

    with replacement(target) as stream:
        stream.write(b"newer")

    assert {each.name: each.read_bytes() for each in tmp_path.iterdir()} == {"arm.urdf": b"newer"}


def test_other_hard_links_keep_the_old_content(tmp_path):
    """Of one file by two names, the one that is replaced changes."""
    target, other = tmp_path / "arm.urdf", tmp_path / "other.urdf"
    target.write_bytes(b"old")
    other.hardlink_to(target)
    with replacement(target) as stream:
        stream.write(b"new")

    assert (target.read_bytes(), other.read_bytes()) == (b"new", b"old")


def test_a_name_may_be_as_long_as_the_system_allows(tmp_path):
    """What is written first has a shorter one."""
    target = tmp_path / ("x" * 250 + ".urdf")
    with replacement(target) as stream:
        stream.write(b"new")

    assert target.read_bytes() == b"new"


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no limits of files here")
def test_a_full_disk_leaves_the_file_as_it_was(tmp_path):
    """A limit of the size of files stands for it."""
    target = tmp_path / "arm.urdf"
    target.write_bytes(b"a" * 2000)
    limited = f"import resource; resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))\n{WRITER}"
    limited = f"import signal; signal.signal(signal.SIGXFSZ, signal.SIG_IGN)\n{limited}"
    done = subprocess.run(
        [sys.executable, "-c", limited, str(target), "2"], capture_output=True, check=False
    )

    assert b"OSError" in done.stderr
    assert {each.name: each.read_bytes() for each in tmp_path.iterdir()} == {
        "arm.urdf": b"a" * 2000
    }


@pytest.mark.slow
def test_two_at_once_leave_one_content_or_the_other(tmp_path):
    """And nothing beside it."""
    target = tmp_path / "arm.urdf"
    target.write_bytes(b"a" * 200_000)
    code = WRITER.replace('"ab" * 100_000', '"ab" * 40')
    writers = [
        subprocess.Popen([sys.executable, "-c", code, str(target), "200"], stdout=subprocess.PIPE)
        for _ in range(2)
    ]
    while any(each.poll() is None for each in writers):
        assert target.read_bytes() in (b"a" * 200_000, b"b" * 200_000)
    for each in writers:
        each.communicate()
        assert each.returncode == 0

    assert [each.name for each in tmp_path.iterdir()] == ["arm.urdf"]


def test_no_look_at_the_directory_is_needed(tmp_path, monkeypatch):
    """Which may have thousands of files; what was left is found by its name."""
    target = tmp_path / "arm.urdf"
    with ExitStack() as held:
        for _ in range(SLOTS):
            held.enter_context(replacement(target)).write(b"new")
        left = {each.name: each.read_bytes() for each in tmp_path.iterdir()}
    assert len(left) == SLOTS
    for name, content in left.items():
        (tmp_path / name).write_bytes(content)

    def refuse(*_):
        raise AssertionError

    with monkeypatch.context() as patch:
        for name in ("scandir", "listdir"):
            patch.setattr(os, name, refuse)
        with replacement(target) as stream:
            stream.write(b"newer")
    assert {each.name: each.read_bytes() for each in tmp_path.iterdir()} == {"arm.urdf": b"newer"}


def test_more_at_once_than_there_are_names(tmp_path):
    """Nobody waits for another, who may be stopped."""
    target = tmp_path / "arm.urdf"
    with ExitStack() as held:
        for number in range(SLOTS + 3):
            held.enter_context(replacement(target)).write(b"%d" % number)
        assert len(list(tmp_path.iterdir())) == SLOTS + 3
    assert {each.name: each.read_bytes() for each in tmp_path.iterdir()} == {"arm.urdf": b"0"}


@pytest.mark.parametrize("kind", ["link", "directory", "pipe"])
def test_what_others_put_in_its_place_is_left(tmp_path, kind):
    """Whoever guesses the name of the new file gains nothing."""
    target, other = tmp_path / "arm.urdf", tmp_path / "other"
    other.write_bytes(b"mine")
    with replacement(target) as stream:
        (first,) = {each.name for each in tmp_path.iterdir()} - {"other"}
        stream.write(b"old")
    trap = tmp_path / first
    if kind == "link":
        trap.symlink_to(other)
    elif kind == "directory":
        trap.mkdir()
    elif hasattr(os, "mkfifo"):
        os.mkfifo(trap)
    with replacement(target) as stream:
        stream.write(b"new")

    assert (target.read_bytes(), other.read_bytes()) == (b"new", b"mine")
