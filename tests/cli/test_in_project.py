"""`--in-project`: what is found in a file does not depend on the others that are named with it."""

import io
import random
import sys

import pytest

pytestmark = pytest.mark.slow

ARM = """<robot name="{name}">
  {remark}<link name="base"><inertial><mass value="{mass}"/>
    <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <link name="hand"/>
  <joint name="elbow" type="revolute">
    <parent link="base"/><child link="hand"/><axis xyz="0 0 1"/>
    <limit lower="{lower}" upper="1" effort="1" velocity="1"/>
  </joint>
</robot>
"""
MACRO = """<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="part" params="name">
    <link name="${name}"><inertial><mass value="-1"/>
      <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
  </xacro:macro>
</robot>
"""
USER = """<robot name="user" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="parts.xacro"/>
  <xacro:part name="base"/>
</robot>
"""
SRDF = (
    """<robot name="arm0"><group name="arm"><link name="base"/><link name="tip"/></group></robot>"""
)
CONTEXT = (
    '"@context": ["https://comp-rob2b.github.io/metamodels/geometry/structural-entities.json",'
    ' {"rob": "https://example.org/robot#"}]'
)
POINT = '{{{context}, "@id": "rob:{graph}", "@graph": [{{"@id": "rob:{name}", "@type": "Point"}}]}}'
FLAGS = ("--output-format", "concise", "-q")


def arm(number, name=""):
    """A robot, of which some have a fault, some two, and some excuse one."""
    return ARM.format(
        name=name or f"arm{number}",
        mass=-1 if number % 3 == 0 else 1,
        lower=2 if number % 4 == 0 else -1,
        remark="<!-- kinlint: ignore[INE003] a toy -->\n  " if number % 5 == 0 else "",
    )


@pytest.fixture
def project(write):
    """Robots that stand alone, some of one name, one made of macros, and one with an SRDF."""
    for number in range(12):
        write(f"robots {number % 3}/arm, {number}.urdf", arm(number))
    write("twins/one.urdf", arm(1, "twin"))
    write("twins/other.urdf", arm(3, "twin"))
    write("xacro/parts.xacro", MACRO)
    write("xacro/user.urdf.xacro", USER)
    write("package.json", '{"name": "no robot"}')


def lines(kinlint, *paths):
    """What is found in *paths* as parts of the project."""
    code, out, _ = kinlint("--in-project", "--force-exclude", *paths, *FLAGS)
    assert code == (1 if out else 0)
    return out.splitlines()


def names(kinlint):
    return kinlint("--show-files")[1].splitlines()


@pytest.mark.parametrize("more", ["", "srdf", "composable"])
@pytest.mark.parametrize("jobs", [(), ("-j", "2")])
def test_parts_of_a_project_find_what_one_run_finds(project, write, kinlint, more, jobs):
    """Each finding once, in any split, whether the files stand alone or are one model."""
    if more == "srdf":
        write("arm.srdf", SRDF)
    if more == "composable":
        for name in ("left", "right"):
            write(f"{name}.jsonld", POINT.format(context=CONTEXT, graph="same", name=name))
    whole = kinlint(".", *FLAGS)[1].splitlines()
    assert len(whole) > 12
    assert any(more == "srdf" or "parts.xacro" in line for line in whole)
    files = names(kinlint)
    for size in (3, 7):
        random.Random(size).shuffle(files)  # noqa: S311
        parts = (files[start : start + size] for start in range(0, len(files), size))
        assert sorted(line for part in parts for line in lines(kinlint, *jobs, *part)) == whole


def test_a_file_is_judged_with_those_it_speaks_of(write, kinlint):
    """They are read; what lies in them is counted, not told."""
    write("arm0.urdf", arm(0))
    write("sub/arm.srdf", SRDF)
    code, out, err = kinlint("--in-project", "sub/arm.srdf", "--select", "CMP001,INE003", "-q")
    assert (code, err) == (1, "")
    assert "The robot has no link named 'tip'" in out
    assert [line for line in out.splitlines() if "arm0.urdf" in line] == [" ::: arm0.urdf:1:14"]
    assert "; 1 more in files that were not named." in kinlint(
        "--in-project", "sub/arm.srdf", "--select", "CMP001,LIM001"
    )[1].replace("\n", "")


def test_what_is_known_is_not_counted(write, kinlint):
    """Of a baseline, in files that were not named."""
    write("arm0.urdf", arm(0))
    write("sub/arm.srdf", SRDF)
    only = ("--select", "CMP001,INE003,LIM001")
    kinlint("arm0.urdf", "--write-baseline", *only)
    told = kinlint("--in-project", "sub/arm.srdf", "--baseline", "kinlint-baseline.json", *only)
    assert told[0] == 1
    assert "not named" not in told[1]


def test_what_another_file_excuses_is_excused(write, kinlint):
    """A triple on a node counts wherever it stands."""
    write("a.jsonld", POINT.format(context=CONTEXT, graph="same", name="left"))
    write("b.jsonld", POINT.format(context=CONTEXT, graph="same", name="right"))
    (found,) = lines(kinlint, "b.jsonld", "--select", "ID001")
    assert found.startswith("b.jsonld:")
    excuse = (
        '{"@id": "https://example.org/robot#same", "https://w3id.org/kinlint/ns#ignore": "ID001"}'
    )
    write("c.jsonld", excuse)
    assert lines(kinlint, "b.jsonld", "--select", "ID001") == []


