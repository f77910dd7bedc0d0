"""What `kinlint check` says, in which form and where."""

import json

import pytest

from kinlint import __version__
from kinlint.errors import SourceError


def test_suppressed_findings_are_shown_on_request(kinlint, pipeline, write):
    """They never decide the exit code."""
    write("arm.jsonld")
    pipeline.suppressed = ["UNI002"]

    code, out, _ = kinlint("arm.jsonld", "--output-format", "concise")
    assert (code, "UNI002" in out) == (0, False)
    code, out, _ = kinlint("arm.jsonld", "--output-format", "concise", "--show-suppressed")
    assert (code, "UNI002" in out) == (0, True)


def test_machine_formats_have_standard_output_for_themselves(kinlint, pipeline, write):
    """What cannot be read is told on standard error."""
    write("arm.jsonld")
    pipeline.found = ["UNI002"]
    pipeline.errors = [SourceError("leg.jsonld", "empty", 1, 1)]
    code, out, err = kinlint("arm.jsonld", "--output-format", "json")

    assert code == 2
    assert [one["code"] for one in json.loads(out)] == ["UNI002", None]
    assert err.startswith("kinlint: error: leg.jsonld:1:1: empty\nFound 1 error")
    assert kinlint("arm.jsonld", "--output-format", "json", "-q")[2].count("\n") == 1


def test_the_format_comes_from_option_environment_or_configuration(
    kinlint, pipeline, write, monkeypatch
):
    """In this order."""
    write("arm.jsonld")
    write("kinlint.toml", 'output-format = "json-lines"')
    pipeline.found = ["UNI002"]

    assert kinlint()[1].startswith("{")
    monkeypatch.setenv("KINLINT_OUTPUT_FORMAT", "github")
    assert kinlint()[1].startswith("::")
    assert kinlint("--output-format", "json")[1].startswith("[")
    monkeypatch.setenv("KINLINT_OUTPUT_FORMAT", "githb")
    assert "KINLINT_OUTPUT_FORMAT: 'githb' is not one of" in kinlint()[2]


def test_the_output_file(kinlint, pipeline, write, here, monkeypatch):
    """From option or environment; standard output stays empty."""
    write("arm.jsonld")
    pipeline.found = ["UNI002"]

    code, out, _ = kinlint("-o", "out.json", "--output-format", "json")
    assert (code, out) == (1, "")
    assert json.loads((here / "out.json").read_text("utf-8"))[0]["code"] == "UNI002"

    monkeypatch.setenv("KINLINT_OUTPUT_FILE", "env.txt")
    assert kinlint()[1] == ""
    assert "UNI002" in (here / "env.txt").read_text("utf-8")


def test_copies_beside_standard_output(kinlint, pipeline, write, here):
    """In as many formats as there are; also when nothing is said aloud."""
    write("arm.jsonld")
    pipeline.found = ["UNI002"]
    names = ("full", "concise", "json", "json-lines", "sarif", "github")
    options = [f"--{name}-output={name}.out" for name in names]
    _, out, _ = kinlint("arm.jsonld", *options)

    assert "UNI002" in out
    for name in names:
        assert "UNI002" in (here / f"{name}.out").read_text("utf-8")

    (here / "json.out").unlink()
    assert kinlint("arm.jsonld", "-s", "--json-output=json.out")[1:] == ("", "")
    assert (here / "json.out").exists()


def test_one_option_names_formats_and_files(kinlint, pipeline, write, here):
    """Without a file it is the format of standard output."""
    write("arm.jsonld")
    pipeline.found = ["UNI002"]
    _, out, _ = kinlint("arm.jsonld", "--output", "json", "--output=sarif=a.sarif", "-q")

    assert [one["code"] for one in json.loads(out)] == ["UNI002"]
    assert json.loads((here / "a.sarif").read_text("utf-8"))["runs"]
    assert kinlint("arm.jsonld", "--output", "json=-", "-q")[1] == out


