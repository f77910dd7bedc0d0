"""`kinlint check`: exit codes, what is linted, what is said where."""

import io
import sys

import pytest

from kinlint.configuration.settings import Choice
from kinlint.rule import Severity

XACRO = "http://www.ros.org/wiki/xacro"


@pytest.mark.parametrize(
    ("found", "options", "code"),
    [
        ([], [], 0),
        (["UNI002"], [], 1),
        (["UNI001"], [], 1),
        (["LIM009"], [], 0),
        (["LIM009"], ["--fail-on", "info"], 1),
        (["UNI001"], ["--fail-on=error"], 0),
        (["UNI002"], ["--fail-on", "none"], 0),
        (["UNI002"], ["--exit-zero"], 0),
        (["UNI002"], ["-e"], 0),
        (["UNI002"], ["-s"], 1),
    ],
)
def test_the_exit_code(kinlint, model, found, options, code):
    """1 if something is at least as bad as `--fail-on`, which is warning if nobody says."""
    model.found = found

    assert kinlint("arm.jsonld", *options)[0] == code


@pytest.mark.parametrize("options", [[], ["--exit-zero"], ["--fail-on", "none"], ["-s"]])
def test_what_cannot_be_read_is_2_whatever_is_found(kinlint, pipeline, write, options):
    """The other files are linted and reported all the same."""
    write("arm.jsonld")
    pipeline.found = ["UNI002"]
    code, out, err = kinlint("arm.jsonld", "leg.jsonld", *options)

    assert code == 2
    assert "leg.jsonld: no such file or directory" in out + err
    assert pipeline.inputs == ["arm.jsonld"]
    assert ("UNI002" in out) is (options != ["-s"])


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("arm.urdf", '<robot name="arm"><link name="base"></robot>'),
        ("arm.xacro", '<robot name="arm"><link name="base"></robot>'),
        ("arm.srdf", '<robot name="arm"><group name="all"></robot>'),
        ("arm.sdf", '<sdf version="1.9"><model name="arm"></sdf>'),
        (
            "arm.jsonld",
            '{"@context": "https://comp-rob2b.github.io/metamodels/x.json", "@graph": [',
        ),
        ("arm.ttl", "@prefix ex: <https://example.org/> .\nex:a ex:b ."),
    ],
)
@pytest.mark.parametrize("form", ["full", "json", "sarif", "junit"])
def test_what_cannot_be_parsed_is_2_in_every_format(kinlint, write, name, text, form):
    """Whatever the threshold is."""
    write(name, text)

    assert kinlint(name, "--output", form, "--fail-on", "none")[0] == 2


def test_check_is_the_default_command(kinlint, pipeline, write):
    """`kinlint PATH` is `kinlint check PATH`; a path may have the name of a command."""
    write("rule")
    pipeline.found = ["UNI002"]

    assert kinlint("check", "rule") == kinlint("./rule")
    assert pipeline.inputs == ["rule"]


def test_without_a_path_the_working_directory_is_linted(kinlint, pipeline, write):
    """Its models."""
    write("m/arm.jsonld")
    kinlint()

    assert pipeline.inputs == ["m/arm.jsonld"]


def test_a_search_in_vain_is_a_warning(kinlint, pipeline, write):
    """And no error."""
    write("readme.md")
    code, _, err = kinlint(".")

    assert (code, err) == (0, "kinlint: warning: no robot models found in '.'\n")
    assert kinlint(".", "-s")[2] == ""


def test_options_may_stand_between_paths(kinlint, pipeline, write):
    """In any order."""
    write("a.jsonld")
    write("b.jsonld")
    kinlint("a.jsonld", "--select", "UNI", "b.jsonld", "-q")

    assert pipeline.inputs == ["a.jsonld", "b.jsonld"]


def test_paths_may_begin_with_a_dash(kinlint, pipeline, write):
    """Behind two of them."""
    write("-a.jsonld")
    write("b.jsonld")
    kinlint("-q", "b.jsonld", "--", "-a.jsonld", "--")

    assert pipeline.inputs == ["b.jsonld", "-a.jsonld"]


def test_standard_input_has_a_name(kinlint, pipeline):
    """`--stdin-filename` alone means standard input, too."""
    kinlint("-")
    assert pipeline.inputs == ["<stdin>"]
    kinlint("-", "--stdin-filename", "m/arm.jsonld")
    assert pipeline.inputs == ["m/arm.jsonld"]
    kinlint("--stdin-filename", "m/arm.jsonld")
    assert pipeline.inputs == ["m/arm.jsonld"]


def test_options_become_settings(kinlint, pipeline, write, here):
    """Those of the run, and a layer of rule selection."""
    write("arm.jsonld")
    write("r/x.ttl", "")
    write("s.ttl", "")
    kinlint(
        *("arm.jsonld", "--select", "UNI,LD001", "--select", "AP5", "--ignore", "UNI001"),
        *("--extend-select", "LIM", "--error", "UNI001", "--info", "LD", "--engine", "pyshacl"),
        *("--contexts", "59e0b06", "--partial", "--rules", "r", "--shapes", "s.ttl", "-v"),
        *("--ignore-suppressions", "--cache-dir", "c"),
    )
    settings = pipeline.settings

    assert settings.for_file("arm.jsonld").choices == (
        Choice(
            select=("UNI", "LD001", "AP5"),
            extend_select=("LIM",),
            ignore=("UNI001",),
            severity=(("UNI001", Severity.ERROR), ("LD", Severity.INFO)),
        ),
    )
    assert settings.engine == "pyshacl"
    assert settings.contexts == "59e0b06"
    assert settings.partial
    assert settings.rules == (here / "r",)
    assert settings.shapes == (here / "s.ttl",)
    assert settings.ignore_suppressions
    assert settings.verbose
    assert str(settings.cache) == "c"


