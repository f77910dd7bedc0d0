"""What a run remembers is what a run that remembers nothing would say."""

import os
import random
import shutil
import sys
from pathlib import Path

import pytest

from kinlint.cli.main import main
from kinlint.files import environment

pytestmark = pytest.mark.slow

SAMPLES = Path(__file__).parents[2] / "samples"
ROBOT = '<robot name="{0}"><link name="a"/><link name="b"/>{1}</robot>\n'
JOINT = '<joint name="j" type="revolute"><parent link="a"/><child link="{0}"/></joint>'
MESH = '<link name="m"><visual><geometry><mesh filename="{0}"/></geometry></visual></link>'
XMLNS = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
XACRO = f'<robot name="x" {XMLNS}><xacro:include filename="{{0}}"/><xacro:m/></robot>'
PART = f'<robot {XMLNS}><xacro:macro name="m">{{0}}</xacro:macro></robot>'
PACKAGE = '<package format="3"><name>{0}</name></package>'


def _folders():
    return sorted(each.name for each in SAMPLES.iterdir() if each.is_dir())


def _copied(folder):
    """Copy a sample here; of the broken ones, of which there are hundreds, one in thirty."""
    names = sorted(each.name for each in (SAMPLES / "broken").iterdir())
    models = [name for name in names if not name.endswith(".expected")]
    unused = {*names} - {*models[::30]} if folder == "broken" else ()
    shutil.copytree(SAMPLES / folder, folder, ignore=shutil.ignore_patterns(*unused))


@pytest.mark.parametrize("folder", _folders())
def test_every_sample_is_recalled_as_it_is_found(runs, folder):
    """In a form that tells fixes, and in one that does not."""
    _copied(folder)
    for form in ("json", "concise"):
        fresh = runs.fresh(folder, form=form)

        assert runs.said(folder, form=form) == fresh
        assert runs.said(folder, form=form) == fresh
        assert runs.recalled(folder) > 0 or folder == "shapes"  # It has no model.


def _changed(data, seed):
    """*data* with one byte changed, gone or twice, nearly anywhere."""
    dice = random.Random(seed)  # noqa: S311
    at = dice.randrange(len(data))
    new = dice.choice([b"", data[at : at + 1] * 2, bytes([dice.randrange(32, 127)]), b'"', b"<"])
    return data[:at] + new + data[at + 1 :]


@pytest.mark.parametrize("folder", _folders())
def test_no_single_byte_goes_unnoticed(runs, folder):
    """Each file of a sample in turn; what is recalled of the others does not suffer."""
    _copied(folder)
    files = [path for path in sorted(Path(folder).rglob("*")) if path.is_file()]
    runs.said(folder, form="concise")
    for seed, path in enumerate(files[:2]):
        before = path.read_bytes()
        path.write_bytes(_changed(before, seed) if before else b" ")

        assert runs.said(folder, form="concise") == runs.fresh(folder, form="concise")
        path.write_bytes(before)
    assert runs.said(folder, form="concise") == runs.fresh(folder, form="concise")


def test_only_what_changed_is_linted_again(runs, write):
    """Of many files, in one process or several; an older text is still known."""
    for number in range(20):
        write(f"r{number}.urdf", ROBOT.format(f"r{number}", JOINT.format("nobody")))
    assert runs.recalled(".") == 0
    assert runs.recalled(".") == 20
    before = Path("r7.urdf").read_bytes()
    write("r7.urdf", ROBOT.format("r7", JOINT.format("b")))
    assert runs.recalled(".", "-j", "2") == 19
    assert runs.recalled(".", "-j", "2") == 20
    write("r7.urdf", before)
    assert runs.recalled(".") == 20
    assert runs.said(".") == runs.fresh(".")


def test_a_touched_file_is_an_unchanged_file(runs, write):
    """Its content counts, not its time: checkouts make files anew."""
    path = write("r.urdf", ROBOT.format("r", ""))
    runs.recalled(".")
    os.utime(path, (1, 1))
    assert runs.recalled(".") == 1
    write("r.urdf", path.read_bytes().replace(b'"b"', b'"c"'))
    os.utime(path, (1, 1))
    assert runs.recalled(".") == 0


CHANGES = {
    "an included file changes": lambda: Path("part.xacro").write_text(
        PART.format('<link name="l"/><lnik/>')
    ),
    "an included file goes": lambda: Path("part.xacro").unlink(),
    "a file that was missing appears": lambda: Path("late.xacro").write_text(PART.format("")),
    "a mesh goes": lambda: Path("meshes/a.stl").unlink(),
    "a mesh that was missing appears": lambda: Path("meshes/b.stl").touch(),
    "a mesh is spelt in another way": lambda: Path("meshes/a.stl").rename("meshes/A.stl"),
    "a package appears": lambda: (
        Path("ros/new").mkdir(),
        Path("ros/new/package.xml").write_text(PACKAGE.format("elsewhere")),
    ),
    "a package gets a name": lambda: Path("ros/a/package.xml").write_text(PACKAGE.format("new")),
    "a variable is set": lambda: os.environ.__setitem__("KINLINT_TEST_LINK", "set"),
}