def test_values_of_configuration_need_no_quotes(kinlint, pipeline, write):
    """Where the kind of the key tells what they are."""
    write("arm.jsonld")
    pipeline.found = ["UNI001"]

    assert kinlint("arm.jsonld", "--config", "fail-on=error")[0] == 0
    assert kinlint("arm.jsonld", "--config", 'fail-on="error"')[0] == 0
    assert kinlint("arm.jsonld", "--config", "output-format = json")[1].startswith("[")
    assert kinlint("--show-settings", "--config", "select=UNI,LD001")[0] == 0


def test_an_output_that_cannot_be_written(kinlint, pipeline, write):
    """One line, exit code 2."""
    write("arm.jsonld")
    code, _, err = kinlint("arm.jsonld", "-o", "no/where.txt")

    assert code == 2
    assert err.endswith(": --output-file: cannot write no/where.txt: there is no directory no\n")


def test_statistics(kinlint, pipeline, write):
    """A table instead of the findings; beside a machine's format on standard error."""
    write("arm.jsonld")
    pipeline.found = ["UNI002", "UNI002", "UNI001"]

    code, out, _ = kinlint("arm.jsonld", "--statistics")
    assert code == 1
    assert out.splitlines()[0].split()[:2] == ["2", "UNI002"]
    assert "arm.jsonld" not in out
    _, out, err = kinlint("arm.jsonld", "--statistics", "--output-format", "json")
    assert len(json.loads(out)) == 3
    assert "UNI002" in err


def test_infos_are_counted_and_not_shown_to_people(kinlint, pipeline, write, here):
    """Unless they are asked for, or decide the exit code; machines get everything."""
    write("arm.jsonld")
    pipeline.found = ["UNI002", "LIM009"]

    for form in ("full", "concise", "grouped"):
        code, out, _ = kinlint("arm.jsonld", "--output-format", form)
        assert (code, "UNI002" in out, "LIM009" in out) == (1, True, False)
        assert out.endswith("Found 1 error in 1 file; 1 info not shown (--show info).\n")
        for option in ("--show=info", "--show=note", "--fail-on=info", '--config=show="info"'):
            out = kinlint("arm.jsonld", "--output-format", form, option)[1]
            assert "LIM009" in out, option
    machine = kinlint("arm.jsonld", "--output-format", "json", "--show", "error")
    assert [one["code"] for one in json.loads(machine[1])] == ["UNI002", "LIM009"]
    copies = ("--concise-output", "c.txt", "--json-output", "c.json", "--statistics")
    assert "LIM009" in kinlint("arm.jsonld", *copies)[1]
    assert "LIM009" not in (here / "c.txt").read_text("utf-8")
    assert "LIM009" in (here / "c.json").read_text("utf-8")
    pipeline.found = ["UNI001", "LIM009"]
    alone = kinlint("arm.jsonld", "--show", "error")
    assert alone == (1, "No errors in 1 file; 1 warning and 1 info not shown (--show info).\n", "")


def test_quiet_and_silent(kinlint, pipeline, write):
    """Findings without a summary, and nothing at all."""
    write("arm.jsonld")
    pipeline.found = ["UNI002"]

    assert "Found 1 error" in kinlint("arm.jsonld")[1]
    assert "Found" not in kinlint("arm.jsonld", "-q")[1]
    assert kinlint("arm.jsonld", "-s")[1:] == ("", "")


def test_verbose(kinlint, pipeline, write):
    """Says by what the run goes and what it came to, on standard error."""
    write("arm.jsonld")
    write("kinlint.toml", 'ignore = ["LD"]')
    _, _, err = kinlint("arm.jsonld", "-v", "--select", "UNI", "--no-cache")
    lines = [line.removeprefix("kinlint: ").partition(": ") for line in err.splitlines()]
    told = {head: text for head, _, text in lines if text}

    assert lines[0][0].startswith(f"kinlint {__version__}, Python 3.")
    assert told["configuration"] == "kinlint.toml"
    assert told["contexts"] == "release ba7e601 (2025-04)"
    assert told["engine"].startswith("pyoxigraph ")
    assert told["catalogue"] == "4 rules with 0 constraints, compiled"
    assert told["read"] == "1 file with 0 triples"
    assert told["applied"] == "0 of 4 rules"


