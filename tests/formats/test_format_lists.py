"""What files of this repository list of formats is what their records say."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
import yaml

from kinlint.formats.records import BY_SUFFIX, FORMATS, SEARCHED

ROOT = Path(__file__).parents[2]
SEARCHED_FORMATS = [each for each in FORMATS if each.searched]
HOOKED_FORMATS = [each for each in FORMATS if each.searched or each.name in ("collada", "usd")]
"""Formats of changed files that hooks lint: directories are not searched for COLLADA and USD, as
most of their files are meshes, but a robot depends on those, too."""
HOOKED = {*SEARCHED, *(s for each in HOOKED_FORMATS if not each.searched for s in each.suffixes)}
"""Suffixes of these files."""
TITLES = ", ".join(each.title for each in HOOKED_FORMATS)
KNOWN_TO_EDITORS = ("yaml", "python")
UNKNOWN_TO_EDITORS = {
    suffix
    for each in HOOKED_FORMATS
    if each.fence not in KNOWN_TO_EDITORS
    for suffix in (each.suffixes if each.searched else each.suffixes[:1])
}
"""Suffixes for which editors have to be told a language; they know `.json`, `.ttl` and `.yaml`.

Of COLLADA and USD the first suffix is that of texts, the others are of archives and crates."""
NO_LANGUAGE = {".usda"}
"""Suffixes for which some editors have no language that they could be told."""

README = (ROOT / "linter" / "kinlint" / "server" / "README.md").read_text("utf-8")
EDITORS = README.split("\n## Editors\n")[1].split("\n## ")[0]
BLOCKS = re.findall(r"^```\w+\n(.*?)^```$", EDITORS, re.MULTILINE | re.DOTALL)
MEGALINTER = ".github/mega-linter-plugin-kinlint/kinlint.megalinter-descriptor.yml"


def parsed(name: str):
    return yaml.safe_load((ROOT / name).read_text("utf-8"))


def suffixes(text: str) -> set[str]:
    """The suffixes of formats that are words of *text*."""
    return {each for each in BY_SUFFIX if re.search(rf"(?<!\w){each[1:]}(?!\w)", text)}


@pytest.mark.parametrize("hook", parsed(".pre-commit-hooks.yaml"), ids=lambda hook: hook["id"])
def test_hooks_of_pre_commit(hook):
    """The pattern of files has each suffix that a search looks for, those of meshes, no other."""
    parts = re.fullmatch(r"\(\?i\)\(\\\.\((.*?)\)\|(.*)\)\$", hook["files"])
    dotted = [f".{each}" for each in parts[1].split("|")]
    found = [each.replace("\\.", ".") for each in (*dotted, *parts[2].split("|"))]
    assert sorted(found) == sorted(HOOKED)


def test_descriptor_of_megalinter():
    """Its extensions are the last parts of what a search looks for: MegaLinter knows no others."""
    last = {f".{each.rpartition('.')[2]}" for each in SEARCHED}
    assert sorted(parsed(MEGALINTER)["file_extensions"]) == sorted(last)


@pytest.mark.parametrize(
    "text",
    [parsed(".pre-commit-hooks.yaml")[0]["description"], parsed("action.yml")["description"]],
    ids=["pre-commit", "action"],
)
def test_descriptions_name_the_formats(text):
    """By their titles, in the order of the records."""
    assert f"({TITLES})" in text


@pytest.mark.parametrize("block", [each for each in BLOCKS if suffixes(each) - {".json"}])
def test_settings_of_editors(block):
    """Each that names files names those of all formats, but for Turtle, which editors know."""
    named = suffixes(block) - {".json", ".ttl", ".yaml", ".yml", ".usd"}
    assert named | NO_LANGUAGE == UNKNOWN_TO_EDITORS


def test_the_text_about_editors():
    """It names the suffixes that the settings are about."""
    (sentence,) = re.findall(r"Most editors do not know (.*?), so the", EDITORS, re.DOTALL)
    assert set(re.findall(r"`(\.\w+)`", sentence)) == UNKNOWN_TO_EDITORS


def test_readmes_name_all_formats():
    """The first paragraph those that are searched for, the table of formats all."""
    opening = (ROOT / "README.md").read_text("utf-8").split("\n\n")[1]
    assert [each.title for each in SEARCHED_FORMATS if each.title not in opening] == []
    table = (ROOT / "shapes" / "README.md").read_text("utf-8").split("| format | read |")[1]
    rows = [line.split("|")[1] for line in table.split("\n\n")[0].splitlines() if line]
    named = {name for row in rows for name in re.findall(r"[A-Za-z][\w-]*", row)}
    assert {each.title for each in FORMATS} <= named
