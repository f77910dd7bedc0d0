"""Tells in shapes/lifting/README.md what the lifting queries make, and what they leave out."""

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

HEAD = """\
# Lifting

Each `FORMAT/NAME.rq` is a SPARQL CONSTRUCT query that makes a part of the composable model of the
paper out of what a file in an XML format says: bodies, frames and poses, joints with their axes,
limits on what drives them, inertias, couplings, references to shapes. What the documentation of
the format implies stands in the query and is explicit in the result: metres, kilograms and
radians, the frames that numbers are seen by, turns about fixed axes, the values of what is not
written. Every node says by `src:from` which element it comes from, and the patterns that bind a
value say which attribute it was read from (`kinlint.engine.provenance`). What a reader works out
itself, such as the direction of an axis in SDF, and from what, is listed in `worked-out.tsv`.

What formats share is written once. A query of a format may be a *reading*: it makes records of the
intermediate vocabulary (`ir:`, below), each with one value at most for a property, and each value
as it is read from one attribute or as its default. A query in `shared` makes parts of the
composable model of such records, whatever format they are read from. No record is ever stored: the
WHERE of the reading takes the place of the record when queries are loaded
(`kinlint.engine.unfolding`). Prefixes are those of `../prefixes.ttl` and need no declaration.

`kinlint` runs the queries that its rules need, `kinlint convert` all of them. A query starts from
the elements and never searches for a name; it resolves a reference by building its IRI. An element
`{doc}#/link/base` is the body `{doc}#link/base`, whose frame is `{doc}#link/base/frame`. Where a
value is malformed, nothing is made that would need it. Of an element that may stand once the first
counts.

`left-out.tsv` has the reasons. The tables are made by `python -m kinlint.conversion.coverage_page`
from it, from the queries and from what the format knows (`../formats`).
"""

NAMES = {each.name: each.title for each in LIFTED}


RECORDS = """
- `ir:Body`, called as the body, has a frame of its own.
- `ir:Frame`, called as the frame, has its origin at the point `ir:origin`.
- `ir:AttachedFrame`, called as the frame, is on `ir:body`.
- `ir:Placement`, called as the pose: `ir:frame` is on `ir:base` at `ir:x` `ir:y` `ir:z`, in metres.
  If it is on the body `ir:carrier` by that alone, its origin may be the point `ir:centre`.
- `ir:EulerAngles`, called as the pose: it is turned by `ir:roll` `ir:pitch` `ir:yaw` about fixed
  axes, in the `ir:angle-unit`.
- `ir:Quaternion`, called as the pose: it is turned by `ir:qx` `ir:qy` `ir:qz` `ir:qw`.
- `ir:Inertia`, called as the body: `ir:mass` in kilograms, read from `ir:mass-from`; about the
  centre of mass `ir:ixx` `ir:iyy` `ir:izz` `ir:ixy` `ir:ixz` `ir:iyz` in kg m², `ir:moments-from`.
- `ir:Joint`, called as the joint, is of the class `ir:kind`, between the bodies that are named as
  `ir:parent` and `ir:child`; `ir:carrier` and `ir:rider` are these where it puts frames and vectors
  on them. It joins its own frame to `ir:child-frame`, which is on `ir:child-frame-on` if no other
  record says so, and `ir:coincides-with` that where it is at zero. Its axis, if it has one, is the
  vector `ir:axis` with `ir:axis-x` `ir:axis-y` `ir:axis-z`, read from `ir:axis-from`.
- `ir:Limits`, called as the joint, in newtons and metres if `ir:linear`, else in newton metres and
  radians: where `ir:range` bounds its position, `ir:lower` and `ir:upper`; where `ir:drive` bounds
  its drive, `ir:effort`, `ir:velocity` and `ir:acceleration`, each read from `ir:effort-from` and
  so on.
- `ir:Coupling`, called as the coupling: `ir:follower` is where `ir:leader` is, times
  `ir:multiplier`, plus `ir:offset` in metres if `ir:linear`, else in radians.
- `ir:Chain`, called as the chain, has a record for each `ir:joint`.
- `ir:Geometry`, called as the shape: what is of the class `ir:kind` is of `ir:body` and attached to
  `ir:frame`.
- `ir:Box` of the sizes `ir:x` `ir:y` `ir:z`, `ir:SolidOfRevolution` of the class `ir:kind` with
  `ir:radius` and `ir:length`, in metres, and `ir:Mesh` from the file `ir:filename`, scaled by
  `ir:x` `ir:y` `ir:z`, are called as the shape.
"""


def readme() -> str:
    """The whole file."""
    shared = ("\n## Shared by formats\n", RECORDS, *_queries(SHARED))
    return HEAD + "".join((*shared, *(text for form in NAMES for text in _format(form))))


def _queries(directory: str) -> Iterator[str]:
    yield "\n| query | what it makes |\n|---|---|\n"
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
