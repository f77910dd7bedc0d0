"""Page of a feature matrix: a table with what each consumer makes of each feature of a robot."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.reporters.feature_matrix import FeatureMatrix, FeatureRow
from kinlint.reporters.picture.escape import element, text
from kinlint.reporters.summary import plural
from kinlint.targets.consumer import Cell, Feature

CSS = """
:root { color-scheme: light dark; font: 15px/1.45 system-ui, sans-serif }
body { margin: 2rem }
table { border-collapse: collapse }
caption { text-align: left; font-size: 1.3rem; font-weight: 600; padding-bottom: .6rem }
th, td { border: 1px solid #8886; padding: .3rem .5rem; vertical-align: top; text-align: left }
td { min-width: 7rem; font-size: .85rem }
thead th { position: sticky; top: 0; background: Canvas }
.error { background: #d3202033 }
.warning { background: #e0a00033 }
.info { background: #3080d022 }
.unknown { color: GrayText }
small { display: block; color: GrayText }
"""


def matrix_page(matrix: FeatureMatrix, names: str) -> Iterator[str]:
    """Yield the page of *matrix*, of the files *names*, piece by piece."""
    title = f"{names}: read alike?"
    yield '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
    yield (
        '<meta http-equiv="Content-Security-Policy" '
        "content=\"default-src 'none'; style-src 'unsafe-inline'\">\n"
    )
    yield f"<title>{text(title)}</title>\n<style>{CSS}</style>\n</head>\n<body>\n<main>\n<table>\n"
    yield element("caption", text(title)) + "\n<thead>\n<tr>"
    yield element("th", "feature", scope="col")
    yield "".join(element("th", text(each.text), scope="col") for each in matrix.targets)
    yield "</tr>\n</thead>\n<tbody>\n"
    for row in matrix.rows:
        yield f"<tr>{_heading(row)}{''.join(map(_cell, row.cells))}</tr>\n"
    yield "</tbody>\n</table>\n"
    told = f"{matrix.differing} of {plural(len(matrix.rows), 'feature')} read differently."
    told = f"{matrix.unread} {told}".lstrip()
    yield element("p", text(told)) + "\n</main>\n</body>\n</html>\n"


def _heading(row: FeatureRow) -> str:
    feature: Feature = row.feature
    places = f"{row.places[0]}{f' and {len(row.places) - 1} more' if row.places[1:] else ''}"
    said = text(feature.label) + "".join(
        element("small", text(each)) for each in (feature.comment, places, row.advice) if each
    )
    return element("th", said, scope="row")


def _cell(cell: Cell | None) -> str:
    if cell is None:
        return element("td", "not known", class_="unknown")
    sources = "".join(element("small", element("a", "source", href=each)) for each in cell.sources)
    measured = f"measured with {', '.join(cell.measured)}" if cell.measured else ""
    evidence = (element("small", text(measured)) if measured else "") + sources
    said = text(f"{cell.behaviour.mark} {cell.clause}")
    return element("td", said + evidence, class_=cell.severity.label if cell.severity else None)
