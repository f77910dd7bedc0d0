"""The record of USD (https://openusd.org)."""

from __future__ import annotations

from kinlint.file_format import Format, Shape
from kinlint.vocabulary import USD as NAMESPACE

CRATE, PACKAGE = b"PXR-USDC", b"PK"
"""Beginnings of binary layers and of packages."""

USD = Format(
    name="usd",
    title="USD",
    suffixes=(".usda", ".usd", ".usdc", ".usdz"),
    shape=Shape.TREE,
    reader="kinlint.formats.usd.reader",
    signatures=(CRATE, PACKAGE),
    decoder="kinlint.formats.usd.binary_layers",
    editor="kinlint.formats.usd.editor",
    fence="usda",
    line_comments="kinlint.formats.usd.layer_comment_edit",
    namespace=NAMESPACE,
    schema="formats/usd.ttl",
    searched=False,
    robot_files="kinlint.formats.usd.robot_layers",
)
NEEDED = "a binary layer of USD, which usd-core reads: pip install 'kinlint[usd]'"
"""Clause about what is not read without the extra."""

FORMATS = (USD,)
"""Meshes and scenes are of this format, too, and there are many: content tells."""
