"""The workflows and hooks that the documents show."""

import re
from textwrap import dedent

import pytest
import yaml
from workflow import ACTION, ROOT

HOOKS = yaml.safe_load((ROOT / ".pre-commit-hooks.yaml").read_text("utf-8"))
FENCE = re.compile(r"^( *)```yaml\n(.*?)^\1```", re.DOTALL | re.MULTILINE)


def shown(name):
    """The YAML of a document."""
    text = (ROOT / name).read_text("utf-8")
    return [yaml.safe_load(dedent(body)) for _, body in FENCE.findall(text)]


def test_hooks_that_are_shown_are_there():
    """In a list of repositories, whole or to be pasted into one."""
    pages = ("README.md", "linter/kinlint/reporters/README.md")
    listed = [
        one if isinstance(one, list) else one.get("repos", [])
        for name in pages
        for one in shown(name)
    ]
    used = [
        hook["id"] for repositories in listed for each in repositories for hook in each["hooks"]
    ]
    assert used == ["kinlint", "kinlint"]
    table = (ROOT / "linter/kinlint/reporters/README.md").read_text("utf-8")
    for hook in HOOKS:
        assert f"| `{hook['id']}` |" in table


def test_inputs_that_are_shown_are_there():
    """In the workflow and in the table."""
    workflows = [one for one in shown("linter/kinlint/reporters/README.md") if "steps" in one]
    (used,) = (step["with"] for one in workflows for step in one["steps"] if "src" in step["with"])
    assert used.keys() <= ACTION["inputs"].keys()
    text = (ROOT / "linter/kinlint/reporters/README.md").read_text("utf-8")
    section = text.partition("## GitHub Actions\n")[2].partition("\n## ")[0]
    rows = re.findall(r"^\| (`.*?) \|", section, re.MULTILINE)
    assert {name for row in rows for name in re.findall(r"`([\w-]+)`", row)} == set(
        ACTION["inputs"]
    )
    for name in ACTION["outputs"]:
        assert f"`{name}`" in section


@pytest.mark.parametrize("name", ["action.yml", ".pre-commit-hooks.yaml"])
def test_descriptions_are_sentences(name):
    """GitHub and pre-commit show them."""
    said = yaml.safe_load((ROOT / name).read_text("utf-8"))
    things = said if isinstance(said, list) else [said, *said["inputs"].values()]
    for each in things:
        assert each["description"].endswith(".")
