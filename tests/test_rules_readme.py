"""The pages in rules/ are what the rule files say."""

import re

import pytest

from kinlint.cli.main import main
from kinlint.resources import data

COMMAND = ("rule", "--all", "--output-directory")
CUT = 500 * 1024
"""Where GitHub cuts off what a README says, in bytes."""


def pages():
    """The pages of the index and of the families."""
    rules = data("rules")
    return [rules / "README.md", *sorted(rules.glob("*/README.md"))]


def anchors(page):
    """What a link to a section of *page* may end in."""
    headings = re.findall(r"(?m)^#+ (.+)$", page.read_text("utf-8"))
    return {re.sub(r"[^\w -]", "", one.lower()).replace(" ", "-") for one in headings}


def test_the_pages_of_the_rules_are_fresh(tmp_path):
    """If not: `kinlint rule --all --output-directory rules`."""
    assert main([*COMMAND, str(tmp_path)]) == 0
    made = {one.relative_to(tmp_path): one.read_text("utf-8") for one in tmp_path.rglob("*.md")}
    kept = {one.relative_to(data("rules")): one.read_text("utf-8") for one in pages()}

    assert kept == made, f"stale: kinlint {' '.join(COMMAND)} rules"


def test_every_rule_has_its_section():
    """In the page of its family, and the index leads there."""
    index = (data("rules") / "README.md").read_text("utf-8")

    for file in data("rules").glob("*/*.ttl"):
        page = (file.parent / "README.md").read_text("utf-8")
        assert re.search(rf"(?m)^## [A-Z]+\d+ {re.escape(file.stem)}$", page)
        assert f"[{file.stem}]({file.parent.name}/README.md#" in index


@pytest.mark.slow
def test_every_link_leads_somewhere():
    """To a section, or to a file."""
    for page in pages():
        links = re.findall(r"\]\(([^)]+)\)", page.read_text("utf-8"))
        assert links
        for link in links:
            name, _, anchor = link.partition("#")
            target = page.parent / name if name else page
            assert target.is_file()
            assert not anchor or anchor in anchors(target)


def test_no_page_is_cut_off():
    """All of it is shown where repositories are read."""
    assert max(one.stat().st_size for one in pages()) < CUT
