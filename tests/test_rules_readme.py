"""rules/README.md is what the rule files say."""

import re

from kinlint.cli.main import main
from kinlint.resources import data

COMMAND = ("rule", "--all", "--output-format", "markdown")


def test_the_readme_of_the_rules_is_fresh(capsys):
    """If not: `kinlint rule --all --output-format markdown > rules/README.md`."""
    assert main(COMMAND) == 0
    made = capsys.readouterr().out
    kept = (data("rules") / "README.md").read_text("utf-8")

    assert kept == made, f"stale: kinlint {' '.join(COMMAND)} > rules/README.md"


def test_every_link_in_the_readme_leads_somewhere():
    """To a section of it, or to a rule file."""
    text = (data("rules") / "README.md").read_text("utf-8")
    headings = re.findall(r"(?m)^#+ (.+)$", text)
    anchors = {re.sub(r"[^\w -]", "", one.lower()).replace(" ", "-") for one in headings}
    links = re.findall(r"\]\(([^)]+)\)", text)

    assert links
    for link in links:
        if link.startswith("#"):
            assert link[1:] in anchors
        else:
            assert (data("rules") / link).is_file()
