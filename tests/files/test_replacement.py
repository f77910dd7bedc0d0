"""Whoever looks finds the old content or the new, never a part."""

import os
import random
import signal
import stat
import subprocess
import sys
import time
from pathlib import Path

import pytest

from kinlint.files.atomic_write import replacement

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
