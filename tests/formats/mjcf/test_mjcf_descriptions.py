"""The elements of MJCF are those of the table of MuJoCo's schema.

The table lies where KINLINT_MJCF_DESCRIPTIONS says, or beside the data.
"""

from __future__ import annotations

import csv
import os
from pathlib import Path

import pytest
from mjcf_descriptions import elements

from kinlint.formats.xml.schema import schema
from kinlint.resources import data

HERE = Path(__file__).resolve()


def table() -> Path:
    """The table; the test is skipped where it is absent."""
    beside = HERE.parents[4] / "shared" / "reference" / "mjcf" / "schemas" / "mjcf.tsv"
    path = Path(os.environ.get("KINLINT_MJCF_DESCRIPTIONS", beside))
    if not path.exists():
        pytest.skip(f"no descriptions at {path}; set KINLINT_MJCF_DESCRIPTIONS to their table")
    return path


def test_the_file_is_what_the_script_makes_of_the_table() -> None:
    kept = data("shapes") / "formats" / "mjcf-elements.ttl"
    assert kept.read_text(encoding="utf-8") == elements(table())


def test_every_element_and_attribute_of_the_table_is_known() -> None:
    types = {
        (tag, name)
        for tag, each in schema("mjcf").types.items()
        for type_ in each
        for name in ("", *type_.attributes)
    }
    with table().open(encoding="utf-8", newline="") as text:
        rows = [row for row in csv.DictReader(text, delimiter="\t") if "(" not in row["element"]]
    assert len(rows) > 2_000
    for row in rows:
        assert (row["element"].rpartition("/")[2], row["attribute"]) in types, row


def test_what_is_added_is_added_to_what_is_described() -> None:
    files = [
        (data("shapes") / "formats" / name).read_text(encoding="utf-8")
        for name in ("mjcf.ttl", "mjcf-elements.ttl")
    ]
    added, known = (
        {line.split()[0] for line in text.splitlines() if line.startswith("mjcf:")}
        for text in files
    )
    assert added <= known
