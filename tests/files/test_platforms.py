"""Paths and texts of Windows and macOS, as far as they can be tried anywhere."""

import unicodedata
from pathlib import PurePosixPath, PureWindowsPath

import pytest
from support.fixable_files import FILES

from kinlint.cli.main import main
from kinlint.files.pathglob import Glob

ROOT = PureWindowsPath("C:/robots/Arm")
NAME = "b\u00e9quille-\u00fc.urdf"


@pytest.mark.parametrize(
    ("pattern", "path", "covered"),
    [
        ("*.urdf", r"C:\robots\Arm\deep\arm.urdf", True),
        ("*.URDF", r"C:\robots\Arm\arm.urdf", True),
        ("legacy/*.urdf", r"c:\Robots\arm\Legacy\arm.urdf", True),
        ("legacy", r"C:\robots\Arm\legacy\arm.urdf", True),
        ("legacy/*.urdf", r"C:\robots\Arm\legacy\deep\arm.urdf", False),
        ("../hand/*.urdf", r"C:\robots\hand\hand.urdf", True),
        ("C:/robots/**/arm.urdf", r"C:\robots\Arm\a\b\arm.urdf", True),
        ("C:/robots/**/arm.urdf", r"D:\robots\Arm\a\b\arm.urdf", False),
        ("!*.urdf", r"C:\robots\Arm\arm.sdf", True),
    ],
)
def test_patterns_cover_paths_of_windows(pattern, path, covered):
    """Drives, backslashes, and letters of any size."""
    assert Glob(ROOT, pattern).covers(PureWindowsPath(path)) is covered


def test_large_and_small_letters_differ_elsewhere():
    """As they do in most file systems."""
    root = PurePosixPath("/robots")
    assert not Glob(root, "*.URDF").covers(root / "arm.urdf")
    assert not Glob(root, "Legacy/*").covers(root / "legacy" / "arm.urdf")


@pytest.mark.parametrize("written", ["NFC", "NFD"])
@pytest.mark.parametrize("found", ["NFC", "NFD"])
@pytest.mark.parametrize("pattern", ["{}", "m/{}", "m/b?quille-*.urdf"])
def test_composed_and_decomposed_names_are_the_same(pattern, written, found):
    """macOS gives names in form D that were typed in form C."""
    root = PurePosixPath("/robots")
    path = root / "m" / unicodedata.normalize(found, NAME)
    glob = Glob(root, unicodedata.normalize(written, pattern.format(NAME)))

    assert glob.covers(path)


@pytest.mark.parametrize("form", ["NFC", "NFD"])
def test_a_file_of_any_normal_form_is_read_and_ignored(
    form, tmp_path, rules_cache, monkeypatch, capsys
):
    """By the pattern of a configuration in the other form."""
    monkeypatch.chdir(tmp_path)
    name = unicodedata.normalize(form, NAME)
    (tmp_path / name).write_text(FILES["urdf"], "utf-8")
    assert main([name, "-q", "--isolated", "--output-format", "concise"]) == 1
    assert name in capsys.readouterr().out

    other = unicodedata.normalize("NFD" if form == "NFC" else "NFC", NAME)
    (tmp_path / "kinlint.toml").write_text(f'[per-file-ignores]\n"{other}" = ["ALL"]\n', "utf-8")
    assert main([name, "-q"]) == 0


@pytest.mark.slow
@pytest.mark.parametrize("form", FILES)
def test_fixes_keep_the_line_ends_of_windows(form, tmp_path, rules_cache, monkeypatch):
    """Every other byte, too: the text is that of other systems with other line ends."""
    monkeypatch.chdir(tmp_path)
    fixed = []
    for end in ("\n", "\r\n"):
        (tmp_path / f"arm.{form}").write_bytes(FILES[form].replace("\n", end).encode())
        main([f"arm.{form}", "--fix", "--unsafe-fixes", "--silent", "--isolated", "--no-cache"])
        fixed.append((tmp_path / f"arm.{form}").read_bytes())

    assert fixed[0] != FILES[form].encode()
    assert fixed[1] == fixed[0].replace(b"\n", b"\r\n")
