"""The command that generates programs: what it writes, and when it does not."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from itertools import count
from pathlib import Path

import pytest
from programs import module, program

from kinlint.cli.main import main

pytest.importorskip("jinja2")

SAMPLES = Path(__file__).resolve().parents[2] / "samples"
ARM = str(SAMPLES / "urdf" / "six-axis.urdf")
HOSTILE = '";system("x");//\\\n*/ \'\'\'"""?>/ü'


def robot(kind: str = "revolute", name: str = "j", axis: str = "0 0 1") -> str:
    return f"""<robot name="r">
<link name="base"/>
<link name="hand">
  <inertial>
    <origin xyz="0.1 0 0"/>
    <mass value="2"/>
    <inertia ixx="0.02" iyy="0.02" izz="0.02" ixy="0" ixz="0" iyz="0"/>
  </inertial>
</link>
<joint name={name!r} type={kind!r}>
  <parent link="base"/>
  <child link="hand"/>
  <origin xyz="0 0 0.5"/>
  <axis xyz="{axis}"/>
  <limit lower="-1" upper="1" effort="9" velocity="3"/>
</joint>
</robot>
"""


@pytest.fixture
def here(tmp_path, monkeypatch, rules_cache):
    monkeypatch.chdir(tmp_path)
    return tmp_path


def generate(capsys, *arguments: str) -> tuple[int, str, str]:
    code = main(["generate", *arguments])
    out, err = capsys.readouterr()
    return code, out, err


def written(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.iterdir()} if folder.exists() else {}


@pytest.mark.slow
def test_writes_the_same_twice_and_nothing_the_second_time(here, capsys):
    Path("r.urdf").write_text(robot())
    for library in ("kdl", "numpy", "pinocchio"):
        code, out, err = generate(capsys, "--for", library, "r.urdf", "-o", library)
        first = written(here / library)
        assert (code, out) == (0, "")
        assert first
        assert err == "".join(f"kinlint: wrote {Path(library, name)}\n" for name in sorted(first))
        assert generate(capsys, "--for", library, "r.urdf", "-o", library) == (0, "", "")
        assert written(here / library) == first
    assert sorted(each.name for each in here.iterdir()) == ["kdl", "numpy", "pinocchio", "r.urdf"]


@pytest.mark.slow
def test_what_would_be_written(here, capsys):
    Path("r.urdf").write_text(robot())
    arguments = ("--for", "numpy", "r.urdf", "-o", "out")
    assert generate(capsys, *arguments, "--check") == (
        1,
        f"would write {Path('out', 'robot.py')}\n",
        "",
    )
    assert not Path("out").exists()
    generate(capsys, *arguments, "-q")
    assert generate(capsys, *arguments, "--check") == (0, "", "")
    Path("r.urdf").write_text(robot().replace('"0 0 0.5"', '"0 0 0.75"'))
    code, out, _ = generate(capsys, *arguments, "--diff")
    changed = [
        line for line in out.splitlines() if line[:1] in "+-" and line[:2] not in ("++", "--")
    ]
    assert code == 1
    assert [line[0] for line in changed] == ["-", "+"]
    assert "0.75" in changed[1]
    assert "0.75" not in Path("out/robot.py").read_text()


@pytest.mark.parametrize(
    "library",
    ["kdl", *(pytest.param(each, marks=pytest.mark.slow) for each in ("numpy", "pinocchio"))],
)
def test_what_the_library_cannot_do_is_found_at_its_line(here, capsys, library):
    Path("r.urdf").write_text(robot("planar"))
    code, out, err = generate(capsys, "--for", library, "r.urdf", "-o", "out")
    assert code == 1
    assert "--> r.urdf:10:" in out
    assert "move revolute, prismatic and fixed joints; joint 'j' is none of these" in out
    assert err == "kinlint: nothing is written: the models have errors\n"
    assert not Path("out").exists()


