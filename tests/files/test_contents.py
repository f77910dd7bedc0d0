"""Files that others name are read only if they are regular, not too large and nobody's secret."""

import os

import pytest

from kinlint.files.bounded_read import Unreadable, contents, head


@pytest.fixture
def here(tmp_path):
    (tmp_path / "arm.xacro").write_text("<robot/>")
    return tmp_path


def reason(path, near, limit=100):
    with pytest.raises(Unreadable) as caught:
        contents(path, near, limit)
    return str(caught.value)


def test_a_regular_file_is_read(here):
    assert contents(here / "arm.xacro", here / "arm.xacro") == b"<robot/>"
    assert head(here / "arm.xacro", 6) == "<robot"


@pytest.mark.parametrize("name", ["/dev/zero", "/dev/stdin", "/", "pipe", "loop"])
def test_what_never_ends_or_is_no_file_is_not_read(here, name):
    os.mkfifo(here / "pipe")
    (here / "loop").symlink_to("loop")
    path = here / name
    assert reason(path, path)
    assert head(path, 10) is None


def test_size_is_bounded(here):
    assert "more than" in reason(here / "arm.xacro", here / "arm.xacro", 3)


def test_hidden_and_system_files_are_nobodys_business(here):
    (here / ".ssh").mkdir()
    (here / ".ssh" / "id").write_text("secret")
    for name in (".ssh/id", "/etc/passwd", "/proc/self/environ"):
        assert "none of the files" in reason(here / name, here / "arm.xacro")
