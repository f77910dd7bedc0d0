"""Which files a path stands for: deterministic, each once, nothing but models."""

import os
from pathlib import Path

import pytest

from kinlint.files.pathglob import Glob
from kinlint.project.discovery import HEAD, SKIPPED, Search, may_be_jsonld

MODEL = '{"@context": "https://example.org/c.json"}'


@pytest.fixture(autouse=True)
def here(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return tmp_path


def files(here, *names, text=MODEL):
    for name in names:
        path = here / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, "utf-8")


def find(*paths, patterns=SKIPPED, **options):
    globs = [Glob(Path.cwd(), pattern) for pattern in patterns]
    return Search(lambda _: globs, **options).find(paths)


def names(*paths, **options):
    return [one.name for one in find(*paths, **options).inputs]


def causes(*paths, **options):
    return [str(error) for error in find(*paths, **options).errors]


def test_directories_hold_json_ld(here):
    """`.jsonld`, and `.json` that speaks of a context; by name, at any depth."""
    files(here, "m/b.jsonld", "m/a.json", "m/deep/c.JSONLD", "m/shapes.ttl", "m/d.nq", "m/e.txt")
    files(here, "m/package.json", text='{"name": "x"}')

    assert names("m") == ["m/a.json", "m/b.jsonld", "m/deep/c.JSONLD"]
    assert names(".") == names("m")


def test_directories_hold_robots_in_files_called_xml(here):
    """Their root element tells; parts that only others include are no models."""
    files(here, "m/arm.xml", text='<?xml version="1.0"?>\n<!-- an arm -->\n<mujoco model="arm"/>')
    files(here, "m/part.xml", text="<mujocoinclude/>")
    files(here, "m/package.xml", text="<package format='3'><name>mujoco</name></package>")
    files(here, "m/note.xml", text="mujoco")

    assert names("m") == names("m/*") == ["m/arm.xml"]


@pytest.mark.parametrize(
    "folder", [".git", ".venv", "node_modules", "build", "dist", "venv", "a/.hidden", "__pycache__"]
)
def test_what_is_nobodys_model_is_passed_over(here, folder):
    """At any depth."""
    files(here, f"{folder}/a.jsonld", "b.jsonld")

    assert names(".") == ["b.jsonld"]


def test_what_is_named_is_read(here):
    """Even if a search would pass over it; a directory, too."""
    files(here, "build/a.jsonld", "build/.b.jsonld", "shapes.ttl")

    assert names("build/a.jsonld", "build/.b.jsonld") == ["build/a.jsonld", "build/.b.jsonld"]
    assert names("build") == ["build/a.jsonld"]
    assert names("shapes.ttl") == ["shapes.ttl"]


def test_exclusion_can_be_forced(here):
    """For hooks, which name every file."""
    files(here, "build/a.jsonld", "b.jsonld")

    assert names("build/a.jsonld", "b.jsonld", force=True) == ["b.jsonld"]
    assert names("build", force=True) == []


def test_the_own_place_of_the_project_does_not_matter(here, monkeypatch):
    """A project below `build` is searched as any other."""
    files(here, "build/robot/a.jsonld")
    monkeypatch.chdir(here / "build" / "robot")

    assert names(".") == ["a.jsonld"]


def test_globs_find_models(here):
    """Of all formats; what is no model by its name or its text is passed over."""
    files(here, "m/a.jsonld", "m/deep/b.jsonld", "m/c.ttl", "m/d.md", "node_modules/e.jsonld")
    files(here, "m/package.json", text="{}")

    assert names("m/*") == ["m/a.jsonld", "m/c.ttl", "m/deep/b.jsonld"]
    assert names("m/*.jsonld") == ["m/a.jsonld"]
    assert names("**/*.jsonld") == ["m/a.jsonld", "m/deep/b.jsonld"]
    assert names("m/*.md") == []


def test_globs_of_excluded_places_are_meant(here):
    """The fixed part of a pattern is named."""
    files(here, "build/a.jsonld")

    assert names("build/*.jsonld") == ["build/a.jsonld"]


