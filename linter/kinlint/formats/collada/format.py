"""The record of COLLADA (https://www.khronos.org/collada)."""

from __future__ import annotations

from kinlint.file_format import Format, Shape
from kinlint.vocabulary import COLLADA as NAMESPACE

COLLADA = Format(
    name="collada",
    title="COLLADA",
    suffixes=(".dae", ".zae"),
    shape=Shape.TREE,
    archive_suffixes=(".zae",),
    decoder="kinlint.formats.collada.archive",
    reader="kinlint.formats.collada.reader",
    editor="kinlint.formats.xml.editing.editor",
    fence="xml",
    namespace=NAMESPACE,
    roots=("COLLADA",),
    schema="formats/collada.ttl",
    block_comment=("<!--", "-->"),
    searched=False,
    robot_files="kinlint.formats.collada.robot_documents",
)
FORMATS = (COLLADA,)
"""Meshes and scenes are of this format, too, and there are many: content tells."""
