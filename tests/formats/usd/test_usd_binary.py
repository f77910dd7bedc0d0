"""Crates and packages are read as the text that they stand for."""

from __future__ import annotations

import zipfile
from collections.abc import Mapping
from pathlib import Path

import pytest
from reading_usd import values
from test_usd_composition import stage_of
from usd_stages import ARM, layer, written

from kinlint.document import Document
from kinlint.errors import SourceError
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import decode, read
from kinlint.formats.usd import binary_layers

Sdf = pytest.importorskip("pxr.Sdf")
TEXT = layer(ARM, more='    defaultPrim = "arm"')


def document(path: Path) -> Document:
    return read(decode(str(path), path.read_bytes()), ReadOptions())


def packed(path: Path, members: Mapping[str, bytes], method: int = zipfile.ZIP_STORED) -> Path:
    """Write a package with *members* at *path*."""
    with zipfile.ZipFile(path, "w", method) as archive:
        for name, data in members.items():
            archive.writestr(name, data)
    return path


@pytest.fixture
def crate(tmp_path: Path) -> Path:
    """The arm as a crate."""
    text = tmp_path / "arm.usda"
    text.write_text(TEXT, "utf-8")
    Sdf.Layer.FindOrOpen(str(text)).Export(str(tmp_path / "arm.usdc"))
    return tmp_path / "arm.usdc"


@pytest.mark.parametrize("name", ["arm.usdc", "arm.usd"])
def test_a_crate_says_what_its_text_says(name: str, crate: Path) -> None:
    file = crate.with_name(name)
    file.write_bytes(crate.read_bytes())
    known = values(document(crate.with_name("arm.usda")), "mass")

    assert values(document(file), "mass") == known
    assert known


def test_text_is_known_by_its_beginning(tmp_path: Path) -> None:
    file = tmp_path / "arm.usd"
    file.write_text(TEXT, "utf-8")

    assert len(values(document(file), "rigidBody")) == 3


def test_the_first_member_of_a_package_is_its_root(crate: Path, tmp_path: Path) -> None:
    scene = layer('def "w" (\n    references = @./parts/arm.usdc@\n)\n{\n}').encode()
    package = packed(
        tmp_path / "cell.usdz", {"scene.usda": scene, "parts/arm.usdc": crate.read_bytes()}
    )

    assert len(values(document(package), "rigidBody")) == 3


@pytest.mark.slow
def test_a_member_of_a_package_can_be_referred_to(crate: Path, tmp_path: Path) -> None:
    packed(tmp_path / "cell.usdz", {"a.usda": b"#usda 1.0\n", "b.usdc": crate.read_bytes()})
    scene = layer('def "w" (\n    references = @cell.usdz[b.usdc]@\n)\n{\n}')
    root = written(tmp_path, {"scene.usda": scene})

    assert len(values(document(root), "rigidBody")) == 3
    assert len(stage_of(root).prims) > 3


def test_without_usd_core_one_line_says_what_is_missing(crate: Path, monkeypatch) -> None:
    monkeypatch.setattr(binary_layers, "find_spec", lambda _: None)
    scene = layer('def "w" (\n    references = @arm.usdc@\n)\n{\n}')
    root = written(crate.parent, {"scene.usda": scene})

    with pytest.raises(SourceError, match=r"pip install 'kinlint\[usd\]'"):
        document(crate)
    (reason,) = values(document(root), "reason").values()
    assert reason == (
        "arm.usdc is a binary layer of USD, which usd-core reads: pip install 'kinlint[usd]'"
    )


@pytest.mark.parametrize(
    "data",
    [
        b"PXR-USDC",
        b"PXR-USDC" + b"\xff" * 1_000,
        b"PK\x03\x04",
        b"PK\x03\x04" + b"\0" * 1_000,
        b"\0\1\2",
    ],
)
def test_broken_ones_are_refused(data: bytes, tmp_path: Path) -> None:
    for name in ("arm.usdc", "arm.usdz", "arm.usd"):
        with pytest.raises(SourceError) as refused:
            read(decode(str(tmp_path / name), data), ReadOptions())
        assert refused.value.line == 1


def test_a_package_is_not_unpacked(tmp_path: Path) -> None:
    """What is compressed is none: no bomb is ever made larger."""
    bomb = packed(tmp_path / "b.usdz", {"a.usda": b"#usda 1.0\n" * 10**6}, zipfile.ZIP_DEFLATED)

    with pytest.raises(SourceError, match="is compressed, which packages of USD are not"):
        document(bomb)


@pytest.mark.parametrize("path", ["../x.sh", "/etc/x", "..\\x", "a/../../x", "C:/x"])
def test_members_that_lead_out_are_refused(path: str, tmp_path: Path) -> None:
    package = packed(tmp_path / "a.usdz", {"a.usda": TEXT.encode(), path: b""})

    with pytest.raises(SourceError, match="leads out of the archive"):
        document(package)