@pytest.mark.slow
def test_a_static_model_does_not_move(here, capsys):
    joint = """<joint name="j" type="revolute"><parent>a</parent><child>b</child>
<axis><xyz>0 0 1</xyz></axis></joint>"""
    model = f"""<sdf version="1.9"><model name="m"><static>true</static>
<link name="a"/><link name="b"/>{joint}</model></sdf>"""
    Path("m.sdf").write_text(model)
    code, out, _ = generate(capsys, "--for", "kdl", "m.sdf", "-o", "out")
    assert (code, "Joint 'j' of a static model does not move" in out) == (1, True)
    Path("m.sdf").write_text(model.replace(">true<", ">false<"))
    assert generate(capsys, "--for", "kdl", "m.sdf", "-o", "out")[0] == 0


@pytest.mark.slow
@pytest.mark.parametrize(
    ("fault", "told"),
    [
        (('value="2"', 'value="-2"'), "INE003"),
        (('ixx="0.02"', 'ixx="0.2"'), "INE001"),
        (('link="base"/>\n  <child', 'link="bass"/>\n  <child'), "TOP001"),
        (('xyz="0 0 0.5"', 'xyz="0 0 0,5"'), "SRC007"),
        (('"revolute"', '"revolut"'), "TOP007"),
        (('xyz="0 0 1"', 'xyz="0 0 0"'), "FRM008"),
        (('lower="-1" upper="1"', 'lower="1" upper="-1"'), "LIM001"),
    ],
)
def test_one_fault_stops_it(here, capsys, fault, told):
    text = robot().replace("'", '"')
    assert fault[0] in text
    Path("r.urdf").write_text(text.replace(*fault))
    code, out, _ = generate(capsys, "--for", "numpy", "r.urdf", "-o", "out")
    assert (code, f"error[{told}]" in out, Path("out").exists()) == (1, True, False)


@pytest.mark.slow
@pytest.mark.parametrize(
    "options",
    [
        ("--select", "UNI"),
        ("--ignore", "GEN001"),
        ("--ignore", "ALL"),
        ("--config", 'severity.GEN001="info"'),
        ("--fail-on", "error"),
    ],
)
def test_nothing_turns_off_what_a_library_cannot_do(here, capsys, options):
    comment = "<!-- kinlint: ignore[GEN001] -->"
    Path("r.urdf").write_text(robot("planar").replace("<joint", f"{comment}\n<joint"))
    code, out, _ = generate(capsys, "--for", "kdl", "r.urdf", "-o", "out", *options)
    assert (code, "error[GEN001]" in out, Path("out").exists()) == (1, True, False)


@pytest.mark.slow
@pytest.mark.parametrize("options", [("--select", "UNI"), ("--ignore", "FRM008"), ()])
def test_nothing_turns_off_what_numbers_depend_on(here, capsys, options):
    text = robot(axis="0 0 0").replace("<joint", "<!-- kinlint: ignore -->\n<joint")
    Path("r.urdf").write_text(text)
    code, out, _ = generate(capsys, "--for", "kdl", "r.urdf", "-o", "out", *options)
    assert (code, "error[FRM008]" in out, Path("out").exists()) == (1, True, False)


@pytest.mark.slow
def test_rules_about_something_else_may_be_turned_off(here, capsys):
    Path("r.urdf").write_text(robot().replace('lower="-1"', 'lower="2"'))
    arguments = ("--for", "kdl", "r.urdf", "-o", "out", "-q")
    assert generate(capsys, *arguments)[0] == 1
    assert generate(capsys, *arguments, "--ignore", "LIM001")[0] == 0


@pytest.mark.slow
def test_a_warning_stops_it_unless_accepted(here, capsys):
    Path("r.urdf").write_text(robot().replace('upper="1"', 'upper="90"'))
    arguments = ("--for", "numpy", "r.urdf", "-o", "out")
    code, out, err = generate(capsys, *arguments)
    assert (code, "warning[" in out, "error[" in out) == (1, True, False)
    assert "the models have warnings, which --fail-on error accepts" in err
    assert not Path("out").exists()
    assert generate(capsys, *arguments, "-q", "--fail-on", "error") == (0, "", "")


