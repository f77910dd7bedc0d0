"""The keys of a configuration, as `kinlint config` and the JSON schema tell them."""

import json
import tomllib
from pathlib import Path

import pytest
from jsonschema import Draft202012Validator

from kinlint.cli.main import main
from kinlint.configuration.json_schema import schema
from kinlint.configuration.keys import KEYS, check
from kinlint.errors import ConfigError

FILE = Path(__file__).parents[2] / "linter/kinlint.schema.json"


def valid(values):
    return Draft202012Validator(schema()).is_valid(values)


def accepted(values):
    try:
        check(values, "here")
    except ConfigError:
        return False
    return True


def test_it_is_a_schema():
    """Of the dialect that it names."""
    Draft202012Validator.check_schema(schema())


def test_the_file_is_what_the_command_prints(capsys):
    """`kinlint config --schema > linter/kinlint.schema.json` makes it."""
    assert main(["config", "--schema"]) == 0
    assert capsys.readouterr().out == FILE.read_text("utf-8")


@pytest.mark.parametrize("name", KEYS)
def test_examples_are_accepted(name):
    """By the tool and by the schema."""
    values = tomllib.loads(KEYS[name].example)
    assert list(values) == [name]
    assert accepted(values)
    assert valid(values)


@pytest.mark.parametrize("name", KEYS)
@pytest.mark.parametrize(
    "value", [True, 3, 1.5, "x", "note", "info", [], ["x"], [1], {}, {"x": "y"}, {"x": ["y"]},
              {"x": 1}, {"x": {"y": 1}}, {"x": {"y": []}}, {"x": "info"}]
)  # fmt: skip
def test_tool_and_schema_agree(name, value):
    """On values of every kind for every key."""
    assert valid({name: value}) is accepted({name: value})


def test_unknown_keys_are_refused():
    """By both."""
    assert not valid({"selekt": []})
    assert not accepted({"selekt": []})


@pytest.mark.parametrize("name", KEYS)
def test_a_key_is_told(name, capsys):
    """With type, default, meaning and example."""
    assert main(["config", name]) == 0
    out = capsys.readouterr().out
    for what in (name, KEYS[name].meaning, KEYS[name].kind.name, KEYS[name].default):
        assert what in out
    assert KEYS[name].example in out


def test_all_keys_are_told(capsys):
    """One a line."""
    assert main(["config"]) == 0
    assert [line.split()[0] for line in capsys.readouterr().out.splitlines()] == list(KEYS)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["selekt"], "unknown key 'selekt', did you mean 'select'?"),
        (["--schema", "select"], "--schema is about all keys"),
        (["--shema"], "unknown option '--shema', did you mean '--schema'?"),
    ],
)
def test_mistakes(arguments, said, capsys):
    """Exit code 2 and a suggestion."""
    assert main(["config", *arguments]) == 2
    assert said in capsys.readouterr().err


def test_the_schema_is_json():
    """And ends in a line end."""
    assert json.loads(FILE.read_text("utf-8"))["$id"].endswith("kinlint.schema.json")
