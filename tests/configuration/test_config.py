"""Configuration files: found nearest first, checked strictly, layered by `extend`."""

import pytest

from kinlint.configuration.config_file import Config, Configs, load_config, parse_config
from kinlint.configuration.settings import Choice
from kinlint.errors import ConfigError
from kinlint.rule import Severity


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, "utf-8")
    return path


def test_the_nearest_file_governs(tmp_path):
    """One in a directory further up is not merged in."""
    write(tmp_path / "kinlint.toml", 'select = ["UNI"]\nengine = "pyshacl"')
    write(tmp_path / "arm" / "kinlint.toml", 'ignore = ["LD"]')
    write(tmp_path / "arm" / "models" / "arm.jsonld", "{}")
    configs = Configs()

    near, far = configs.nearest(tmp_path / "arm" / "models"), configs.nearest(tmp_path / "leg")

    assert near.choices == (Choice(str(tmp_path / "arm" / "kinlint.toml"), ignore=("LD",)),)
    assert near.engine is None
    assert far.engine == "pyshacl"


@pytest.mark.parametrize(
    ("names", "wanted"),
    [
        ([".kinlint.toml", "kinlint.toml", "pyproject.toml"], ".kinlint.toml"),
        (["kinlint.toml", "pyproject.toml"], "kinlint.toml"),
        (["pyproject.toml"], "pyproject.toml"),
    ],
)
def test_one_file_of_a_directory_counts(tmp_path, names, wanted):
    """`.kinlint.toml` before `kinlint.toml` before `pyproject.toml`."""
    for name in names:
        head = "[tool.kinlint]\n" if name == "pyproject.toml" else ""
        write(tmp_path / name, f'{head}fail-on = "info"')

    assert Configs().nearest(tmp_path).origin == str(tmp_path / wanted)


def test_a_pyproject_about_other_tools_is_passed_over(tmp_path):
    """The search goes on above it."""
    write(tmp_path / "kinlint.toml", "partial = true")
    write(tmp_path / "arm" / "pyproject.toml", "[tool.ruff]\n")

    assert Configs().nearest(tmp_path / "arm").partial is True


def test_nothing_governs_where_nothing_is(tmp_path):
    """No configuration file, no configuration."""
    assert Configs().nearest(tmp_path) is None


def test_a_fixed_configuration_governs_everywhere(tmp_path):
    """`--config PATH` and `--isolated`."""
    write(tmp_path / "kinlint.toml", "partial = true")
    fixed = Config("given")

    assert Configs(fixed).nearest(tmp_path) is fixed


def test_paths_and_patterns_start_at_the_file(tmp_path):
    """Wherever the command runs."""
    config = load_config(
        write(
            tmp_path / "conf" / "kinlint.toml",
            'rules = "rules"\nshapes = ["../s.ttl"]\nexclude = ["old/*"]\nextra-contexts = "ctx"\n'
            '[per-file-ignores]\n"models/*.json" = ["UNI"]',
        )
    )

    assert config.rules == (tmp_path / "conf" / "rules",)
    assert config.shapes == (tmp_path / "s.ttl",)
    assert config.context_directories == (tmp_path / "conf" / "ctx",)
    assert config.exclude[0].matches(tmp_path / "conf" / "old" / "arm.jsonld")
    assert config.per_file_ignores[0].glob.covers(tmp_path / "conf" / "models" / "arm.json")


def test_contexts_may_be_named_one_by_one(tmp_path):
    """A table from IRIs to files."""
    text = '[extra-contexts]\n"https://acme.example/c.json" = "c.json"'
    config = load_config(write(tmp_path / "kinlint.toml", text))

    assert config.extra_contexts == {"https://acme.example/c.json": tmp_path / "c.json"}
    assert config.context_directories is None


def test_keys_of_per_file_ignores(tmp_path):
    """A glob, a place in the files of a glob, an entity."""
    keys = {"a.json": ["UNI"], "a.json#/@graph/0": ["LD"], "<https://acme.example/arm>": ["LD"]}
    config = parse_config({"per-file-ignores": keys}, "kinlint.toml", tmp_path)

    whole, place, entity = config.per_file_ignores

    assert (whole.pointer, whole.iri, whole.selectors) == (None, None, ("UNI",))
    assert (place.pointer, place.glob.pattern) == ("/@graph/0", "a.json")
    assert (entity.iri, entity.pointer) == ("https://acme.example/arm", None)


def test_severities(tmp_path):
    """Selectors and what their rules count as."""
    config = parse_config({"severity": {"UNI002": "info"}}, "kinlint.toml", tmp_path)

    assert config.choices[0].severity == (("UNI002", Severity.INFO),)


def test_extending_puts_one_configuration_on_another(tmp_path):
    """Rule choices become layers, lists that extend add up, the rest replaces."""
    write(
        tmp_path / "base.toml",
        'select = ["UNI"]\nfail-on = "info"\npartial = true\n'
        'extend-exclude = ["old"]\n[per-file-ignores]\n"a" = ["LD"]',
    )
    config = load_config(
        write(
            tmp_path / "arm" / "kinlint.toml",
            'extend = "../base.toml"\nignore = ["LD"]\nfail-on = "error"\n'
            'extend-exclude = ["new"]\n[extend-per-file-ignores]\n"b" = ["LD"]',
        )
    )

    assert [choice.select for choice in config.choices] == [("UNI",), None]
    assert [choice.ignore for choice in config.choices] == [(), ("LD",)]
    assert config.fail_on == "error"
    assert config.partial is True
    assert [glob.pattern for glob in config.extend_exclude] == ["old", "new"]
    assert [one.key for one in config.per_file_ignores] == ["a"]
    assert [one.key for one in config.extend_per_file_ignores] == ["b"]
    assert config.origin == str(tmp_path / "arm" / "kinlint.toml")