def test_what_is_excluded_is_not_read(project, write, kinlint):
    """Neither what is named nor what it could be judged with."""
    write("kinlint.toml", 'extend-exclude = ["robots 0", "right.jsonld"]')
    for name in ("left", "right"):
        write(f"{name}.jsonld", POINT.format(context=CONTEXT, graph="same", name=name))
    assert lines(kinlint, "robots 0/arm, 0.urdf") == []
    assert lines(kinlint, "left.jsonld", "right.jsonld", "--select", "ID001") == []


def test_json_that_is_no_model_is_passed_over(project, kinlint):
    """Hooks are given all JSON."""
    assert lines(kinlint, "package.json") == []
    assert kinlint("package.json")[0] == 2


def test_only_what_is_named_has_to_be_readable(project, write, kinlint):
    """A file elsewhere that nobody can read is for the run that is given it."""
    write("broken.urdf", '<!DOCTYPE robot [<!ENTITY a "b">]><robot name="&a;"/>')
    good = ("--in-project", "robots 1/arm, 1.urdf", "--select", "INE003")
    passed = "All checks passed in 1 file; 5 more in files that were not named.\n"
    assert kinlint(*good) == (0, passed, "")
    assert kinlint("--in-project", "broken.urdf")[0] == 2
    assert kinlint("--in-project", "missing.urdf")[0] == 2


def test_all_files_that_are_named_are_as_in_a_usual_run(project, kinlint):
    """Also those that no search would find."""
    assert lines(kinlint, ".") == kinlint(".", *FLAGS)[1].splitlines()
    assert kinlint("--in-project", "--show-files", "package.json")[1] == "package.json\n"


def test_standard_input_takes_the_place_of_its_file(project, kinlint, monkeypatch):
    """In the project, too."""
    stdin = io.TextIOWrapper(io.BytesIO(arm(3, "twin").replace("-1", "1").encode()))
    monkeypatch.setattr(sys, "stdin", stdin)
    told = lines(kinlint, "-", "--stdin-filename", "twins/other.urdf", "--select", "INE003")
    assert told == []


def test_only_what_is_named_is_mended(write, kinlint, here):
    """Others stay as they are, and so do files that these include."""
    bad = arm(4).replace('lower="2" upper="1"', 'lower="2" upper="-2"')
    for name in ("one", "other"):
        write(f"{name}.urdf", bad.replace("arm4", "same"))
    fix = ("--fix", "--unsafe-fixes", "--select", "LIM001")
    code, out, _ = kinlint("--in-project", "one.urdf", *fix)
    assert code == 0
    assert "1 fixed, 0 remaining" in out
    texts = {name: (here / f"{name}.urdf").read_text("utf-8") for name in ("one", "other")}
    assert 'lower="-2" upper="2"' in texts["one"]
    assert texts["other"] == bad.replace("arm4", "same")


def test_a_macro_that_is_not_named_stays(project, write, kinlint, here):
    """Although the file that is named includes it."""
    macro = MACRO.replace('value="-1"', 'value="1"').replace(
        "</xacro:macro>",
        '<joint name="j_${name}" type="revolute"><parent link="world"/><child link="${name}"/>'
        '<axis xyz="0 0 1"/><limit lower="2" upper="-2" effort="1" velocity="1"/></joint>'
        '<link name="world"/></xacro:macro>',
    )
    write("xacro/parts.xacro", macro)
    fix = ("--fix", "--unsafe-fixes", "--select", "LIM001", "-q")
    kinlint("--in-project", "xacro/user.urdf.xacro", *fix)
    assert (here / "xacro/parts.xacro").read_text("utf-8") == macro
    kinlint("--in-project", "xacro/parts.xacro", *fix)
    assert 'lower="-2" upper="2"' in (here / "xacro/parts.xacro").read_text("utf-8")


def test_only_what_is_named_is_ignored_from_now_on(write, kinlint, here):
    """`--add-ignore` writes nothing elsewhere."""
    for name in ("one", "other"):
        write(f"{name}.urdf", arm(3, "same"))
    kinlint("--in-project", "one.urdf", "--add-ignore", "--select", "INE003", "-q")
    assert "kinlint: ignore[INE003]" in (here / "one.urdf").read_text("utf-8")
    assert (here / "other.urdf").read_text("utf-8") == arm(3, "same")


def test_binary_layers_are_passed_over_without_their_extra(kinlint, here, monkeypatch):
    """A hook gets all files of a commit, and has no more packages than it is given."""
    (here / "mesh.usd").write_bytes(b"PXR-USDC" + bytes(80))
    (here / "arm.usda").write_text('#usda 1.0\ndef Xform "arm" {}\n', "utf-8")
    monkeypatch.setattr("kinlint.formats.usd.robot_layers.find_spec", lambda _: None)
    code, out, err = kinlint("--in-project", "mesh.usd", "arm.usda")
    assert (code, err) == (0, "")
    assert "in 1 file" in out
