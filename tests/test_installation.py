"""Digests of the installation are kept until one of its files changes."""

import json
import os
from pathlib import Path

import pytest

from kinlint import installation
from kinlint.installation import Installation


@pytest.fixture
def package(tmp_path, monkeypatch):
    """An installation of three files, in each of its places one."""
    place = tmp_path / "installed"
    for name in ("kinlint/module.py", "rules/rule.ttl", "shapes/shape.ttl"):
        file = place / name
        file.parent.mkdir(parents=True)
        file.write_text("one")
    monkeypatch.setattr(installation, "__file__", str(place / "kinlint" / "installation.py"))
    monkeypatch.setattr(installation.resources, "data", lambda name: place / name)
    monkeypatch.setattr(installation, "SETTLED", 0.0)
    return place


@pytest.fixture
def digest(tmp_path):
    """Return what a new process has as the digest of all contents, and whether it computed it."""

    def ask(name="all"):
        computed = []

        def make():
            computed.append(name)
            return "".join(Path(path).read_text("utf-8") for path, *_ in found.files)

        found = Installation()
        return found.digest(name, tmp_path / "cache", make), bool(computed)

    return ask


def test_a_digest_is_computed_once(package, digest):
    assert digest() == ("oneoneone", True)
    assert digest() == ("oneoneone", False)
    assert digest("other") == ("oneoneone", True)
    assert digest() == ("oneoneone", False)


@pytest.mark.parametrize("name", ["kinlint/module.py", "rules/rule.ttl", "shapes/shape.ttl"])
def test_a_digest_follows_every_change(package, digest, name):
    """Also one of the same size, with the time of modification set back."""
    digest()
    file = package / name
    before = file.stat()
    file.write_text("two")
    os.utime(file, ns=(before.st_atime_ns, before.st_mtime_ns))

    found, computed = digest()

    assert computed
    assert found.count("two") == 1


def test_files_that_come_and_go_are_changes(package, digest):
    digest()
    (package / "rules" / "more.ttl").write_text("more")
    assert digest() == ("onemoreoneone", True)
    (package / "rules" / "more.ttl").unlink()
    assert digest() == ("oneoneone", True)


def test_byte_code_is_no_change(package, digest):
    digest()
    (package / "kinlint" / "__pycache__").mkdir()
    (package / "kinlint" / "__pycache__" / "module.pyc").write_text("")
    assert digest() == ("oneoneone", False)


def test_what_just_changed_is_not_kept(package, digest, monkeypatch):
    """A clock that ticks slowly could hide the next change."""
    monkeypatch.setattr(installation, "SETTLED", 3600.0)
    assert digest()[1]
    assert digest()[1]


@pytest.mark.parametrize("text", ["", "[]", "{}", '{"stamp": "x"}', '{"digests": 1}', "\0"])
def test_what_is_not_kept_digests_is_passed_over(package, digest, tmp_path, text):
    digest()
    (kept,) = (tmp_path / "cache").iterdir()
    kept.write_text(text)
    assert digest() == ("oneoneone", True)
    assert json.loads(kept.read_text())["digests"] == {"all": "oneoneone"}


def test_installations_that_share_a_cache_do_not_drive_each_other_out(package, digest, monkeypatch):
    """As those of two virtual environments do."""
    digest()
    other = package / "elsewhere" / "installation.py"
    other.parent.mkdir()
    with monkeypatch.context() as patch:
        patch.setattr(installation, "__file__", str(other))
        assert digest()[1]

    assert not digest()[1]


@pytest.mark.skipif(not hasattr(os, "geteuid"), reason="files have no owner here")
def test_what_another_user_kept_is_not_believed(package, digest, monkeypatch):
    digest()
    monkeypatch.setattr(os, "geteuid", lambda: 4242)
    assert digest() == ("oneoneone", True)
