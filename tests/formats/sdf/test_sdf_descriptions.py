"""The elements of SDF are those that libsdformat describes, and what is added fits them.

The table of its descriptions lies where KINLINT_SDF_DESCRIPTIONS says, or beside the data.
"""

from __future__ import annotations

import csv
import os
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from pathlib import Path

import pytest
from reading_sdf import model
from sdf_descriptions import AGAIN, NO_DEFAULT, elements

from kinlint.formats.xml.element_types import ElementType
from kinlint.formats.xml.schema import schema
from kinlint.resources import data
from kinlint.terms import RDF_TYPE, iri
from kinlint.vocabulary import SRC

Row = Mapping[str, str]
HERE = Path(__file__).resolve()


def table() -> Path:
    """The table of descriptions; the test is skipped where it is absent."""
    beside = HERE.parents[4] / "shared" / "reference" / "sdf" / "schema.tsv"
    path = Path(os.environ.get("KINLINT_SDF_DESCRIPTIONS", beside))
    if not path.exists():
        pytest.skip(f"no descriptions at {path}; set KINLINT_SDF_DESCRIPTIONS to their table")
    return path


@cache
def described() -> Mapping[str, Sequence[Row]]:
    """The rows of each path."""
    found: dict[str, list[Row]] = defaultdict(list)
    with table().open(encoding="utf-8", newline="") as text:
        for row in csv.DictReader(text, delimiter="\t", quoting=csv.QUOTE_NONE):
            found[row["path"]].append(row)
    return found


def newest(rows: Sequence[Row]) -> Row:
    """The row of the newest version."""
    return max(
        rows, key=lambda row: max(int(each.split(".")[1]) for each in row["versions"].split())
    )


def typed() -> Iterator[tuple[str, ElementType]]:
    """Each described element with its type, found by its path."""
    for path in described():
        tags = path.split("/")
        if "@" in path or "*" in path or AGAIN in path:
            continue
        type_ = schema("sdf").roots[tags[0]]
        for tag in tags[1:]:
            type_ = type_.children[tag]
        yield path, type_


@pytest.mark.slow
def test_the_file_is_what_the_script_makes_of_the_descriptions() -> None:
    kept = data("shapes") / "formats" / "sdf-elements.ttl"
    assert kept.read_text(encoding="utf-8") == elements(table())


def test_what_is_added_is_added_to_what_is_described() -> None:
    files = [
        (data("shapes") / "formats" / name).read_text(encoding="utf-8")
        for name in ("sdf.ttl", "sdf-elements.ttl")
    ]
    added, known = (
        {line.split()[0] for line in text.splitlines() if line.startswith("sdf:")} for text in files
    )
    own = {line.split()[0] for line in files[0].splitlines() if " fmt:tag " in line}
    assert added - known == own == {"sdf:mesh-uri"}


def test_every_described_element_and_attribute_is_known() -> None:
    assert len(list(typed())) > 9_000
    types = dict(typed())
    for path in described():
        above, _, name = path.rpartition("/")
        if name.startswith("@"):
            assert name[1:] in types[above].attributes, path


def test_what_may_be_there_repeatedly_is_never_a_repetition() -> None:
    for path, type_ in typed():
        for tag in type_.once:
            rows = described().get(f"{path}/{tag}", described().get(f"{path}/{tag}{AGAIN}"))
            assert rows, path
            assert {row["required"] for row in rows} <= {"0", "1", "-1"}, path


def test_only_what_has_no_default_is_required() -> None:
    for path, type_ in typed():
        for tag in type_.requires:
            row = newest(described()[f"{path}/{tag}"])
            assert row["required"] in ("1", "+"), path
            assert row["default"] == NO_DEFAULT, path


def test_defaults_are_those_of_the_descriptions() -> None:
    count = 0
    for path, type_ in typed():
        for tag, default in type_.assumed.items():
            rows = described()[f"{path}/{tag}"]
            assert default in {row["default"] for row in rows}, (path, tag)
            count += 1
    assert count > 1_000


@pytest.mark.parametrize(
    "body",
    [
        '<link name="base"><gz:layer>1</gz:layer></link>',
        '<gz:priority>1</gz:priority><link name="base"/>',
        '<link name="base"><visual name="shell" gz:layer="1"><geometry/></visual></link>',
        '<plugin filename="a" name="b"><anything what="1"><else/></anything></plugin>',
    ],
)
def test_elements_with_a_namespace_and_those_of_plugins_are_left_to_their_readers(
    body: str,
) -> None:
    found = model(f"{body}", attributes=' xmlns:gz="http://gazebosim.org/schema"')
    kinds = {o for _, p, o in found.statements if p == RDF_TYPE}
    assert not kinds & {
        iri(f"{SRC}{name}") for name in ("UndeclaredElement", "UndeclaredAttribute")
    }
