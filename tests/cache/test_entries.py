"""A directory of texts by key, in which nothing is trusted that is not whole and ours."""

import os
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor

import pytest

from kinlint.cache.directory_store import ABANDONED, DirectoryStore

TEXT = "a text\n\u00e4 \U0001f916"


@pytest.fixture
def entries(tmp_path):
    return DirectoryStore(tmp_path / "deep" / "reports")


def _file(entries):
    (file,) = entries.folder.iterdir()
    return file


def test_what_is_put_is_there(entries):
    """Also if it is put again; nothing else is."""
    assert entries.get("a") is None
    entries.put("a", "old")
    entries.put("a", TEXT)
    assert entries.get("a") == TEXT
    assert entries.get("b") is None


@pytest.mark.parametrize("damage", ["cut", "changed", "empty", "binary", "directory"])
def test_what_is_damaged_is_not_there(entries, damage):
    """However it was damaged."""
    entries.put("a", TEXT)
    file = _file(entries)
    data = file.read_bytes()
    if damage == "directory":
        file.unlink()
        file.mkdir()
    else:
        changed = {"cut": data[:-1], "changed": data[:-1] + b"x", "empty": b"", "binary": b"\xff\0"}
        file.write_bytes(changed[damage])
    assert entries.get("a") is None
    entries.put("b", TEXT)
    assert entries.get("b") == TEXT


def test_an_entry_passes_for_no_other(entries):
    """Whole as it is."""
    entries.put("a", TEXT)
    (entries.folder / "report-b.json").write_bytes(_file(entries).read_bytes())
    assert (entries.get("a"), entries.get("b")) == (TEXT, None)


@pytest.mark.skipif(not hasattr(os, "geteuid"), reason="files have no owners here")
def test_what_others_wrote_is_not_there(entries, monkeypatch):
    """Whole as it may be."""
    entries.put("a", TEXT)
    monkeypatch.setattr(os, "geteuid", lambda: 12345)
    assert entries.get("a") is None


def test_a_cache_that_cannot_be_written_does_no_harm(tmp_path):
    """It keeps nothing."""
    (tmp_path / "file").touch()
    entries = DirectoryStore(tmp_path / "file" / "reports")
    entries.put("a", TEXT)
    entries.bound()
    assert entries.get("a") is None
    assert entries.clear() == (0, 0)


def test_the_oldest_go_first(entries):
    """What was asked for is young again."""
    for number in range(10):
        entries.put(str(number), "x" * 1000)
        os.utime(entries.folder / f"report-{number}.json", (number, number))
    assert entries.get("0") is not None
    entries.bound(most=8000)
    left = [number for number in range(10) if entries.get(str(number)) is not None]
    assert left == [0, *range(10 - len(left) + 1, 10)]
    assert 0 < len(left) < 8


def test_what_nobody_finished_goes(entries):
    """Once it is sure that nobody is at it."""
    entries.put("a", TEXT)
    for name in ("old", "new"):
        (entries.folder / f"report-{name}.tmp").touch()
    long_ago = time.time() - 2 * ABANDONED
    os.utime(entries.folder / "report-old.tmp", (long_ago, long_ago))
    entries.bound()
    assert sorted(each.name for each in entries.folder.iterdir()) == [
        "report-a.json",
        "report-new.tmp",
    ]


def test_many_at_once(entries):
    """Whoever reads finds one of the texts, or none."""
    texts = [str(number) * 10_000 for number in range(8)]

    def work(number):
        for _ in range(30):
            entries.put("a", texts[number])
            assert entries.get("a") in (*texts, None)
            entries.bound(most=100)

    with ThreadPoolExecutor(8) as pool:
        list(pool.map(work, range(8)))


def test_who_is_killed_leaves_nothing_half(entries):
    """At whatever moment."""
    code = (
        "import sys; from pathlib import Path\n"
        "from kinlint.cache.directory_store import DirectoryStore\n"
        "entries = DirectoryStore(Path(sys.argv[1])); print(flush=True)\n"
        "while True: entries.put('a', 'x' * 3_000_000)\n"
    )
    for _ in range(3):
        run = subprocess.Popen(
            [sys.executable, "-c", code, str(entries.folder)], stdout=subprocess.PIPE
        )
        run.stdout.readline()
        while entries.get("a") is None:
            pass
        run.kill()
        run.communicate()
        assert entries.get("a") == "x" * 3_000_000


def test_only_what_is_ours_is_cleared(entries):
    """Others may have put something there."""
    entries.put("a", TEXT)
    (entries.folder / "mine.txt").touch()
    assert entries.clear()[0] == 1
    assert [each.name for each in entries.folder.iterdir()] == ["mine.txt"]
