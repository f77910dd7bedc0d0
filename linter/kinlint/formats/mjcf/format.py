"""The record of MJCF (https://mujoco.readthedocs.io/en/stable/XMLreference.html)."""

from __future__ import annotations

from kinlint.file_format import Format, Shape
from kinlint.vocabulary import MJCF as NAMESPACE

MJCF = Format(
    name="mjcf",
    title="MJCF",
    suffixes=(".mjcf",),
    shared_suffixes=(".xml",),
    shape=Shape.TREE,
    reader="kinlint.formats.mjcf.reader",
    editor="kinlint.formats.xml.editing.editor",
    fence="xml",
    namespace=NAMESPACE,
    roots=("mujoco", "mujocoinclude"),
    robot_path=("mujoco",),
    fixed_root=True,
    schema="formats/mjcf.ttl",
    block_comment=("<!--", "-->"),
    includes=True,
)
FORMATS = (MJCF,)
