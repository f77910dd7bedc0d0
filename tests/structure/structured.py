"""The structures of small robots, for tests."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from support.linting import lint

from kinlint.report import Report
from kinlint.structure import Joint, Link, Structure

SAMPLES = Path(__file__).resolve().parents[2] / "samples"


def linted(texts: dict[str, str]) -> Report:
    """The report of *texts* by file name, with structures."""
    return lint(texts, drawn=True)


def structures(**texts: str) -> tuple[Structure, ...]:
    """The robots of *texts*, by file name with an underscore for the dot."""
    return linted({name.replace("_", "."): text for name, text in texts.items()}).structures


def urdf(*edges: str, links: Iterable[str] | None = None, name: str = "arm") -> str:
    """A robot of fixed joints, each written `parent>child`; a side may be left out."""
    pairs = [edge.partition(">")[::2] for edge in edges]
    every = dict.fromkeys(end for pair in pairs for end in pair if end)
    body = "".join(f'<link name="{each}"/>' for each in (every if links is None else links))
    for parent, child in pairs:
        ends = f'<parent link="{parent}"/>' * bool(parent) + f'<child link="{child}"/>' * bool(
            child
        )
        body += f'<joint name="{parent}-{child}" type="fixed">{ends}</joint>'
    return f'<robot name="{name}">{body}</robot>'


def sample(folder: str) -> Report:
    """The report of a folder or a file of samples/."""
    path = SAMPLES / folder
    files = [path] if path.is_file() else sorted(each for each in path.rglob("*.*ld"))
    names = {file: file.name if file == path else str(file.relative_to(path)) for file in files}
    return linted({names[file]: file.read_text("utf-8") for file in files})


def tree(structure: Structure) -> list[str]:
    """A line for each part, indented by depth; loops and absent links are marked."""
    return [
        "  " * step.depth
        + step.part.name
        + " closes" * (isinstance(step.part, Joint) and step.part.closes)
        + " absent" * (isinstance(step.part, Link) and step.part.absent)
        for step in structure.steps()
    ]
