"""Configuration of several directories in one run."""

import pytest

from kinlint.project.layers import cache_directory


def test_rules_speak_as_the_file_nearest_to_a_model_says(kinlint, pipeline, write):
    """And per-file ignores start at the directory of who says them."""
    write("kinlint.toml", 'ignore = ["UNI"]\nper-file-ignores = {"leg/*" = ["LD"]}')
    write("leg/a.jsonld")
    write("arm/kinlint.toml", 'select = ["LD"]\nper-file-ignores = {"b.jsonld" = ["UNI"]}')
    write("arm/b.jsonld")
    kinlint()
    leg, arm = (pipeline.settings.for_file(name) for name in ("leg/a.jsonld", "arm/b.jsonld"))

    assert [(one.origin, one.ignore) for one in leg.choices] == [("kinlint.toml", ("UNI",))]
    assert [(one.origin, one.select) for one in arm.choices] == [("arm/kinlint.toml", ("LD",))]
    assert [one.selectors for one in leg.ignores] == [("LD",)]
    assert [one.selectors for one in arm.ignores] == [("UNI",)]


def test_what_concerns_the_graph_comes_from_the_project(kinlint, pipeline, write):
    """A directory that says nothing of it follows."""
    write("kinlint.toml", 'contexts = "59e0b06"\nrules = "r"\npartial = true')
    write("arm/kinlint.toml", 'ignore = ["LD"]')
    write("arm/b.jsonld")
    write("leg/a.jsonld")
    write("r/x.ttl", "")

    assert kinlint("--trust")[0] == 0
    assert pipeline.settings.contexts == "59e0b06"
    assert pipeline.settings.partial
    assert [path.name for path in pipeline.settings.rules] == ["r"]


@pytest.mark.parametrize(
    ("arm", "leg"),
    [
        ('contexts = "59e0b06"', 'contexts = "ba7e601"'),
        ('contexts = "59e0b06"', ""),
        ("", "partial = true"),
        ('extra-contexts = "c"', 'extra-contexts = "../c"'),
    ],
)
def test_files_must_agree_on_the_graph(kinlint, pipeline, write, arm, leg):
    """All files of a run are one graph, so they are told to be linted apart."""
    write("arm/kinlint.toml", arm)
    write("arm/a.jsonld")
    for folder in ("c", "arm/c"):
        write(f"{folder}/contexts.json", "{}")
    write("leg/kinlint.toml", leg)
    write("leg/b.jsonld")
    code, _, err = kinlint()

    assert code == 2
    assert "arm/kinlint.toml" in err
    assert "leg/kinlint.toml" in err
    assert "differ in" in err
    assert pipeline.settings is None
    assert kinlint("arm")[0] == 0


def test_what_configurations_add_holds_for_all_files(kinlint, pipeline, write):
    """Contexts, rules and shapes: all files of a run are one graph."""
    for folder in ("arm", "leg"):
        iri = f'"https://example.org/{folder}.json" = "context.json"'
        write(f"{folder}/kinlint.toml", f'shapes = ["shape.ttl"]\n[extra-contexts]\n{iri}\n')
        write(f"{folder}/context.json", "{}")
        write(f"{folder}/shape.ttl", "")
        write(f"{folder}/a.jsonld")

    assert kinlint("--trust")[0] == 0
    assert [path.parent.name for path in pipeline.settings.shapes] == ["arm", "leg"]
    assert [*pipeline.settings.extra_contexts] == [
        "https://example.org/arm.json",
        "https://example.org/leg.json",
    ]


def test_one_context_cannot_be_two_files(kinlint, write):
    """Which of them would a file mean?"""
    for folder in ("arm", "leg"):
        iri = '"https://example.org/arm.json" = "context.json"'
        write(f"{folder}/kinlint.toml", f"[extra-contexts]\n{iri}\n")
        write(f"{folder}/context.json", "{}")
        write(f"{folder}/a.jsonld")

    code, _, err = kinlint()

    assert code == 2
    assert "differ in 'extra-contexts'" in err


def test_the_command_line_settles_a_disagreement(kinlint, pipeline, write):
    """It holds for all files."""
    for folder, release in (("arm", "59e0b06"), ("leg", "ba7e601")):
        write(f"{folder}/kinlint.toml", f'contexts = "{release}"')
        write(f"{folder}/a.jsonld")

    assert kinlint("--contexts", "6d34a4f")[0] == 0
    assert pipeline.settings.contexts == "6d34a4f"


def test_files_that_agree_need_no_project(kinlint, pipeline, write):
    """What both say holds."""
    for folder in ("arm", "leg"):
        write(f"{folder}/kinlint.toml", 'contexts = "59e0b06"')
        write(f"{folder}/a.jsonld")

    assert kinlint()[0] == 0
    assert pipeline.settings.contexts == "59e0b06"