def test_a_glob_without_a_match_is_an_error():
    """It names nothing."""
    assert causes("m/*.jsonld") == ["m/*.jsonld: no file matches"]


def test_each_file_is_read_once(here):
    """However often and by whatever way it is named."""
    files(here, "m/a.jsonld")
    (here / "link.jsonld").symlink_to(here / "m" / "a.jsonld")

    assert names("m/a.jsonld", "m", "./m/../m/a.jsonld", "*/*.jsonld") == ["m/a.jsonld"]
    assert names("m", "link.jsonld") == ["m/a.jsonld"]
    assert names(".") == ["m/a.jsonld"]
    assert names("link.jsonld", "m") == ["link.jsonld"]


def test_links_to_directories_are_not_followed_unless_named(here):
    """So that loops end."""
    files(here, "m/a.jsonld")
    (here / "m" / "loop").symlink_to(here / "m")
    (here / "again").symlink_to(here / "m")

    assert names("m") == ["m/a.jsonld"]
    assert names("again") == ["again/a.jsonld"]


def test_names_start_at_the_working_directory(here, tmp_path_factory):
    """Outside of it they are as they were given."""
    elsewhere = tmp_path_factory.mktemp("elsewhere")
    files(elsewhere, "a.jsonld")
    files(here, "b.jsonld")
    up = os.path.relpath(elsewhere)

    assert names(str(here / "b.jsonld")) == ["b.jsonld"]
    assert names(str(elsewhere / "a.jsonld")) == [f"{elsewhere}/a.jsonld"]
    assert names(f"{up}/a.jsonld") == [f"{up}/a.jsonld"]


def test_names_of_any_bytes_can_be_shown(here):
    """What is no UTF-8 is escaped; the path is what it is."""
    (here / os.fsdecode(b"\xff.jsonld")).write_text(MODEL, "utf-8")

    assert names(".") == ["\\xff.jsonld"]
    assert names(os.fsdecode(b"\xff.jsonld")) == ["\\xff.jsonld"]
    assert causes(os.fsdecode(b"\xfe.jsonl")) == [
        "\\xfe.jsonl: no such file or directory, did you mean '\\xff.jsonld'?"
    ]


def test_a_path_that_does_not_exist_is_an_error(here):
    """With what there is of a similar name."""
    files(here, "arm.jsonld")

    assert causes("amr.jsonld") == [
        "amr.jsonld: no such file or directory, did you mean 'arm.jsonld'?"
    ]
    assert causes("no/where.jsonld") == ["no/where.jsonld: no such file or directory"]


def test_a_search_in_vain_is_told(here):
    """It is no error."""
    files(here, "m/readme.md")

    found = find("m", "m/*.md")

    assert found.barren == ["m", "m/*.md"]
    assert found.errors == []


def test_standard_input_comes_first_and_stands_for_its_file(here):
    """An editor's text is newer than the file of that name."""
    files(here, "arm.jsonld", "leg.jsonld")

    found = find("arm.jsonld", "leg.jsonld", "-", "-", stdin="arm.jsonld").inputs

    assert [(one.name, one.path is None) for one in found] == [
        ("arm.jsonld", True),
        ("leg.jsonld", False),
    ]


def test_an_unreadable_directory_is_an_error(here, monkeypatch):
    """What lies beside it is found."""
    files(here, "m/a.jsonld", "m/locked/b.jsonld")
    real = os.scandir

    def scandir(path):
        if str(path).endswith("locked"):
            raise PermissionError(13, "Permission denied", str(path))
        return real(path)

    monkeypatch.setattr(os, "scandir", scandir)

    assert names("m") == ["m/a.jsonld"]
    assert causes("m") == ["m/locked: Permission denied"]


def test_a_file_that_cannot_be_looked_into_is_an_error(here, monkeypatch):
    """It may be a model."""
    files(here, "m/a.json")

    def denied(path):
        raise PermissionError(13, "Permission denied", str(path))

    monkeypatch.setattr("kinlint.project.discovery.may_be_jsonld", denied)

    assert causes("m") == ["m/a.json: Permission denied"]


