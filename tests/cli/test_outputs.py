"""Files of reports are complete or not there."""

import os
import stat
from pathlib import Path

import pytest

from kinlint.cli.output_files import replacing
from kinlint.configuration.keys import OUTPUT_FORMATS
from kinlint.errors import UsageError


def test_a_file_is_replaced_once_it_is_complete(here):
    """Until then the old one stands, and nothing is left behind after a failure."""
    target = here / "out.txt"
    target.write_text("old", "utf-8")

    with pytest.raises(ZeroDivisionError), replacing(target) as stream:
        1 / stream.write("")
    assert target.read_text("utf-8") == "old"

    with replacing(target) as stream:
        stream.write("nü\n")
        assert target.read_text("utf-8") == "old"
    assert target.read_bytes() == "nü\n".encode()
    assert [path.name for path in here.iterdir()] == ["out.txt"]


def test_modes_are_kept(here):
    """Those of an existing file, else what the process allows."""
    target = here / "out.txt"
    target.write_text("", "utf-8")
    target.chmod(0o640)
    umask = os.umask(0o027)
    try:
        for name in ("out.txt", "new.txt"):
            with replacing(here / name) as stream:
                stream.write("x")
    finally:
        os.umask(umask)

    modes = [stat.S_IMODE((here / name).stat().st_mode) for name in ("out.txt", "new.txt")]
    assert modes == [0o640, 0o640]


def test_links_stay_links(here):
    """What they lead to is replaced."""
    (here / "link.txt").symlink_to("out.txt")

    with replacing(here / "link.txt") as stream:
        stream.write("x")

    assert (here / "link.txt").is_symlink()
    assert (here / "out.txt").read_text("utf-8") == "x"


def test_devices_are_written_to():
    """They are not replaced by files."""
    with replacing(Path(os.devnull)) as stream:
        stream.write("x")

    assert not Path(os.devnull).is_file()


def test_a_directory_is_no_output(here):
    """An error for users."""
    with pytest.raises(UsageError, match=r"cannot write .*: Is a directory"), replacing(here):
        pass


@pytest.mark.slow
def test_all_formats_can_be_written_in_one_run(kinlint, write, here):
    """Each copy is what the format alone writes; standard output has the main one."""
    write("arm, 1.urdf", '<robot name="arm"><link name="a"/><link name="a"/></robot>')
    write("broken.urdf", '<!DOCTYPE robot [<!ENTITY a "b">]><robot name="&a;"/>')
    copies = [f"--{name}-output={here / name}.out" for name in OUTPUT_FORMATS]
    code, out, _ = kinlint(".", "--output-format", "concise", "-q", *copies)
    assert code == 2
    for name in OUTPUT_FORMATS:
        alone = here / "alone.out"
        assert kinlint(".", "--output-format", name, "-q", "-o", alone)[0] == 2
        assert (here / f"{name}.out").read_bytes() == alone.read_bytes()
        assert b"broken.urdf" in alone.read_bytes()
    assert (here / "concise.out").read_text("utf-8") == out
