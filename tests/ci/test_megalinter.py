"""The descriptor for MegaLinter, held to what its published schema says of the keys it uses."""

import jsonschema
import pytest
import yaml
from ci_robots import BAD
from workflow import ROOT

from kinlint.cli.check_options import parser
from kinlint.cli.main import main

DESCRIPTOR = yaml.safe_load(
    (ROOT / ".github/mega-linter-plugin-kinlint/kinlint.megalinter-descriptor.yml").read_text(
        "utf-8"
    )
)
TEXT = {"type": "string", "minLength": 1}
TEXTS = {"type": "array", "items": TEXT, "minItems": 1}
LINTER = {
    "type": "object",
    "additionalProperties": False,
    "required": ["linter_name", "linter_url", "examples"],
    "properties": {
        "name": TEXT,
        "linter_name": TEXT,
        "linter_url": {**TEXT, "pattern": "^https://"},
        "config_file_name": TEXT,
        "cli_config_arg_name": TEXT,
        "cli_lint_mode": {"enum": ["file", "project", "list_of_files"]},
        "cli_lint_extra_args": TEXTS,
        "cli_lint_fix_arg_name": TEXT,
        "cli_help_arg_name": TEXT,
        "cli_version_arg_name": TEXT,
        "can_output_sarif": {"type": "boolean"},
        "cli_sarif_args": TEXTS,
        "examples": TEXTS,
    },
}
SCHEMA = {
    "type": "object",
    "additionalProperties": False,
    "required": ["descriptor_id", "descriptor_type", "linters"],
    "properties": {
        "descriptor_id": {**TEXT, "pattern": "^[A-Z]+$"},
        "descriptor_type": {"enum": ["language", "format", "tooling_format", "other"]},
        "descriptor_flavors": {"type": "array", "items": {"enum": ["all_flavors", "python"]}},
        "file_extensions": {"type": "array", "items": {"type": "string", "pattern": r"^\.\w+$"}},
        "install": {
            "type": "object",
            "additionalProperties": False,
            "properties": {"pip": TEXTS},
        },
        "linters": {"type": "array", "items": LINTER, "minItems": 1},
    },
}


def test_it_is_valid():
    """Required keys are there, others known."""
    jsonschema.validate(DESCRIPTOR, SCHEMA)


@pytest.mark.parametrize("sarif", [False, True])
def test_its_command_lines_run(tmp_path, rules_cache, monkeypatch, capsys, sarif):
    """Put together as MegaLinter does: extra arguments, configuration, files."""
    (linter,) = DESCRIPTOR["linters"]
    monkeypatch.chdir(tmp_path)
    (tmp_path / "arm one.urdf").write_text(BAD, "utf-8")
    (tmp_path / linter["config_file_name"]).write_text('ignore = ["INE001"]', "utf-8")
    out = str(tmp_path / "k.sarif")
    more = [text.replace("{{SARIF_OUTPUT_FILE}}", out) for text in linter["cli_sarif_args"]]
    words = [
        *linter["cli_lint_extra_args"],
        *(more if sarif else []),
        linter["cli_config_arg_name"],
        str(tmp_path / linter["config_file_name"]),
        "arm one.urdf",
    ]
    assert main(words) == 1
    assert ("INE003" in capsys.readouterr().out) is not sarif
    assert (tmp_path / "k.sarif").exists() is sarif


def test_its_arguments_are_options():
    """Those for fixing, help and the version."""
    (linter,) = DESCRIPTOR["linters"]
    known = parser()._option_string_actions
    for name in ("fix", "help", "version"):
        key = "cli_lint_fix_arg_name" if name == "fix" else f"cli_{name}_arg_name"
        assert linter[key] in known
