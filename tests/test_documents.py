"""What README and CONTRIBUTING show is what happens."""

import re
import shlex
from pathlib import Path
from textwrap import dedent

import pytest
from data import locate_data

from kinlint.catalogue import rulebook
from kinlint.cli.commands import COMMANDS
from kinlint.cli.main import main
from kinlint.cli.options import parser
from kinlint.rule_testing import promises

ROOT = Path(__file__).parents[1]
FENCE = re.compile(r"^( *)```(\w*)\n(.*?)^\1```", re.DOTALL | re.MULTILINE)


def blocks(name, language):
    """The fenced blocks of a document in one language, without their indentation."""
    text = (ROOT / name).read_text("utf-8")
    return [dedent(body) for _, tongue, body in FENCE.findall(text) if tongue == language]


def test_the_readme_opens_with_what_is_found_in_the_tutorial(capsys, monkeypatch):
    """Each finding that it shows is one of today's, and the count is right."""
    monkeypatch.chdir(locate_data("comp-rob2b", "modelling-tutorial", "models"))
    shown = blocks("README.md", "")[0].splitlines()

    code = main([".", "--output-format", "concise", "--isolated"])
    lines = capsys.readouterr().out.splitlines()

    assert code == 1
    (found,) = (line for line in lines if line.startswith("Found "))
    assert found.startswith(shown[-1].removesuffix("."))
    assert [line for line in shown[:-2] if line not in lines] == []


def test_the_rule_that_contributing_walks_through_is_a_rule(tmp_path):
    """It keeps all the promises that a rule has to keep."""
    file = tmp_path / "space-in-identifier.ttl"
    file.write_text(blocks("CONTRIBUTING.md", "turtle")[0], "utf-8")
    book = rulebook.load([tmp_path])

    assert list(promises.failures(book.by_name["space-in-identifier"], book)) == []


@pytest.mark.parametrize("toml", blocks("linter/README.md", "toml"))
def test_the_configuration_that_the_program_shows_is_accepted(toml, tmp_path, monkeypatch, capsys):
    """Every key of the example is known, and every value of its kind."""
    (tmp_path / "pyproject.toml").write_text(toml, "utf-8")
    for folder in ("rules", "shapes", "contexts"):
        (tmp_path / folder).mkdir()
    (tmp_path / "shapes/gripper.ttl").write_text("")
    (tmp_path / "contexts/gripper.json").write_text('{"@context": {}}')
    model = ROOT / "samples/one-dof/chain.jsonld"
    (tmp_path / "arm.jsonld").write_bytes(model.read_bytes())
    monkeypatch.chdir(tmp_path)

    code = main(["--partial", "arm.jsonld"])

    assert (code, capsys.readouterr().err) == (0, "")


def commands(*names):
    """The commands of documents that lint, each once, without pipes and redirections."""
    lines = (line for name in names for block in blocks(name, "sh") for line in block.splitlines())
    for line in lines:
        words = shlex.split(line.partition(" | ")[0].partition(" < ")[0], comments=True)
        if words[:1] == ["kinlint"] and not set(words[1:2]) & set(COMMANDS):
            yield shlex.join(words)


@pytest.mark.parametrize("command", sorted(set(commands("README.md", "linter/README.md"))))
def test_the_options_that_documents_show_are_there(command):
    """A misspelled one would be refused."""
    assert parser().read(shlex.split(command)[1:])


def test_the_fix_that_the_program_shows_is_what_is_shown(monkeypatch, capsys):
    """Below its finding, in a sample."""
    (shown,) = (block for block in blocks("linter/README.md", "text") if "help: " in block)
    monkeypatch.chdir(ROOT / "samples" / "broken")

    main(["--isolated", "inverted-limit.jsonld"])

    assert shown in capsys.readouterr().out
