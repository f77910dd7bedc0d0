"""Writes the tables of shapes/lifting/README.md: what the queries make, and what they leave out."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path

from kinlint.conversion.coverage import Coverage, Reason, format_coverage
from kinlint.engine.lifting_compiler import SHARED
from kinlint.formats.records import LIFTED
from kinlint.resources import data

PATH = "lifting/README.md"
"""Path of the page below shapes/."""

TABLES = "\n| query | what it makes |\n"
"""Beginning of the tables; what is above them is written by hand."""
NAMES = {each.name: each.title for each in LIFTED}


def readme() -> str:
    """Return the page: the text above the tables as it is, and all tables anew."""
    written = (data("shapes") / PATH).read_text(encoding="utf-8").partition(TABLES)[0]
    tables = (*_queries(SHARED), *(text for form in NAMES for text in _format(form)))
    return written + "".join(tables)


def _queries(directory: str) -> Iterator[str]:
    yield f"{TABLES}|---|---|\n"
    for file in sorted((data("shapes") / "lifting" / directory).glob("*.rq")):
        yield f"| `{file.stem}` | {_comment(file)} |\n"


def _format(form: str) -> Iterator[str]:
    yield f"\n## {NAMES[form]}\n"
    yield from _queries(form)
    known = format_coverage(form)
    yield "\n| lifted in part | when, or how |\n|---|---|\n"
    yield from _rows((one.why, [_place(one.path, one.attribute)]) for one in _partly(known))
    yield "\n| not lifted | why |\n|---|---|\n"
    yield from _rows(
        (reason.why, [_place(path[-2:], attribute)])
        for path, attribute in known.unlifted()
        if (reason := known.reason(path, attribute)) is not None
    )


def _partly(known: Coverage) -> Iterator[Reason]:
    return (one for one in reversed(known.reasons) if one.lifted == "part")


def _rows(entries: Iterable[tuple[str, list[str]]]) -> Iterator[str]:
    """Yield one row for each reason, with all it holds for."""
    grouped: dict[str, dict[str, None]] = {}
    for why, places in entries:
        grouped.setdefault(why, {}).update(dict.fromkeys(places))
    for why, found in grouped.items():
        yield f"| {', '.join(f'`{place}`' for place in found)} | {why} |\n"


def _place(path: tuple[str, ...], attribute: str) -> str:
    """An element by its tag and that of its parent; an attribute as XPath has it."""
    return "/".join(path) + (f"/@{attribute}" if attribute else "")


def _comment(file: Path) -> str:
    """Return the comment at the head of a query."""
    lines = file.read_text(encoding="utf-8").splitlines()
    head = []
    for line in lines:
        if not line.startswith("#"):
            break
        head.append(line.lstrip("# "))
    return re.sub(r"\|", "\\|", " ".join(head))


def main() -> None:
    """Write the file, or to the one that the command line names."""
    place = Path(sys.argv[1]) if len(sys.argv) > 1 else data("shapes") / PATH
    place.write_text(readme(), encoding="utf-8")


if __name__ == "__main__":
    main()
