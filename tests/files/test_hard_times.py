"""Fixes where files cannot be written, are written by others, or are more than plain files."""

from __future__ import annotations

import ctypes
import os
import stat
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from support.fixable_files import FILES
from support.linting import book

from kinlint.cli import fix_files
from kinlint.cli.main import main

pytestmark = pytest.mark.usefixtures("rules_cache")
OPTIONS = ("--unsafe-fixes", "--isolated", "--no-cache", "--output-format", "concise")
forked = pytest.mark.skipif(not hasattr(os, "fork"), reason="processes cannot be forked here")
each_format = pytest.mark.parametrize("form", FILES)
CAPABILITIES = 0x20080522
"""Version of the structures of capget(2)."""


@pytest.fixture(scope="module", autouse=True)
def rules():
    """Load the rules before processes are forked, which need not do so again."""
    book()


@pytest.fixture
def arm(form, tmp_path, monkeypatch):
    """A file that can be fixed, in the working directory."""
    monkeypatch.chdir(tmp_path)
    path = tmp_path / f"arm.{form}"
    path.write_text(FILES[form], "utf-8")
    return path


def fix(*names: str) -> int:
    return main(["--fix", *OPTIONS, *names])


def in_child(act: Callable[[], int]) -> tuple[int, int]:
    """Return the process that does *act*, and the end of a pipe that has what it says."""
    reader, writer = os.pipe()
    child = os.fork()
    if child:
        os.close(writer)
        return child, reader
    try:
        sys.stdout = sys.stderr = os.fdopen(writer, "w")  # capsys has the other ones
        code = act()
        sys.stdout.flush()
        os._exit(code)
    finally:
        os._exit(70)


def ended(child: int, reader: int) -> tuple[int, str]:
    """Return the exit code of a process, and what it said."""
    with os.fdopen(reader) as stream:
        said = stream.read()
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), said


def obey_modes() -> bool:
    """Let modes hold for this process, though it be the superuser's; tell whether they do."""
    if os.geteuid():
        return True
    if not sys.platform.startswith("linux"):
        return False
    system = ctypes.CDLL(None, use_errno=True)
    header = (ctypes.c_uint32 * 2)(CAPABILITIES, 0)
    data = (ctypes.c_uint32 * 6)()
    if system.capget(header, data):
        return False
    for at in (0, 1, 3, 4):  # Effective and permitted, of which the first word has the bits.
        data[at] &= ~0b110 if at < 3 else ~0
    return system.capset(header, data) == 0


def contents(directory: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in directory.iterdir()}


@forked
@each_format
def test_a_read_only_directory(arm):
    """The file is named, and stays as it is."""

    def act() -> int:
        return fix(arm.name) if obey_modes() else 71

    before = contents(arm.parent)
    arm.parent.chmod(0o555)
    try:
        code, said = ended(*in_child(act))
    finally:
        arm.parent.chmod(0o755)
    if code == 71:
        pytest.skip("nothing keeps the superuser from writing here")
    assert (code, contents(arm.parent)) == (2, before)
    assert f"{arm.name}:1:1: error: not fixed: Permission denied" in said


@forked
@each_format
def test_a_full_disk(arm):
    """A limit of the size of files stands for it."""

    def act() -> int:
        import resource  # noqa: PLC0415  not on every system
        import signal  # noqa: PLC0415

        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100))
        return fix(arm.name)

    before = contents(arm.parent)
    code, said = ended(*in_child(act))
    assert (code, contents(arm.parent)) == (2, before)
    assert f"{arm.name}:1:1: error: not fixed: File too large" in said


@each_format
def test_a_file_that_others_change_meanwhile(arm, monkeypatch, capsys):
    """Between reading and writing; what they wrote stays."""
    rounds = fix_files.fix_in_rounds
    theirs = arm.read_bytes() + b"\n"

    def meanwhile(*given, **more):
        outcome = rounds(*given, **more)
        arm.write_bytes(theirs)
        return outcome

    monkeypatch.setattr(fix_files, "fix_in_rounds", meanwhile)
    assert fix(arm.name) == 2
    assert contents(arm.parent) == {arm.name: theirs}
    assert f"{arm.name}:1:1: error: not fixed: the file has changed" in "".join(capsys.readouterr())


@each_format
def test_a_file_that_others_remove_meanwhile(arm, monkeypatch, capsys):
    rounds = fix_files.fix_in_rounds

    def meanwhile(*given, **more):
        outcome = rounds(*given, **more)
        arm.unlink()
        return outcome

    monkeypatch.setattr(fix_files, "fix_in_rounds", meanwhile)
    assert fix(arm.name) == 2
    assert contents(arm.parent) == {}
    assert f"{arm.name}:1:1: error: not fixed: No such file" in "".join(capsys.readouterr())


@pytest.mark.slow
@forked
def test_two_at_once(tmp_path, monkeypatch):
    """Each file is fixed once, and nothing is left beside it."""
    monkeypatch.chdir(tmp_path)
    names = [f"arm.{form}" for form in FILES]
    found = []
    for processes in (1, 2, 3):
        for form in FILES:
            (tmp_path / f"arm.{form}").write_text(FILES[form], "utf-8")
        children = [in_child(lambda: fix(*names)) for _ in range(processes)]
        assert {ended(*child)[0] for child in children} <= {0, 1, 2}
        found.append(contents(tmp_path))
    assert found[0] == found[1] == found[2]
    assert all(found[0][f"arm.{form}"] != FILES[form].encode() for form in FILES)


@each_format
def test_links_and_modes(arm):
    """A symbolic link stays one, a hard link keeps the old content, a mode holds."""
    arm.chmod(0o640)
    before = arm.read_bytes()
    link = arm.with_name(f"link{arm.suffix}")
    link.symlink_to(arm.name)
    directory = arm.with_name("held")
    directory.mkdir()
    (directory / "copy").hardlink_to(arm)
    fix(link.name)

    assert link.is_symlink()
    assert arm.read_bytes() != before
    assert (directory / "copy").read_bytes() == before
    assert stat.S_IMODE(arm.stat().st_mode) == 0o640
    assert sorted(each.name for each in arm.parent.iterdir()) == sorted(
        (arm.name, "held", link.name)
    )


@pytest.mark.skipif(not hasattr(os, "chown"), reason="files have no owners here")
@each_format
def test_the_owner_stays(arm):
    """Whoever runs kinlint, such as the superuser of a container."""
    try:
        os.chown(arm, 12345, 12345)
    except PermissionError:
        pytest.skip("only the superuser gives files away")
    before = arm.read_bytes()
    fix(arm.name)
    found = arm.stat()
    assert (found.st_uid, found.st_gid) == (12345, 12345)
    assert arm.read_bytes() != before


@pytest.mark.slow
@pytest.mark.parametrize("mark", [b"", b"\xef\xbb\xbf"], ids=["plain", "marked"])
@each_format
def test_line_ends_and_marks(arm, mark):
    """Every line keeps its own end, and a byte order mark its place."""
    plain = arm.read_bytes()
    fix(arm.name)
    lines = arm.read_bytes().split(b"\n")
    before = plain.split(b"\n")
    assert len(lines) == len(before)
    ends = [b"\r\n" if number % 2 else b"\n" for number in range(len(before) - 1)] + [b""]

    arm.write_bytes(mark + b"".join(map(bytes.__add__, before, ends)))
    fix(arm.name)
    assert arm.read_bytes() == mark + b"".join(map(bytes.__add__, lines, ends))
