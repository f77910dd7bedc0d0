"""Real xacro files expand to what the xacro package alone makes of them, or say why they do not."""

from __future__ import annotations

import sys
from pathlib import Path
from types import ModuleType
from typing import Any
from xml.dom import minidom

import pytest
import xacro
from data import locate_data

from kinlint.files.packages import Packages
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import decode
from kinlint.formats.xacro.expanded_text import write
from kinlint.formats.xacro.expansion_session import Expansion, Session
from kinlint.formats.xacro.included_files import Pieces

FILES = 90
EXPANDED = 75
"""How many of the files stand for something by themselves; others miss files or arguments."""


@pytest.fixture(scope="module")
def home() -> Path:
    return locate_data("robots", "xacro")


@pytest.fixture(scope="module")
def packages(home: Path) -> Packages:
    """The packages among the data, whose manifests are not among them."""
    own = {each.name: each for each in home.iterdir()}
    moveit = {f"moveit_resources_{each.name}": each for each in own["moveit_resources"].iterdir()}
    return Packages({**own, **moveit}, environment={})


@pytest.fixture
def finding(packages: Packages, monkeypatch: pytest.MonkeyPatch) -> None:
    """The package finds ROS packages as we do."""
    index, inner = ModuleType("ament_index_python"), ModuleType("ament_index_python.packages")

    def share(name: str) -> str:
        found = packages.find(name, Path("/"))
        if found is None:
            raise KeyError(name)
        return str(found)

    inner.get_package_share_directory = share  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, index.__name__, index)
    monkeypatch.setitem(sys.modules, inner.__name__, inner)


def expand(path: Path, packages: Packages) -> tuple[Expansion, str]:
    pieces = Pieces(decode(str(path), path.read_bytes()), path, ReadOptions())
    expansion = Session(pieces, {}, packages).expand()
    return expansion, "" if expansion.fault else write(expansion.parsed, pieces).text


def content(element: Any) -> Any:
    """An element as plain values, without blanks around texts."""
    inside: list[Any] = []
    for child in element.childNodes:
        if child.nodeType == child.ELEMENT_NODE:
            inside.append(content(child))
        elif child.nodeType == child.COMMENT_NODE:
            inside.append(("comment", child.data))
        elif text := getattr(child, "data", "").strip():
            inside.append(text)
    return element.tagName, dict(element.attributes.items()), inside


@pytest.mark.slow
@pytest.mark.usefixtures("finding")
def test_expansions_are_those_of_xacro(home: Path, packages: Packages) -> None:
    files = sorted(home.rglob("*.xacro"))
    expanded = 0
    for path in files:
        expansion, text = expand(path, packages)
        try:
            expected = xacro.process_file(str(path), mappings={})
        except Exception:  # noqa: BLE001  of any kind
            assert expansion.fault is not None, path
            assert expansion.fault.reason
            assert expansion.fault.source[expansion.fault.span], path
            continue
        assert expansion.fault is None, (path, expansion.fault)
        own = minidom.parseString(text.encode())  # noqa: S318  our own text
        assert content(own.documentElement) == content(expected.documentElement), path
        expanded += 1
    assert (len(files), expanded) == (FILES, EXPANDED)


@pytest.mark.slow
def test_every_character_is_accounted_for(home: Path, packages: Packages) -> None:
    """What is marked as copied stands in the texts as it stands in the expansion."""
    for path in sorted(home.rglob("*.xacro")):
        pieces = Pieces(decode(str(path), path.read_bytes()), path, ReadOptions())
        expansion = Session(pieces, {}, packages).expand()
        if expansion.fault is not None:
            continue
        written = write(expansion.parsed, pieces)
        every = "\n".join(source.text for _, source in pieces.listed)
        ends = [*(leaf.at for leaf in written.leaves[1:]), len(written.text)]
        for leaf, end in zip(written.leaves, ends, strict=True):
            assert leaf.at < end
            if leaf.exact:
                assert every[leaf.start : leaf.end] == written.text[leaf.at : end]
