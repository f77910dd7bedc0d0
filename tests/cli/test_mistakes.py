"""Mistakes on the command line are told, with what was meant."""

import os

import pytest

from kinlint.cli.main import main


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--slect", "X"], "unknown option '--slect', did you mean '--select'?"),
        (["--slect=X"], "unknown option '--slect', did you mean '--select'?"),
        (["--zzzzzz"], "unknown option '--zzzzzz'"),
        (["-Z"], "unknown option '-Z'"),
        (["--select"], "--select: expected one argument"),
        (["--select", ""], "--select: expected a value, got ''"),
        (["--ignore", ","], "--ignore: expected a value, got ','"),
        (["--select", "XX"], "unknown rule selector 'XX'; kinlint rules lists them"),
        (["--outputformat", "json"], "did you mean '--output-format'?"),
        (["--json", "x"], "unknown option '--json', did you mean '--json-output'?"),
        (["--quiet=3"], "takes no value, but has '3'"),
        (["--rules", "armm"], "--rules: armm: no such file or directory"),
        (["--shapes", "kon.toml"], "no such file or directory, did you mean 'kin.toml'?"),
        (["--config", ""], "--config: expected a value, got ''"),
        (["--config", "."], "--config: '.' is neither a file nor KEY=VALUE"),
        (["--config", "kon.toml"], "neither a file nor KEY=VALUE, did you mean 'kin.toml'?"),
        (["--config", 'extend="k.toml"'], "extend is for configuration files"),
        (["--config", 'extra-contexts="no"'], "extra-contexts: no: no such file"),
        (["--output-format", "jsn"], "did you mean 'json'?"),
        (["--fail-on", "warn"], "did you mean 'warning'?"),
        (["--engine", "oxygraph"], "did you mean 'oxigraph'?"),
        (["--color", "alway"], "did you mean 'always'?"),
        (["--contexts", "ba7e6011"], "did you mean 'ba7e601'?"),
        (
            ["--select", "UNI0022"],
            "command line: unknown rule selector 'UNI0022', did you mean 'UN",
        ),
        (["--ignore", "mising-unit"], "did you mean 'missing-unit'?"),
        (["--warning", "uni001"], "did you mean 'UNI001'?"),
        (["--per-file-ignores", "*.jsonld:UNI01"], "command line: *.jsonld: unknown rule selector"),
        (["--per-file-ignores", "UNI001"], "expected GLOB:R, got 'UNI001'"),
        (["--config", "selct = []"], "--config: unknown key 'selct', did you mean 'select'?"),
        (["--config", "partial=yes"], "--config 'partial=yes': not TOML"),
        (["--config", "fail-onn=error"], "unknown key 'fail-onn', did you mean 'fail-on'?"),
        (["--config", "fail-on=eror"], "fail-on: 'eror' is not one of "),
        (["--output", "sarf=x"], "--output: 'sarf' is not one of "),
        (["--output", "json="], "--output json=: expected FORMAT or FORMAT=FILE"),
        (["--output", "json", "--output-format", "sarif"], "one format for standard output, not"),
        (["--config", "nowhere.toml"], "'nowhere.toml' is neither a file nor KEY=VALUE"),
        (["--config", "k.toml", "--isolated"], "exclude each other"),
        (["--config", "k.toml", "--config", "arm.jsonld"], "one may be given"),
    ],
)
def test_mistakes_are_told_with_a_suggestion(kinlint, model, write, arguments, message):
    """One line, exit code 2, nothing linted."""
    write("k.toml", "")
    write("kin.toml", "")
    code, out, err = kinlint("arm.jsonld", *arguments)

    assert (code, out) == (2, "")
    assert err.startswith("kinlint: error: ")
    assert err.count("\n") == 1
    assert message in err
    assert model.settings is None


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["chekc", "arm.jsonld"], "did you mean 'check'?"),
        (["ruel", "UNI002"], "did you mean 'rule'?"),
        (["-q", "rule", "UNI002"], "the command 'rule' comes first: kinlint rule ..."),
        (["arm.jsonl"], "did you mean 'arm.jsonld'?"),
    ],
)
def test_a_path_that_looks_like_a_command(kinlint, pipeline, write, arguments, message):
    """May be a slip of one."""
    write("arm.jsonld")
    code, out, err = kinlint(*arguments)

    assert code == 2
    assert message in out + err


def test_a_slip_of_a_command_is_told_in_one_line(kinlint, pipeline):
    """What follows is not looked for."""
    assert kinlint("ruel", "UNI002") == (
        2,
        "",
        "kinlint: error: 'ruel' is neither a command nor a path, did you mean 'rule'?\n",
    )
    assert pipeline.settings is None


def test_note_is_another_word_for_info(kinlint, model, write):
    """Where a severity is expected."""
    model.found = ["LIM009"]

    assert kinlint("--fail-on", "note")[0] == 1
    assert kinlint("--fail-on", "warning")[0] == 0
    write("kinlint.toml", 'fail-on = "note"\nseverity.UNI = "note"')
    assert kinlint()[0] == 1
    assert model.settings.default.choices[0].severity[0][1].label == "info"


@pytest.mark.skipif(os.name == "nt", reason="a directory in use cannot be removed here")
def test_a_working_directory_that_is_gone(tmp_path, capsys, monkeypatch):
    """It is told as that, not as a fault of kinlint."""
    (tmp_path / "gone").mkdir()
    monkeypatch.chdir(tmp_path / "gone")
    (tmp_path / "gone").rmdir()

    assert main(["--isolated"]) == 2
    assert "error: the working directory does not exist" in capsys.readouterr().err
