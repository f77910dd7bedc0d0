"""What a lint looks up is noted, and can be looked up again."""

import ast
from pathlib import Path

import pytest

import kinlint
from kinlint.files import environment
from kinlint.files.bounded_read import Unreadable, contents, head
from kinlint.files.file_exists import References
from kinlint.files.packages import Packages
from kinlint.files.tracked_io import answer, recorded

PACKAGE = Path(kinlint.__file__).parent
LOOKING = {
    *("exists", "is_dir", "is_file", "stat", "lstat", "read_bytes", "read_text", "open", "iterdir"),
    *(
        "glob",
        "rglob",
        "scandir",
        "listdir",
        "realpath",
        "resolve_path",
        "environ",
        "getenv",
    ),
    *("today", "now", "is_symlink", "lexists", "getmtime", "access"),
}
LINTING = ("facts", "findings", "fixes", "formats", "suppression", "engine/*.py")
OWN_DATA = {
    "contexts/context_library.py",
    "engine/lifting_compiler.py",
    "engine/provenance.py",
    "engine/vocabulary_files.py",
    "formats/xml/schema.py",
}
"""Modules that read files of kinlint itself, or files whose content is part of a cache key."""
INPUTS = {
    "formats/dependencies/companions.py",
    "formats/dependencies/configured_robots.py",
    "formats/yaml/ros_keys.py",
}
"""Modules that find and read sources: their texts are part of a cache key."""
UNPACKING = {"formats/collada/archive.py", "formats/usd/binary_layers.py"}
"""Modules that open members of an archive, or files that they made of a layer, once it is read."""


def _modules():
    for part in LINTING:
        pattern = part if part.endswith(".py") else f"{part}/**/*.py"
        yield from sorted(PACKAGE.glob(pattern))
    yield from (PACKAGE / f"{name}.py" for name in ("lint", "missing_files"))


@pytest.mark.parametrize(
    "module", list(_modules()), ids=lambda path: str(path.relative_to(PACKAGE))
)
def test_nothing_is_looked_up_but_by_questions(module):
    """Of what a lint does; else reports would be recalled that are not true any more."""
    if str(module.relative_to(PACKAGE)) in OWN_DATA | INPUTS | UNPACKING:
        return
    tree = list(ast.walk(ast.parse(module.read_text("utf-8"))))
    called = [node.func for node in tree if isinstance(node, ast.Call)]
    found = [node for node in called if getattr(node, "attr", getattr(node, "id", "")) in LOOKING]
    found += [node for node in tree if isinstance(node, ast.Attribute) and node.attr == "environ"]
    found = [ast.unparse(node) for node in found if not _is_question(node)]
    assert not found


def _is_question(node):
    return isinstance(getattr(node, "value", None), ast.Name) and node.value.id == "environment"


def test_questions_are_noted_with_their_answers(tmp_path):
    """Each once; the answer is the same until something changes."""
    file = tmp_path / "a.yaml"
    with recorded() as record:
        assert environment.kind(file) is None
        assert environment.listing(tmp_path) == {}
        with pytest.raises(Unreadable):
            contents(file, file)
    assert len(record.answers) == 3
    assert all(answer(asked) == said for asked, said in record.answers.items())
    file.write_text("x")
    assert all(answer(asked) != said for asked, said in record.answers.items())


def test_nothing_is_noted_outside_of_a_record(tmp_path):
    """Nor what a question asks on its way."""
    (tmp_path / "package.xml").write_text("<package><name>p</name></package>")
    environment.kind(tmp_path)
    with recorded() as record:
        Packages(workspace=tmp_path).find("p", Path("/nowhere"))
    names = [name for name, _ in record.answers]
    assert "packages.packages_below" in names
    assert "contents.head" not in names


def test_an_answer_that_changes_meanwhile_tears_a_record(tmp_path):
    """Nobody knows which of both counted."""
    with recorded() as record:
        head(tmp_path / "a", 5)
        (tmp_path / "a").write_text("text")
        head(tmp_path / "a", 5)
    assert record.torn


def test_meshes_are_looked_for_by_questions(tmp_path):
    """Where they are, and where they are not."""
    (tmp_path / "meshes").mkdir()
    (tmp_path / "meshes" / "a.stl").touch()
    with recorded() as record:
        References(Packages()).fault("meshes/a.stl", tmp_path)
    before = dict(record.answers)
    (tmp_path / "meshes" / "a.stl").unlink()
    assert any(answer(asked) != said for asked, said in before.items())


@pytest.mark.parametrize("name", ["os.system", "contents.shown", "contents", "a.b.c", ""])
def test_only_questions_are_asked(name):
    """Whatever a file says that somebody put into the cache."""
    with pytest.raises((ValueError, ImportError)):
        answer((name, ()))