@pytest.mark.parametrize(
    ("files", "message"),
    [
        ({"kinlint.toml": 'extend = "kinlint.toml"'}, "extends itself"),
        ({"kinlint.toml": 'extend = "b.toml"', "b.toml": 'extend = "kinlint.toml"'}, "itself"),
        ({"kinlint.toml": 'extend = "no.toml"'}, "no.toml: no such file"),
        ({"kinlint.toml": 'extend = "pyproject.toml"', "pyproject.toml": ""}, "no .tool.kinlint."),
    ],
)
def test_an_extension_that_leads_nowhere(tmp_path, files, message):
    """Loops and missing files are errors."""
    for name, text in files.items():
        write(tmp_path / name, text)

    with pytest.raises(ConfigError, match=message):
        load_config(tmp_path / "kinlint.toml")


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("selct = []", r"kinlint\.toml: unknown key 'selct', did you mean 'select'\?"),
        ("select = 'UNI'", r"select: expected a list of strings, got a string 'UNI'"),
        ("select = [1]", r"select: expected only strings in the list, got a number 1"),
        ("partial = 'yes'", r"partial: expected true or false, got a string 'yes'"),
        ("contexts = 3", r"contexts: expected a string, got a number 3"),
        ("fail-on = 'eror'", r"fail-on: 'eror' is not one of .*, did you mean 'error'\?"),
        ("engine = []", r"engine: expected one of oxigraph, pyshacl, got a list"),
        ("severity = 'info'", r"severity: expected a table, got a string"),
        ("severity = {UNI = 'wrning'}", r"severity: 'UNI': 'wrning' .* 'warning'\?"),
        ("per-file-ignores = {a = 'UNI'}", r"per-file-ignores: 'a': expected a list"),
        ("extra-contexts = 3", r"extra-contexts: expected a directory or a table"),
        ("extra-contexts = {a = 3}", r"extra-contexts: 'a': expected a string"),
        ("rules = {}", r"rules: expected a list of strings, got a table"),
        ("x = \ny = 1", r"kinlint\.toml:1:5: not TOML: Invalid value"),
    ],
)
def test_what_is_wrong_is_told_by_file_key_and_expectation(tmp_path, text, message):
    """Nothing unknown or of the wrong kind is passed over."""
    with pytest.raises(ConfigError, match=message):
        load_config(write(tmp_path / "kinlint.toml", text))


def test_a_file_that_is_no_text(tmp_path):
    """An error as any other."""
    (tmp_path / "kinlint.toml").write_bytes(b"\xff\xfe")

    with pytest.raises(ConfigError, match="not UTF-8"):
        load_config(tmp_path / "kinlint.toml")


def test_the_file_is_named_from_the_working_directory(tmp_path, monkeypatch):
    """As people see it."""
    write(tmp_path / "conf" / "kinlint.toml", "")
    monkeypatch.chdir(tmp_path)

    assert load_config(tmp_path / "conf" / "kinlint.toml").origin == "conf/kinlint.toml"


def test_an_entry_knows_where_it_stands(tmp_path):
    """Line ends and a byte order mark are left as they are."""
    text = "\ufeff# x\r\nper-file-ignores = {'<urn:x>' = [\"UNI\"]}\r\n"
    (tmp_path / "kinlint.toml").write_bytes(text.encode())
    (entry,) = load_config(tmp_path / "kinlint.toml").per_file_ignores
    source, span = entry.place

    assert source[span] == "'<urn:x>'"
    assert source.bom
    assert source.position(span.start) == (2, 21)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("[tool]\nkinlint = 3", "pyproject.toml: tool.kinlint: expected a table"),
        ("[tool.kinlint.tool.kinlint]\nselect = []", "unknown key 'tool'; keys of kinlint"),
        ("[tool.kinlint.lint]\nselect = []", "unknown key 'lint'; keys of kinlint"),
        ("[tool.kinlint]\nxyzzy = 1", "unknown key 'xyzzy'; there are extend, select, "),
        ("[tool.kinlint", r"pyproject\.toml:1:14: not TOML: "),
        ("kinlint = " + "[" * 100_000, "pyproject.toml:?.*: not TOML: "),
    ],
)
def test_what_is_wrong_with_a_pyproject(tmp_path, text, message):
    """No value of another tool's making is trusted."""
    (tmp_path / "pyproject.toml").write_text(text, "utf-8")

    with pytest.raises(ConfigError, match=message):
        Configs().nearest(tmp_path)


def test_a_pyproject_that_says_nothing_of_kinlint_is_not_judged(tmp_path):
    """Not even if it is no TOML: that is for others to tell."""
    (tmp_path / "pyproject.toml").write_text("[tool", "utf-8")

    assert Configs().nearest(tmp_path) is None
