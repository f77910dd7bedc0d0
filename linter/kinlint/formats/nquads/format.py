"""The records of N-Triples and N-Quads (https://www.w3.org/TR/n-quads/)."""

from __future__ import annotations

from kinlint.file_format import Format, Shape

NTRIPLES = Format(
    name="ntriples",
    title="N-Triples",
    suffixes=(".nt",),
    shape=Shape.GRAPH,
    reader="kinlint.formats.nquads.reader",
    convertible=True,
    searched=False,
    appendable=True,
)
NQUADS = Format(
    name="nquads",
    title="N-Quads",
    suffixes=(".nq",),
    shape=Shape.GRAPH,
    reader="kinlint.formats.nquads.reader",
    searched=False,
    appendable=True,
)
FORMATS = (NTRIPLES, NQUADS)
