"""Mistakes on the command line are told, with what was meant."""

import pytest


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--slect", "X"], "unknown option '--slect', did you mean '--select'?"),
        (["--slect=X"], "unknown option '--slect', did you mean '--select'?"),
        (["--zzzzzz"], "unknown option '--zzzzzz'"),
        (["-Z"], "unknown option '-Z'"),
        (["--select"], "--select: expected one argument"),
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
        (["--config", "contexts=ba7e601"], 'a string needs quotes: contexts="ba7e601"'),
        (["--config", "nowhere.toml"], "'nowhere.toml' is neither a file nor KEY=VALUE"),
        (["--config", "k.toml", "--isolated"], "exclude each other"),
        (["--config", "k.toml", "--config", "arm.jsonld"], "one may be given"),
    ],
)
def test_mistakes_are_told_with_a_suggestion(kinlint, model, write, arguments, message):
    """One line, exit code 2, nothing linted."""
    write("k.toml", "")
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
