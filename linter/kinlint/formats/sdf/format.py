"""The record of SDFormat (http://sdformat.org/spec)."""

from __future__ import annotations

from kinlint.file_format import Format, Shape
from kinlint.vocabulary import SDF as NAMESPACE

SDF = Format(
    name="sdf",
    title="SDF",
    suffixes=(".sdf", ".world"),
    shape=Shape.TREE,
    reader="kinlint.formats.sdf.reader",
    editor="kinlint.formats.xml.editing.editor",
    fence="xml",
    namespace=NAMESPACE,
    roots=("sdf",),
    robot_path=("sdf", "model"),
    schema="formats/sdf.ttl",
    block_comment=("<!--", "-->"),
    includes=True,
)
FORMATS = (SDF,)