@pytest.mark.parametrize(("library", "name"), [("kdl", "robot.hpp"), ("numpy", "robot.py")])
def test_says_why_there_are_no_dynamics(here, capsys, library, name):
    start, _, rest = robot().partition("  <inertial>")
    Path("r.urdf").write_text(start + rest.partition("</inertial>\n")[2])
    generate(capsys, "--for", library, "r.urdf", "-o", "out", "-q", "--fail-on", "error")
    cause = "Without inverse dynamics: the models do not state all of the inertia of hand."
    assert cause in Path("out", name).read_text()


def test_the_rules_have_pages(capsys, rules_cache):
    assert main(["rule", "GEN"]) == 0
    out = capsys.readouterr().out
    codes = [line[:6] for line in out.splitlines() if line.startswith("GEN")]
    assert codes == [f"GEN{number:03}" for number in range(1, 10)]
    assert "To ignore" not in out
    assert main(["rule", "SHACL001"]) == 2
    assert "add --shapes FILE" in capsys.readouterr().err


def test_two_trees_and_loops_are_found(here, capsys):
    loop = (SAMPLES / "four-bar").glob("*.jsonld")
    code, out, _ = generate(capsys, "--for", "kdl", *map(str, loop), "-o", "out")
    assert (code, "closes a loop" in out) == (1, True)


SDF = """<sdf version="1.9"><model name="m"><link name="a"/><link name="b"/>
<joint name="j" type="{}"><parent>a</parent><child>b</child>
<axis><xyz>0 0 1</xyz></axis><axis2><xyz>0 1 0</xyz></axis2></joint></model></sdf>"""
MJCF = """<mujoco><worldbody><body name="a"><joint name="j"/><geom size="1"/><body name="b">
{}<geom size="1"/></body></body></worldbody>
{}</mujoco>"""
LOST = (
    '<xacro:include xmlns:xacro="http://www.ros.org/wiki/xacro" '
    'filename="$(find nowhere_at_all)/arm.xacro"/>'
)
AWAY = "<include><uri>model://nowhere_at_all</uri></include>"
HINGE = '<joint name="k"/>'


@pytest.mark.parametrize(
    ("name", "text", "code"),
    [
        *(("r.sdf", SDF.format(each), "GEN001") for each in ("ball", "universal", "screw")),
        *(("r.sdf", SDF.format(each), "GEN001") for each in ("revolute2", "gearbox")),
        ("r.urdf", robot("floating"), "GEN001"),
        ("r.xml", MJCF.format('<joint type="ball"/>', ""), "GEN001"),
        ("r.xml", MJCF.format("", "").replace('<joint name="j"/>', "<freejoint/>"), "GEN001"),
        *(
            ("r.xml", MJCF.format(HINGE, f"<equality>{law}</equality>"), code)
            for law, code in (
                ('<joint joint1="j"/>', "GEN005"),
                ('<joint joint1="j" joint2="k" polycoef="0 1 2 0 0"/>', "GEN005"),
                ('<connect body1="a" body2="b" anchor="0 0 0"/>', "GEN003"),
                ('<weld body1="a" body2="b"/>', "GEN003"),
            )
        ),
        ("r.xacro", robot().replace("<link", f"{LOST}<link", 1), "GEN009"),
        ("r.sdf", SDF.format("fixed").replace("</model>", f"{AWAY}</model>"), "GEN009"),
        *(
            ("r.urdf", robot().replace("<limit", f"<mimic joint={leader}/><limit"), "GEN005")
            for leader in ("'j'", "'lost'")
        ),
    ],
    ids=map(str, count(1)),
)
def test_no_joint_and_no_law_is_lost(tmp_path_factory, name, text, code):
    kept = tmp_path_factory.getbasetemp() / "rules"
    errors, files = program({name: text}, "numpy", kept, general=False)
    assert code in {each.rule.code for each in errors}
    assert files == {}


