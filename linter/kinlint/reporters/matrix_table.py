"""Table of a feature matrix for terminals: a mark for what each consumer makes of each feature."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinlint.reporters.display_width import printable, width
from kinlint.reporters.feature_matrix import FeatureMatrix
from kinlint.reporters.summary import plural
from kinlint.reporters.terminal_style import Style
from kinlint.targets.consumer import Behaviour, Cell

UNKNOWN = "?"
"""Mark of what is not known."""
ASCII = {"✓": "+", "\u2013": "-", "→": ">", "≈": "~", "✗": "x", "†": "!"}
"""Marks for terminals without characters beyond ASCII."""
GAP = 2
"""Number of blanks between columns."""


def table(matrix: FeatureMatrix, style: Style, columns: int) -> Iterator[str]:
    """Yield the lines of *matrix* for a terminal of so many *columns*.

    Where the targets need more, they are divided into several tables.
    """
    if matrix.unread:
        yield f"{matrix.unread}\n"
    if not matrix.rows or not matrix.targets:
        yield "Nothing that consumers are known to read differently.\n" if matrix.targets else ""
        return
    labels = [
        printable(f"{row.feature.label} ({len(row.places)})", unicode=style.unicode)
        for row in matrix.rows
    ]
    first = max(map(width, labels))
    names = [target.text for target in matrix.targets]
    for start, end in _divided(names, columns - first):
        yield f"{'':{first}}{''.join(' ' * GAP + name for name in names[start:end])}\n"
        for label, row in zip(labels, matrix.rows, strict=True):
            marks = (
                f"{' ' * GAP}{_mark(cell, style):^{len(name)}}"
                for name, cell in zip(names[start:end], row.cells[start:end], strict=True)
            )
            yield f"{label}{' ' * (first - width(label))}{''.join(marks)}".rstrip() + "\n"
        yield "\n"
    yield from _legend(matrix, style)
    yield from _departures(matrix)
    total = len(matrix.rows)
    yield f"{matrix.differing} of {plural(total, 'feature')} read differently.\n"


def _divided(names: Sequence[str], room: int) -> Iterator[tuple[int, int]]:
    """Yield the beginning and the end of runs of *names* that fit into *room* characters."""
    start = used = 0
    for number, name in enumerate(names):
        if used and used + GAP + len(name) > room:
            yield start, number
            start, used = number, 0
        used += GAP + len(name)
    yield start, len(names)


def _mark(cell: Cell | None, style: Style) -> str:
    return UNKNOWN if cell is None else mark(cell.behaviour, style)


def mark(behaviour: Behaviour, style: Style) -> str:
    """Return the mark of *behaviour* for a terminal of *style*."""
    return behaviour.mark if style.unicode else ASCII.get(behaviour.mark, behaviour.mark)


def _legend(matrix: FeatureMatrix, style: Style) -> Iterator[str]:
    """Yield a line about the marks that *matrix* has."""
    known = {
        cell.behaviour.name: cell.behaviour for row in matrix.rows for cell in row.cells if cell
    }
    told = [f"{mark(each, style)} {each.label}" for _, each in sorted(known.items())]
    if any(cell is None for row in matrix.rows for cell in row.cells):
        told.append(f"{UNKNOWN} not known")
    yield f"{', '.join(told)}\n\n"


def _departures(matrix: FeatureMatrix) -> Iterator[str]:
    """Yield what becomes of each feature that consumers read differently."""
    for row in matrix.rows:
        if row.alike:
            continue
        yield f"{row.feature.label}, at {row.places[0]}:\n"
        clauses: dict[str, list[str]] = {}
        for target, cell in zip(matrix.targets, row.cells, strict=True):
            if cell is not None and cell.severity is not None:
                clauses.setdefault(cell.clause, []).append(target.text)
        for clause, names in clauses.items():
            yield f"  {', '.join(names)}: {clause}\n"
        if row.advice:
            yield f"  {row.advice}\n"
        yield "\n"