def test_verbose_without_configuration(kinlint, model):
    """There is none to name."""
    assert "kinlint: configuration: none (defaults)\n" in kinlint("-v")[2]


@pytest.mark.parametrize(
    ("options", "problem"),
    [
        (("-o", "arm.jsonld"), "--output-file: arm.jsonld is read in this run"),
        (("--sarif-output", "link.jsonld"), "--sarif-output: link.jsonld is read in this run"),
        (("-o", "x", "--json-output=./x"), "--json-output: x is written by another option, too"),
        (("--json-output=x", "--sarif-output=x"), "--sarif-output: x is written by another"),
        (
            ("--json-output=-",),
            "--json-output: '-' is not a file; for standard output, --output-for",
        ),
        (("--json-output=no/x",), "--json-output: cannot write no/x: there is no directory no"),
        (("--json-output=.",), "--json-output: cannot write .: Is a directory"),
        (("-o", ""), "-o/--output-file: expected a value, got ''"),
    ],
)
def test_outputs_that_exclude_each_other(kinlint, model, here, options, problem):
    """Nothing is lost, and nothing is done before."""
    (here / "link.jsonld").symlink_to("arm.jsonld")
    before = (here / "arm.jsonld").read_text("utf-8")
    code, out, err = kinlint("arm.jsonld", *options)

    assert (code, out) == (2, "")
    assert err.startswith(f"kinlint: error: {problem}")
    assert len(err.splitlines()) == 1
    assert (here / "arm.jsonld").read_text("utf-8") == before
    assert not (here / "x").exists()


def test_devices_may_be_named_twice(kinlint, model):
    """They take everything."""
    assert kinlint("-o", "/dev/null", "--json-output=/dev/null")[0] == 0


def test_a_dash_is_standard_output(kinlint, model, here):
    """As for input."""
    assert kinlint("arm.jsonld", "-o", "-")[1] == "All checks passed in 1 file.\n"
    assert not (here / "-").exists()


def test_names_in_messages_cannot_steer_the_terminal(kinlint, model, write):
    """Escape sequences and line ends are shown, not obeyed."""
    name = "a\x1b]0;x\nb.jsonld"
    _, _, err = kinlint(name, "--output-format", "json")

    assert err.startswith("kinlint: error: a\\u001b]0;x\\u000ab.jsonld: no such file")


def test_color(kinlint, pipeline, write, monkeypatch):
    """`always` beats NO_COLOR; files get none."""
    write("arm.jsonld")
    pipeline.found = ["UNI002"]
    monkeypatch.setenv("NO_COLOR", "1")

    assert "\x1b[" not in kinlint("arm.jsonld")[1]
    assert "\x1b[" in kinlint("arm.jsonld", "--color", "always")[1]


def test_verbose_runs_tell_what_pyld_expanded_and_why(kinlint, here):
    context = {"ex": "https://words.example/"}
    known, unknown = {"@id": "ex:a", "ex:size": 1}, {"@id": "ex:b", "word": 2}
    models = {
        "all.jsonld": {"@context": context, "@graph": [known]},
        "some.jsonld": {"@context": context, "@graph": [known, unknown]},
        "none.jsonld": {"@context": context, **known},
    }
    for name, model in models.items():
        (here / name).write_text(json.dumps(model), "utf-8")

    told = [line for line in kinlint("-v", *models)[2].splitlines() if "PyLD" in line]

    whole = "no object with a context and a graph of objects"
    assert sorted(told) == [
        f"kinlint: expanded by PyLD: 1 part of none.jsonld, because of {whole} (1)",
        "kinlint: expanded by PyLD: 1 part of some.jsonld, because of 'word' (1)",
    ]
