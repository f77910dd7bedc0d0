"""Everything that differs from format to format stands in its record, or in its own package."""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path

import pytest

import kinlint
from kinlint import resources
from kinlint.cli.main import main
from kinlint.file_format import Format
from kinlint.formats import recognition
from kinlint.formats.records import BY_NAME, BY_SUFFIX, ELEMENTS, FOLDERS, FORMATS, LIFTED

PACKAGE = Path(kinlint.__file__).parent
SAMPLES = Path(__file__).parents[2] / "samples"
SUFFIXES = set(BY_SUFFIX) - {".ttl"}
"""Rules, shapes and profiles are Turtle too."""
NAMESPACES = {"URDF", "SDF", "SRDF"}

EXCEPTIONS = {
    "cache/cache_key.py": "the library called xacro, whose version is part of the key",
    "catalogue/scaffold.py": "the examples of a new rule, written out for two formats",
    "catalogue/term_checks.py": "rule files, which are Turtle",
    "cli/graph_command.py": "the output format `turtle` of a graph",
    "cli/rule_command.py": "the output format `turtle` of a rule",
    "cli/verbose.py": "JSON-LD, of which PyLD expands what is not compiled",
    "cli/version_command.py": "the library called xacro, whose version is told",
    "configuration/config_file.py": "the key `srdf` of a configuration",
    "configuration/project_trust.py": "the key `srdf` of a configuration",
    "configuration/keys.py": "the key `srdf` and the output format `turtle`",
    "conversion/output.py": "the functions that write a model in each format",
    "endpoint/judging.py": "Turtle, as which a graph of a store is read that no file was loaded to",
    "files/file_exists.py": "the suffixes of meshes, which may be COLLADA",
    "generation/program.py": "JSON-LD, by whose framing a program's tree is made",
    "missing_files.py": "the elements of URDF and SDF that name files",
    "navigation": "names inside of SDF and xacro, whose scopes and macros only they have",
    "pipeline/conclusion.py": "YAML files, which are often about something else than robots",
    "project/discovery.py": "Turtle files, which directories have beside the models they belong to",
    "project/turtle_parts.py": "JSON-LD models and the Turtle files that are parts of them",
    "reporters/reporter_registry.py": "the output format `turtle`",
    "reporters/summary.py": "YAML files, which are often about something else than robots",
    "rule_formatting": "rule files, which are Turtle",
    "server/workspace_folder.py": "the YAML files that are judged by a robot of their folder",
    "vocabulary.py": "the namespaces themselves",
}
"""The modules and packages outside `formats` that name a format, and why."""


def modules() -> Iterator[str]:
    """Every module outside `formats` that is no exception."""
    for path in sorted(PACKAGE.rglob("*.py")):
        below = path.relative_to(PACKAGE).as_posix()
        if not below.startswith("formats/") and not any(
            below == known or below.startswith(f"{known}/") for known in EXCEPTIONS
        ):
            yield below


def named(module: str) -> Iterator[tuple[int, str]]:
    """Where the code of *module* names a format: by its name, a suffix, a namespace, a record."""
    for node in ast.walk(ast.parse((PACKAGE / module).read_text("utf-8"))):
        if isinstance(node, ast.Constant) and node.value in {*BY_NAME, *SUFFIXES}:
            yield node.lineno, str(node.value)
        elif isinstance(node, ast.ImportFrom):
            origin = node.module or ""
            if origin.removeprefix("kinlint.formats.").split(".")[0] in FOLDERS:
                yield node.lineno, origin
            if origin == "kinlint.vocabulary":
                yield from ((node.lineno, one.name) for one in node.names if one.name in NAMESPACES)


@pytest.mark.slow
def test_no_other_module_names_a_format():
    """A new format is a folder, its name in `FOLDERS`, and data."""
    assert {module: found for module in modules() if (found := list(named(module)))} == {}


@pytest.mark.parametrize("module", ["configuration/keys.py", "conversion/output.py"])
def test_names_of_formats_are_seen(module):
    """In exceptions, where there are some."""
    assert list(named(module))


def test_each_folder_with_records_is_collected():
    """And each format has a name and suffixes of its own."""
    folders = {path.parent.name for path in (PACKAGE / "formats").glob("*/format.py")}
    assert folders == set(FOLDERS)
    assert len(BY_NAME) == len(FORMATS)
    assert len(BY_SUFFIX) == sum(len(each.suffixes) for each in FORMATS)


@pytest.mark.parametrize("form", FORMATS, ids=lambda each: each.name)
def test_a_record_names_what_there_is(form: Format) -> None:
    """Modules that read and edit, a schema, formats that it speaks of or expands to."""
    assert callable(import_module(form.reader).read)
    if form.editor is not None:
        assert callable(import_module(form.editor).Editor)
    assert form.is_tree == (form in LIFTED or form.expands_to is not None or not form.lifted)
    assert (form.schema is not None) == (form.namespace in ELEMENTS)
    if form.schema is not None:
        assert (resources.data("shapes") / form.schema).is_file()
    assert {form.expands_to, form.speaks_of} <= {None, *BY_NAME}


def test_equal_names_are_equal_records():
    """A record may come from another process."""
    urdf = BY_NAME["urdf"]
    other = Format("urdf", "", (), urdf.shape, "")
    assert (other == urdf, hash(other) == hash(urdf)) == (True, True)
    assert urdf != BY_NAME["srdf"]


def test_a_file_is_recognised_once(monkeypatch, capsys):
    """From then on its text carries the record: whoever reads, pairs or groups it asks that."""
    asked = Counter[str]()
    real = recognition.recognise

    def counted(name: str, text: str) -> Format | None:
        asked[Path(name).name] += 1
        return real(name, text)

    monkeypatch.setattr(recognition, "recognise", counted)
    files = [SAMPLES / "urdf" / name for name in ("six-axis.urdf", "six-axis.srdf")]
    main(["--isolated", *map(str, files), str(SAMPLES / "sdf" / "six-axis.sdf")])
    capsys.readouterr()
    assert asked == {"six-axis.urdf": 1, "six-axis.srdf": 1, "six-axis.sdf": 1}