def test_a_joint_has_one_motion(tmp_path_factory):
    kept = tmp_path_factory.getbasetemp() / "rules"
    models = {each.name: each.read_text() for each in (SAMPLES / "one-dof").glob("*.jsonld")}
    for other in ("PlanarJoint", "CylindricalJoint", "PrismaticJoint"):
        chain = models["chain.jsonld"].replace('"RevoluteJoint"', f'"RevoluteJoint", "{other}"')
        errors, _ = program({**models, "chain.jsonld": chain}, "numpy", kept, general=False)
        assert "GEN001" in {each.rule.code for each in errors}


def test_names_are_all_different(tmp_path_factory):
    """Bodies and joints without a name have their paths, and others may have these for names."""
    body = '<body {}><joint {}/><geom size="1"/>{}</body>'
    named = body.format('name="worldbody/body"', 'name="worldbody/body/joint"', "")
    text = (
        f"<mujoco><worldbody>{body.format('', '', body.format('', '', named))}</worldbody></mujoco>"
    )
    kept = tmp_path_factory.getbasetemp() / "rules"
    made = module(program({"r.xml": text}, "numpy", kept, general=False)[1]["robot.py"])
    assert len({each.name for each in made.JOINTS}) == 3
    assert len({made.ROOT, *(each.child for each in made.JOINTS)}) == 4


ORIGINS = [{"@id": f"ex:{each}o", "@type": ["3D", "Euclidean", "Point"]} for each in "abc"]
FRAMES = [
    {
        "@id": f"ex:{each}",
        "@type": ["3D", "Euclidean", "RightHanded", "Frame"],
        "origin": f"ex:{each}o",
    }
    for each in "abc"
]
POSES = [
    {
        "@id": f"ex:{of}{base}",
        "@type": "Pose",
        "of": f"ex:{of}",
        "with-respect-to": f"ex:{base}",
        "quantity-kind": ["Angle", "Length"],
    }
    for of, base in ("ba", "cb", "ca")
]
COORDINATES = [
    {
        "@id": f"ex:{of}{base}-coord",
        "@type": ["PoseReference", "PoseCoordinate", "DirectionCosineXYZ", "VectorXYZ"],
        "of-pose": f"ex:{of}{base}",
        "as-seen-by": f"ex:{base}",
        "unit": ["UNITLESS", "M"],
        "direction-cosine-x": [1.0, 0.0, 0.0],
        "direction-cosine-y": [0.0, 1.0, 0.0],
        "direction-cosine-z": [0.0, 0.0, 1.0],
        **dict(zip("xyz", place, strict=True)),
    }
    for (of, base), place in (("ba", (1.0, 2.0, 3.0)), ("cb", (0.5, 0.0, 0.25)))
]
RESULT = {
    "@id": "ex:ca-coord",
    "@type": ["PoseReference", "PoseCoordinate"],
    "of-pose": "ex:ca",
    "as-seen-by": "ex:a",
}
COMPOSED = {
    "@id": "ex:compose",
    "@type": "ComposePose",
    "in1": "ex:ba-coord",
    "in2": "ex:cb-coord",
    "composite": "ex:ca-coord",
}
SCHEDULE = {"@id": "ex:schedule", "@type": "Schedule", "trigger-chain": ["ex:compose"]}


@pytest.mark.parametrize("library", ["numpy", "kdl"])
def test_a_schedule_needs_no_joint(here, capsys, library):
    context = ["https://w3id.org/kinlint/composable.json", {"ex": "https://example.org/arm#"}]
    nodes = [*ORIGINS, *FRAMES, *POSES, *COORDINATES, RESULT, COMPOSED, SCHEDULE]
    Path("r.jsonld").write_text(json.dumps({"@context": context, "@graph": nodes}))
    assert generate(capsys, "--for", library, "r.jsonld", "-o", "out", "-q") == (0, "", "")
    if library == "numpy":
        made = module(Path("out/robot.py").read_text())
        pose = made.schedule_()["https://example.org/arm#ca"]
        assert pose[:3, 3].tolist() == [1.5, 2.0, 3.25]


