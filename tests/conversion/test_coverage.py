"""What is not lifted has a reason, and the page that tells it is fresh."""

from __future__ import annotations

import pytest

from kinlint.conversion.coverage import coverage
from kinlint.conversion.coverage_page import PATH, main, readme
from kinlint.formats.records import LIFTED
from kinlint.resources import data

FORMATS = [each.name for each in LIFTED]


@pytest.mark.parametrize("form", FORMATS)
def test_everything_that_is_left_out_has_a_reason(form):
    known = coverage(form)
    assert [each for each in known.left_out() if known.reason(*each) is None] == []


@pytest.mark.parametrize("form", FORMATS)
def test_every_reason_is_needed(form):
    known = coverage(form)
    used = {known.reason(*each) for each in known.left_out()}
    assert [one for one in known.reasons if one.lifted == "no" and one not in used] == []


def test_reasons_say_how_much_is_lifted():
    assert {one.lifted for form in FORMATS for one in coverage(form).reasons} == {
        "no",
        "part",
        "yes",
    }


def test_readme_is_fresh(tmp_path, monkeypatch):
    told = (data("shapes") / PATH).read_text(encoding="utf-8")
    assert told == readme(), "run python -m kinlint.conversion.coverage_page"
    monkeypatch.setattr("sys.argv", ["readme", str(tmp_path / "README.md")])
    main()
    assert (tmp_path / "README.md").read_text(encoding="utf-8") == told