@pytest.mark.parametrize(
    ("data", "answer"),
    [
        (MODEL.encode(), True),
        (b"\xef\xbb\xbf \r\n" + MODEL.encode(), True),
        (b"[" + MODEL.encode() + b"]", True),
        (b'{"a": "' + b"x" * HEAD + b'", "@context": {}}', True),
        (b'{"a": "' + b"x" * (HEAD - 12) + b'", "@context": {}}', True),
        (b'{"a": "' + b"x" * HEAD * 3 + b'"}', False),
        (b"{}", False),
        (b"", False),
        (b"# @context", False),
        (b'"@context"', False),
        (b"\x00\xff", False),
    ],
)
def test_the_look_at_a_file(here, data, answer):
    """It may be JSON-LD if it begins as JSON and a context is spoken of anywhere in it."""
    (here / "a.json").write_bytes(data)

    assert may_be_jsonld(here / "a.json") is answer
    assert not may_be_jsonld(here)


def test_globs_end_where_links_make_loops(here):
    """`**` follows no link; a wildcard that stands for one does."""
    files(here, "m/a.jsonld", "m/deep/b.jsonld")
    for name in ("self", "again", "once-more"):
        (here / "m" / name).symlink_to(here / "m")

    assert names("**/*.jsonld") == ["m/a.jsonld", "m/deep/b.jsonld"]
    assert names("**/**/**/b.jsonld") == ["m/deep/b.jsonld"]
    assert names("m/s*/a.jsonld") == ["m/self/a.jsonld"]


def test_globs_pass_over_what_searches_pass_over(here):
    """Unless the pattern spells it out."""
    files(here, "node_modules/m/a.jsonld", ".b.jsonld", "m/node_modules/c.jsonld")

    assert names("**/*.jsonld") == []
    assert names("*/node_modules/*.jsonld") == ["m/node_modules/c.jsonld"]
    assert names(".b*", patterns=()) == [".b.jsonld"]
    assert names("*.jsonld", patterns=()) == []


def test_globs_have_alternatives(here):
    """As the patterns of the configuration do."""
    files(here, "m/a.jsonld", "n/b.jsonld", "n/c.jsonld")

    assert names("{m,n}/{a,b}.jsonld") == ["m/a.jsonld", "n/b.jsonld"]
    assert names("{m/a,n/b}.*") == ["m/a.jsonld", "n/b.jsonld"]


def test_a_virtual_environment_is_passed_over_whatever_its_name(here):
    """Unless it is named."""
    files(here, "mine/lib/a.jsonld", "mine/pyvenv.cfg", "b.jsonld")

    assert names(".") == names("**/*.jsonld") == ["b.jsonld"]
    assert names("mine") == names("mine/**") == ["mine/lib/a.jsonld"]


@pytest.mark.parametrize("path", ["a" * 5_000, "*" + "a" * 5_000, "a\0b", "~nobody/a", "~nobody/*"])
def test_impossible_paths_are_errors(path):
    """One for each, with a name that can be a path again."""
    (error,) = find(path).errors
    assert "\0" not in error.name


def test_a_common_suffix_makes_no_name_alike(here):
    """Only what is in front of it."""
    files(here, "latin.jsonld", "skeleton.jsonld")

    assert causes("nothing.jsonld") == ["nothing.jsonld: no such file or directory"]
    assert causes("skeletn.jsonld")[0].endswith("did you mean 'skeleton.jsonld'?")


def test_launch_files_that_call_xacro_are_found(here):
    """In Python, XML and YAML, whatever else such an ending may mean."""
    called = ("a.launch", "b.launch.py", "c_launch.py", "d.launch.xml", "e_launch.xml")
    called += ("f.launch.yaml", "g_launch.yml")
    for name in called:
        (here / name).write_text("xacro", "utf-8")
    for name in ("other.launch.xml", "other_launch.py", "package.xml"):
        (here / name).write_text("<launch/>", "utf-8")

    assert names(".") == [*called]