@pytest.mark.slow
@pytest.mark.parametrize("library", ["kdl", "numpy", "pinocchio"])
def test_is_the_same_from_elsewhere(here, capsys, library, monkeypatch):
    twins = robot().replace('name="hand"', 'name="base/hand"').replace('"hand"', '"base/hand"')
    Path("in").mkdir()
    Path("in/r.urdf").write_text(twins)
    found = []
    for place, way in ((".", "in/r.urdf"), ("in", "r.urdf"), ("/", str(here / "in" / "r.urdf"))):
        monkeypatch.chdir(here / place)
        out = here / f"out{len(found)}"
        assert generate(capsys, "--for", library, way, "-o", str(out), "-q")[0] == 0
        found.append(written(out))
    assert found[0] == found[1] == found[2]


@pytest.mark.slow
def test_is_the_same_whatever_the_hashes(here):
    models = map(str, sorted((SAMPLES / "one-dof").glob("*.jsonld")))
    command = [sys.executable, "-m", "kinlint", "generate", "--for", "kdl", *models, "-q", "-o"]
    for seed in ("1", "2", "3"):
        environment = {**os.environ, "PYTHONHASHSEED": seed}
        subprocess.run([*command, seed], env=environment, check=True)
    assert written(here / "1") == written(here / "2") == written(here / "3") != {}


@pytest.mark.slow
def test_names_are_spelt(here, capsys):
    from xml.sax.saxutils import quoteattr  # noqa: PLC0415

    text = robot().replace("'j'", quoteattr(HOSTILE, {"\n": "&#10;"}))
    Path("r.urdf").write_text(text, encoding="utf-8")
    assert generate(capsys, "--for", "numpy", "r.urdf", "-o", "out", "-q")[0] == 0
    made = module(Path("out/robot.py").read_text(encoding="utf-8"))
    assert made.POSITIONS == (HOSTILE,)
    assert generate(capsys, "--for", "kdl", "r.urdf", "-o", "kdl", "-q")[0] == 0
    code = Path("kdl/robot.hpp").read_text(encoding="utf-8")
    assert "system" in code
    assert code.isascii()
    assert 'system("' not in code
    assert all(not line.rstrip("\n").endswith("\\") for line in code.splitlines())


@pytest.mark.slow
def test_own_templates(here, capsys):
    Path("r.urdf").write_text(robot())
    Path("own").mkdir()
    Path("own/names.txt.jinja").write_text(
        "{% for each in joint %}{{ each.name | cpp }}{% endfor %}"
    )
    arguments = ("--for", "numpy", "r.urdf", "-o", "out", "--templates", "own")
    assert generate(capsys, *arguments, "-q")[0] == 0
    assert Path("out/names.txt").read_text() == '"j"'
    assert Path("out/robot.py").exists()
    own = Path("own/names.txt.jinja")
    for text, cause in (
        ("{{ joint[0].name }}", "'j' is written without a filter"),
        ("{{ joint[0].nome | cpp }}", "'dict object' has no attribute 'nome'"),
        ("{% if %}", "Expected an expression"),
        ("{{ 1 / 0 }}", "division by zero"),
        ("{{ 'x'.__class__ }}", "access to attribute '__class__'"),
    ):
        own.write_text(f"\n{text}")
        code, _, err = generate(capsys, *arguments)
        assert (code, f"error: template {own}:2: {cause}" in err) == (2, True)


@pytest.mark.slow
def test_stages_are_shown(here, capsys):
    Path("r.urdf").write_text(robot(axis="0 0 2"))
    arguments = ("--for", "pinocchio", "r.urdf", "--fail-on", "error", "--stage")
    code, out, _ = generate(capsys, *arguments, "rewrite")
    assert (code, '<https://w3id.org/kinlint/generation#type> "JointModelRZ" .' in out) == (0, True)
    code, out, _ = generate(capsys, *arguments, "frame")
    (joint,) = json.loads(out)["joint"]
    assert (code, joint["axis"]["z"], joint["child_name"]) == (0, 1.0, "hand")
    assert [each.name for each in here.iterdir()] == ["r.urdf"]