def test_saying_what_is_so_anyway_is_no_disagreement(kinlint, pipeline, write):
    """Defaults may be written down."""
    text = 'contexts = "ba7e601"\npartial = false\nengine = "oxigraph"\nrules = []'
    write("arm/kinlint.toml", text)
    write("arm/a.jsonld")
    write("leg/b.jsonld")

    assert kinlint()[0] == 0


def test_rules_and_shapes_of_the_command_line_are_added(kinlint, pipeline, write):
    """To those of the configuration."""
    write("kinlint.toml", 'rules = "r"')
    write("arm.jsonld")
    for name in ("r", "more", "most"):
        write(f"{name}/a.ttl", "")
    kinlint("--trust", "--rules", "more", "--rules", "most")

    assert [path.name for path in pipeline.settings.rules] == ["r", "more", "most"]


def test_a_given_configuration_and_none(kinlint, pipeline, write):
    """`--config PATH` holds for all files, `--isolated` forgets them."""
    write("kinlint.toml", 'ignore = ["LD"]\nfail-on = "info"')
    write("other.toml", 'ignore = ["UNI"]')
    write("arm.jsonld")
    pipeline.found = ["LIM009"]

    assert kinlint()[0] == 1
    assert kinlint("--isolated")[0] == 0
    assert pipeline.settings.for_file("arm.jsonld").choices == ()
    assert kinlint("--config", "other.toml")[0] == 0
    assert [one.ignore for one in pipeline.settings.for_file("arm.jsonld").choices] == [("UNI",)]


def test_keys_on_the_command_line(kinlint, pipeline, write):
    """Each on top of the configuration, tables entry by entry."""
    write("kinlint.toml", 'fail-on = "info"\nignore = ["LD"]')
    write("arm.jsonld")
    pipeline.found = ["LIM009"]
    keys = ('fail-on="error"', 'severity.UNI = "info"', 'severity.LD = "warning"')
    code, _, _ = kinlint(*(word for key in keys for word in ("--config", key)))

    assert code == 0
    assert [one.origin for one in pipeline.settings.for_file("arm.jsonld").choices] == [
        "kinlint.toml",
        "--config",
    ]
    assert [name for name, _ in pipeline.settings.for_file("arm.jsonld").choices[1].severity] == [
        "UNI",
        "LD",
    ]


def test_an_unknown_rule_in_configuration_tells_the_file(kinlint, pipeline, write):
    """And the nearest known one."""
    write("arm/kinlint.toml", 'ignore = ["UNI0022"]')
    write("arm/a.jsonld")
    write("b.jsonld")

    code, out, err = kinlint()

    assert (code, out) == (2, "")
    assert err.startswith("kinlint: error: arm/kinlint.toml: unknown rule selector 'UNI0022', did")


def test_an_unknown_release_in_configuration_tells_the_file(kinlint, pipeline, write):
    """And the nearest known one."""
    write("kinlint.toml", 'contexts = "ba7e602"')
    write("a.jsonld")

    assert "kinlint.toml: contexts: unknown release" in kinlint()[2]


def test_exclusions_hold_where_they_are_written(kinlint, pipeline, write):
    """A directory with its own configuration decides for itself."""
    write("kinlint.toml", 'extend-exclude = ["old"]')
    write("old/a.jsonld")
    write("arm/kinlint.toml", 'exclude = ["new"]')
    write("arm/old/b.jsonld")
    write("arm/new/c.jsonld")
    write("arm/build/d.jsonld")
    kinlint()

    assert pipeline.inputs == ["arm/build/d.jsonld", "arm/old/b.jsonld"]


@pytest.mark.parametrize(
    ("platform", "environment", "path"),
    [
        ("linux", {"KINLINT_CACHE_DIR": "/c", "XDG_CACHE_HOME": "/x"}, "/c"),
        ("linux", {"XDG_CACHE_HOME": "/x"}, "/x/kinlint"),
        ("linux", {}, "/home/me/.cache/kinlint"),
        ("darwin", {}, "/home/me/Library/Caches/kinlint"),
        ("win32", {"LOCALAPPDATA": "/l"}, "/l/kinlint"),
        ("win32", {}, "/home/me/AppData/Local/kinlint"),
    ],
)
def test_where_caches_are(monkeypatch, platform, environment, path):
    """As each system has it."""
    monkeypatch.setattr("sys.platform", platform)
    monkeypatch.setenv("HOME", "/home/me")

    assert cache_directory(environment).as_posix() == path
