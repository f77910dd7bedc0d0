"""The page that tells what is not lifted, and why, is fresh."""

from __future__ import annotations

from kinlint.conversion.coverage import format_coverage
from kinlint.conversion.coverage_page import PATH, main, readme
from kinlint.formats.records import LIFTED
from kinlint.resources import data

FORMATS = [each.name for each in LIFTED]


def test_reasons_say_how_much_is_lifted():
    assert {one.lifted for form in FORMATS for one in format_coverage(form).reasons} == {
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