def test_needs_jinja(here, capsys, monkeypatch):
    monkeypatch.setattr("kinlint.cli.generate_command.find_spec", lambda _: None)
    assert generate(capsys, "--for", "numpy", ARM, "-o", "out") == (
        2,
        "",
        "kinlint: error: programs are rendered by Jinja: pip install 'kinlint[generate]'\n",
    )


@pytest.mark.slow
def test_keeps_to_its_directory(here, capsys):
    """What else is there stays, and what is in the way is told."""
    Path("r.urdf").write_text(robot())
    Path("out").mkdir()
    Path("out/notes.txt").write_text("mine")
    arguments = ("--for", "kdl", "r.urdf", "-o", "out", "-q")
    assert generate(capsys, *arguments)[0] == 0
    assert Path("out/notes.txt").read_text() == "mine"
    Path("out/main.cpp").unlink()
    Path("out/main.cpp").mkdir()
    Path("out/robot.hpp").write_text("old")
    code, _, err = generate(capsys, *arguments)
    assert (code, err.count("\n"), "out/main.cpp" in err) == (2, 1, True)
    assert Path("out/robot.hpp").read_text() == "old"
    Path("file").write_text("")
    code, _, err = generate(capsys, *arguments[:3], "-o", "file")
    assert (code, "'file' is no directory" in err) == (2, True)


@pytest.mark.slow
def test_writes_through_no_link(here, capsys):
    Path("r.urdf").write_text(robot())
    Path("out").mkdir()
    Path("kept.py").write_text("kept")
    Path("out/robot.py").symlink_to(here / "kept.py")
    for check in ([], ["--check"]):
        code, _, err = generate(capsys, "--for", "numpy", "r.urdf", "-o", "out", *check)
        assert (code, "is a link" in err) == (2, True)
    assert Path("kept.py").read_text() == "kept"


def test_follows_the_schedule(here, capsys):
    """The sample's pose of the moving link, as its joint coordinates have it."""
    models = map(str, sorted((SAMPLES / "one-dof").glob("*.jsonld")))
    assert generate(capsys, "--for", "numpy", *models, "-o", "out", "-q")[0] == 0
    run = subprocess.run(
        [sys.executable, "out/robot.py"], capture_output=True, text=True, check=True
    )
    (poses,) = json.loads(run.stdout).values()
    assert len(poses) == 3
    assert "expected name=value, with one of" in refusal("q1=0.5")


ALONE = """import json, runpy, sys
before = {*sys.modules}
runpy.run_path("out/robot.py", run_name="__main__")
found = {each.partition(".")[0] for each in {*sys.modules} - before}
assert found - sys.stdlib_module_names == {"numpy"}, found
"""
"""Runs the program in `out`, which may import what Python has, and numpy."""


@pytest.mark.slow
@pytest.mark.parametrize("model", ["urdf/six-axis.urdf", "one-dof/*.jsonld"])
def test_needs_numpy_alone(here, capsys, model):
    models = map(str, sorted(SAMPLES.glob(model)))
    assert generate(capsys, "--for", "numpy", *models, "-o", "out", "-q")[0] == 0
    run = subprocess.run([sys.executable, "-c", ALONE], capture_output=True, check=False)
    assert (run.returncode, run.stderr) == (0, b"")


def refusal(*words: str) -> str:
    """The line by which the program in `out` refuses *words*."""
    command = [sys.executable, "out/robot.py", *words]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    assert (run.returncode, run.stdout, run.stderr.count("\n")) == (1, "", 1)
    return run.stderr


@pytest.mark.slow
def test_programs_refuse_what_is_no_position(here, capsys):
    Path("r.urdf").write_text(robot())
    generate(capsys, "--for", "numpy", "r.urdf", "-o", "out", "-q")
    assert "could not convert string to float: 'fast'" in refusal("fast")
    assert "expected 1 positions, then velocities" in refusal("0.1", "0.2", "0.3", "0.4")