@pytest.mark.parametrize("change", CHANGES)
def test_what_an_answer_depends_on_is_looked_at_again(runs, write, monkeypatch, change):
    """Whether it was there, or was looked for in vain."""
    monkeypatch.setenv("KINLINT_TEST_LINK", "unset")
    write(".git/HEAD", "")
    write("ros/a/package.xml", PACKAGE.format("arm_parts"))
    write("ros/a/meshes/a.stl", "")
    write("part.xacro", PART.format('<link name="l"/>'))
    write("x.xacro", XACRO.format("part.xacro"))
    write("y.xacro", XACRO.format("late.xacro"))
    write("kinlint.toml", 'xacro-env = ["KINLINT_TEST_LINK"]')
    write(
        "e.xacro", f'<robot name="e" {XMLNS}><link name="$(optenv KINLINT_TEST_LINK no)"/></robot>'
    )
    for name in ("a", "b"):
        write(f"m{name}.urdf", ROBOT.format(f"m{name}", MESH.format(f"meshes/{name}.stl")))
    packaged = (
        MESH.format("package://arm_parts/meshes/a.stl"),
        MESH.format("package://elsewhere/a.stl"),
    )
    write("p.urdf", ROBOT.format("p", packaged[0] + packaged[1].replace('"m"', '"n"')))
    write("meshes/a.stl", "")
    before = runs.said(".")
    assert runs.said(".") == before
    CHANGES[change]()
    after = runs.said(".")
    assert after == runs.fresh(".")
    assert after == runs.said(".")
    if change != "a variable is set":
        assert after != before


def test_configuration_contexts_and_rules_count(runs, write):
    """What governs a file, what its contexts mean, and what judges it."""
    model = '{"@context": "https://x.example/c.json", "@id": "x:a", "word": 1}'
    write("m.jsonld", model)
    write("r.urdf", ROBOT.format("r", JOINT.format("nobody")))
    write("c.json", '{"@context": {"x": "https://x.example/"}}')
    write("kinlint.toml", '[extra-contexts]\n"https://x.example/c.json" = "c.json"\n')
    steps = (
        lambda: write("c.json", '{"@context": {"x": "https://x.example/", "word": "x:word"}}'),
        lambda: write(
            "kinlint.toml", Path("kinlint.toml").read_bytes() + b"[severity]\nTOP = 'info'\n"
        ),
        lambda: write("kinlint.toml", 'ignore = ["TOP"]\n' + Path("kinlint.toml").read_text()),
    )
    for step in steps:
        runs.recalled(".", configured=True)
        assert runs.recalled(".", configured=True) == 2
        step()
        assert runs.recalled(".", configured=True) == 0
    write("rules/none.ttl", "")
    assert runs.recalled("m.jsonld", "r.urdf", "--rules", "rules", configured=True) == 0


def test_a_broken_file_beside_it_silences_what_is_unused_only(runs, write):
    """Whether the file was there from the beginning, or came and went."""
    write(
        "quiet.urdf", ROBOT.format("q", "<!-- kinlint: ignore[UNI002] a unit --><link name='c'/>")
    )
    whole = runs.fresh(".", form="concise")
    assert "LNT001" in whole[1]
    assert runs.said(".", form="concise") == whole
    write("bad.urdf", "<robot name='r'>" + "<a>" * 300)
    broken = runs.fresh(".", form="concise")
    assert "LNT001" not in broken[1]
    for _ in range(2):
        assert runs.said(".", form="concise") == broken
    Path("bad.urdf").unlink()
    assert runs.said(".", form="concise") == whole


def test_days_pass(runs, write, monkeypatch):
    """What is excused until a day is looked at again on the next."""
    write("r.urdf", ROBOT.format("r", "<!-- kinlint: ignore[TOP] until 2027-01-01 later -->"))
    assert [runs.recalled("."), runs.recalled(".")] == [0, 1]
    monkeypatch.setattr(environment.today, "__wrapped__", lambda: "2027-01-02")
    assert runs.recalled(".") == 0


def test_standard_input_is_not_kept(runs, write, monkeypatch):
    """Nor is anything recalled of it."""
    write("r.urdf", ROBOT.format("r", ""))
    runs.said(".")
    count = len(list(runs.reports.iterdir()))
    with Path("r.urdf").open("rb") as stream:
        monkeypatch.setattr(sys, "stdin", type("Stream", (), {"buffer": stream})())
        main(["-", "--stdin-filename", "r.urdf", "--isolated", "-q"])
    assert len(list(runs.reports.iterdir())) == count


def test_who_wants_no_cache_gets_none(runs, write):
    """And who names a directory gets it there."""
    write("r.urdf", ROBOT.format("r", ""))
    other = runs.cache.with_name("other")
    shutil.copytree(runs.cache, other)
    main([".", "--isolated", "--cache-dir", str(other), "-q"])
    assert not runs.reports.exists()
    assert len(list((other / "reports").iterdir())) == 1


def test_pictures_are_recalled_too(runs, write):
    """A page that draws robots is the same the second time."""
    write("r.urdf", ROBOT.format("r", JOINT.format("b")))
    assert (
        runs.said(".", form="html") == runs.said(".", form="html") == runs.fresh(".", form="html")
    )