def test_the_cache(kinlint, pipeline, write, here, monkeypatch):
    """Where the environment says; nowhere with `--no-cache`."""
    monkeypatch.setenv("KINLINT_CACHE_DIR", str(here / ".cache"))
    write("arm.jsonld")
    kinlint("arm.jsonld")
    assert pipeline.settings.cache == here / ".cache"
    kinlint("arm.jsonld", "--no-cache")
    assert pipeline.settings.cache is None


def test_per_file_ignores(kinlint, pipeline, write):
    """Of the command line: for files, places in them and entities."""
    write("m/arm.jsonld")
    write("leg.jsonld")
    kinlint(
        *(".", "--per-file-ignores", "m/*:UNI001,m/*:LD,<https://example.org/x>:LD001"),
        *("--extend-per-file-ignores", "leg.jsonld#/@graph/0:UNI"),
    )
    ignores = {
        name: [
            (one.selectors, one.pointer, one.iri)
            for one in pipeline.settings.for_file(name).ignores
        ]
        for name in ("m/arm.jsonld", "leg.jsonld")
    }
    entity = (("LD001",), None, "https://example.org/x")

    assert ignores["m/arm.jsonld"] == [(("UNI001",), None, None), (("LD",), None, None), entity]
    assert ignores["leg.jsonld"] == [entity, (("UNI",), "/@graph/0", None)]


def test_excluding(kinlint, pipeline, write):
    """`--exclude` replaces what is passed over, `--extend-exclude` adds to it."""
    write("build/a.jsonld")
    write("old/b.jsonld")
    write("c.jsonld")

    kinlint(".", "--exclude", "old")
    assert pipeline.inputs == ["c.jsonld", "build/a.jsonld"]
    kinlint(".", "--extend-exclude", "old")
    assert pipeline.inputs == ["c.jsonld"]
    kinlint("old/b.jsonld", "c.jsonld", "--exclude", "old", "--force-exclude")
    assert pipeline.inputs == ["c.jsonld"]


def test_show_files(kinlint, pipeline, write):
    """And nothing is linted."""
    write("m/arm.jsonld")
    write("leg.jsonld")

    assert kinlint("--show-files") == (0, "leg.jsonld\nm/arm.jsonld\n", "")
    assert kinlint("--show-files", "no.jsonld")[0] == 2
    assert pipeline.settings is None


def test_show_settings(kinlint, pipeline, write):
    """Files with the same settings stand together."""
    write("a.jsonld")
    write("b.jsonld")
    write("m/c.jsonld")
    write("m/kinlint.toml", 'ignore = ["UNI"]\nrequire-reason = true')
    write("kinlint.toml", 'severity = {LD = "info"}\nper-file-ignores = {"*" = ["LIM"]}')
    write("x.json", "{}")
    write("s.ttl", "")
    extra = 'extra-contexts = {"x:y" = "x.json"}'
    code, out, err = kinlint("--show-settings", "--config", extra, "--shapes", "s.ttl")

    assert (code, err) == (0, "")
    assert "contexts = ba7e601\n" in out
    assert "extra-contexts <x:y> = x.json\n" in out
    assert "shapes = s.ttl\n" in out
    assert "\na.jsonld\nb.jsonld\n  rules chosen by: kinlint.toml\n" in out
    assert "\nm/c.jsonld\n  rules chosen by: m/kinlint.toml\n  require-reason = true\n" in out
    assert "ignored by kinlint.toml, *: LIM" in out
    assert "UNI001 missing-unit: off" in out
    assert "LD001 dropped-term: info" in out
    assert pipeline.settings is None


def test_standard_input_is_read_as_bytes(kinlint, monkeypatch):
    """The whole way, so that it need not be UTF-8 for Python."""

    class Stdin:
        buffer = io.BytesIO(b"\xff\xfe")

    monkeypatch.setattr(sys, "stdin", Stdin())
    code, out, err = kinlint("-", "--stdin-filename", "arm.jsonld")

    assert code == 2
    assert "arm.jsonld" in out + err


def test_only_files_of_some_formats(kinlint, write):
    """Content tells the format; what is no model is passed over, a macro is of what it makes."""
    write("cell.xml", "<mujoco/>")
    write("package.xml", "<package/>")
    write("arm.xacro", f'<robot name="arm" xmlns:xacro="{XACRO}"/>')
    write("arm.srdf", '<robot name="arm"/>')

    def left(formats):
        files = ("cell.xml", "package.xml", "arm.xacro", "arm.srdf")
        return kinlint("--show-files", "--only-format", formats, *files)[:2]

    assert left("mjcf") == (0, "cell.xml\n")
    assert left("urdf,srdf") == (0, "arm.xacro\narm.srdf\n")
    assert left("sdf") == (0, "")
    code, _, err = kinlint("--only-format", "mjfc", "cell.xml")
    assert code == 2
    assert "--only-format: 'mjfc' is not one of jsonld," in err
