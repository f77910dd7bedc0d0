"""What repairs are told of, such as a name for a node without one, is judged by no rule."""

from pathlib import Path

import pytest

from kinlint.catalogue import rulebook
from kinlint.configuration.settings import Settings
from kinlint.lint import examine
from kinlint.text import SourceText

ROOT = Path(__file__).parents[2]
SAMPLES = ("anonymous-entity.jsonld", "dangling-reference.jsonld", "inverted-limit.jsonld")


@pytest.mark.slow
@pytest.mark.parametrize("name", SAMPLES)
def test_a_run_that_offers_fixes_finds_what_others_find(name, rules_cache):
    """Whatever is worked out for the fixes."""
    book = rulebook.load(cache=rules_cache)
    sources = [SourceText(name, (ROOT / "samples/broken" / name).read_text("utf-8"))]
    found = [
        [
            one.sort_key
            for one in examine(sources, [], Settings(), book, repairing=each).report.findings
        ]
        for each in (False, True)
    ]
    assert found[0] == found[1]
    assert found[0]
