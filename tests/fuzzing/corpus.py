"""The texts that mutations start from: the samples, and robots that others made where they are."""

from __future__ import annotations

import os
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SUFFIXES = {
    "jsonld": (".jsonld", ".json"),
    "turtle": (".ttl",),
    "urdf": (".urdf",),
    "xacro": (".xacro",),
    "srdf": (".srdf",),
    "sdf": (".sdf", ".world"),
    "yaml": (".yaml", ".yml"),
    "mjcf": (".mjcf", ".xml"),
    "collada": (".dae",),
    "usd": (".usda",),
}
"""Suffixes of the files that each format is fuzzed with."""
MARKS = {"mjcf": b"<mujoco"}
"""What files have of a format that shares its suffixes with others."""
LARGEST = 30_000
"""Maximum size of a file, in bytes."""
SMALL = 5_000
"""Size of a small file at most, in bytes: small ones show the same faults sooner."""


@cache
def corpus(form: str) -> tuple[tuple[str, bytes], ...]:
    """Return the names and contents of the files of the format called *form*, sorted by name."""
    data = Path(os.environ.get("KINLINT_DATA", ROOT.parent / "shared" / "data"))
    folders = [ROOT / "samples", data / "robots", data / "defects", data / "comp-rob2b"]
    paths = (path for folder in folders for path in folder.rglob("*") if path.is_file())
    wanted = (path for path in paths if path.name.lower().endswith(SUFFIXES[form]))
    read = ((path.name, path.read_bytes()) for path in wanted)
    mark = MARKS.get(form, b"")
    return tuple(sorted(each for each in read if mark in each[1] and 0 < len(each[1]) < LARGEST))


@cache
def small(form: str) -> tuple[tuple[str, bytes], ...]:
    """Return those of `corpus` that are small."""
    return tuple((name, data) for name, data in corpus(form) if len(data) < SMALL)
