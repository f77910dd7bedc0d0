"""Programs compute what Pinocchio does: of samples, published models and the URDF of others."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from functools import partial
from pathlib import Path
from xml.sax.saxutils import quoteattr

import numpy as np
import pytest
from data import locate_data
from pinocchio_robots import silence
from programs import lines, module, program, texts

pytest.importorskip("jinja2")
pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("Pinocchio")]

SAMPLES = Path(__file__).resolve().parents[2] / "samples"
TOLERANCE = 1e-9
CONFIGURATIONS = 100
EACH = int(os.environ.get("KINLINT_EACH_ROBOT", "4"))
"""One public robot of so many is compared; `KINLINT_EACH_ROBOT=1` compares all."""
FEWEST = 240 // EACH
"""Of these, programs are made of this many at least."""
COMPILED = 12
"""So many of these have programs for KDL and Pinocchio, too, spread evenly; or else all."""
WHOLE = 1 if EACH == 1 else 25
"""One configuration of so many is compared in twists and forces, too, with numpy."""
TOGETHER = 40
"""So many programs are compiled at once."""
CHOICE = """int main(int, char** words) {
  char* rest[] = {words[0], words[2]};
  return mains[std::atoi(words[1])](2, rest);
}"""
INCLUDED = ("cstdio", "cstdlib", "iostream", "sstream", "string", "vector")
"""What is compiled ahead of the programs, besides what all of them have in common."""
LIBRARIES = ("numpy", "pinocchio")
"""The libraries whose programs are modules of Python."""
INERTIAL = """<inertial><mass value="2"/>
<inertia ixx="0.02" iyy="0.02" izz="0.02" ixy="0" ixz="0" iyz="0"/></inertial>"""
SAME = (
    *(("urdf", "six-axis.urdf"), ("six-axis", "*.jsonld")),
    *(("sdf", "six-axis.sdf"), ("mjcf", "six-axis.xml")),
)


@pytest.fixture(scope="module")
def pin():
    return pytest.importorskip("pinocchio", reason="compares with Pinocchio, PyPI's pin")


@pytest.fixture(scope="module")
def make(tmp_path_factory):
    return partial(program, kept=tmp_path_factory.mktemp("rules"))


class Reference:
    """A robot as Pinocchio reads it, whose joints follow as the program's do."""

    def __init__(self, pin, model, robot) -> None:
        self.pin, self.model, self.robot = pin, model, robot
        self.data = model.createData()
        model.gravity.linear = np.array((0.0, 0.0, -9.81))
        moving = [each for each in robot.JOINTS if each.index >= 0]
        self.spread = np.zeros((model.nv, len(robot.POSITIONS)))
        self.shift = np.zeros(model.nv)
        for each in moving:
            row = model.joints[model.getJointId(each.name)].idx_v
            self.spread[row, each.index] = each.factor
            self.shift[row] = each.offset
        assert len(moving) == model.nv
        self.links = {
            frame.name: model.getFrameId(frame.name, pin.FrameType.BODY)
            for frame in model.frames
            if frame.type == pin.FrameType.BODY
        }

    def move(self, q, *rates):
        """Move to the positions *q*; return all positions and rates as the model has them."""
        pin, model = self.pin, self.model
        full = pin.integrate(model, pin.neutral(model), self.spread @ q + self.shift)
        more = [self.spread @ each for each in rates]
        pin.forwardKinematics(model, self.data, full, *more)
        pin.updateFramePlacements(model, self.data)
        return full, *more

    def poses(self):
        return {name: self.data.oMf[number].homogeneous for name, number in self.links.items()}

    def twists(self):
        kind = self.pin.LOCAL_WORLD_ALIGNED
        return {
            name: self.pin.getFrameVelocity(self.model, self.data, number, kind).vector
            for name, number in self.links.items()
        }


def apart(ours, theirs) -> float:
    """The largest difference of forces, relative to the largest one where that is above one."""
    largest = np.abs(np.asarray(theirs)).max(initial=1.0)
    return np.abs(np.asarray(ours) - theirs).max(initial=0.0) / largest


def worst(ours, theirs) -> float:
    """The largest difference of poses or twists."""
    assert ours.keys() == theirs.keys()
    pairs = ((np.asarray(ours[name]), theirs[name]) for name in theirs)
    return max((np.abs(one - other).max() for one, other in pairs), default=0.0)


def compare(reference, robot, configurations=CONFIGURATIONS) -> float:
    """The largest difference of poses; of twists and forces in some configurations."""
    numbers = np.random.default_rng(20)
    found = 0.0
    for number in range(configurations):
        q, v, a = numbers.uniform(-3.0, 3.0, (3, len(robot.POSITIONS)))
        if number % WHOLE:
            reference.move(q)
            found = max(found, worst(robot.forward_position(q), reference.poses()))
            continue
        state = reference.move(q, v, a)
        twists = reference.twists()
        found = max(
            found,
            worst(robot.forward_position(q), reference.poses()),
            worst(robot.forward_velocity(q, v), twists),
            worst({link: robot.jacobian(q, link) @ v for link in twists}, twists),
        )
        if hasattr(robot, "inverse_dynamics"):
            forces = reference.spread.T @ reference.pin.rnea(
                reference.model, reference.data, *state
            )
            found = max(found, apart(robot.inverse_dynamics(q, v, a), forces))
    return found


@pytest.fixture(scope="module")
def robots(pin, make):
    """The public robots that programs are made of and Pinocchio reads, with its model of each."""
    found = {}
    for path in sorted(locate_data("robots", "urdf").rglob("*.urdf"))[::EACH]:
        text = path.read_bytes()
        if b"<joint" not in text:
            continue
        try:
            with silence():
                model = pin.buildModelFromUrdf(str(path))
        except (RuntimeError, ValueError):  # Pinocchio refuses it
            continue
        errors, files = make({path.name: text}, "numpy", general=False)
        if not errors and files:
            found[str(path)] = model, module(files["robot.py"])
    return found


@pytest.mark.corpus
@pytest.mark.oracle
def test_public_robots_move_as_pinocchio_moves_them(pin, robots):
    assert len(robots) >= FEWEST
    far = {
        path: difference
        for path, (model, robot) in robots.items()
        if (difference := compare(Reference(pin, model, robot), robot)) > TOLERANCE
    }
    assert far == {}
    assert sum(hasattr(robot, "inverse_dynamics") for _, robot in robots.values()) > FEWEST // 3


def spread_over(robots):
    """Some of *robots*, or all if all are compared."""
    return [*robots][:: 1 if EACH == 1 else max(1, len(robots) // COMPILED)]


@pytest.mark.corpus
@pytest.mark.oracle
def test_pinocchio_agrees(pin, robots, make):
    for path in spread_over(robots):
        files = {Path(path).name: Path(path).read_bytes()}
        robot = module(make(files, "pinocchio", general=False)[1]["robot.py"])
        model, reference = robots[path]
        assert robot.POSITIONS == reference.POSITIONS
        assert compare(Reference(pin, model, reference), robot, 25) <= TOLERANCE, path


def flat(poses):
    return {
        name: np.concatenate((pose[:3, 3], pose[:3, :3].ravel())) for name, pose in poses.items()
    }


@pytest.mark.corpus
@pytest.mark.oracle
def test_kdl_agrees(pin, robots, make, tmp_path):
    """Programs are compiled, unoptimised, and move as Pinocchio has it."""
    far = {}
    paths = spread_over(robots)
    for start in range(0, len(paths), TOGETHER):
        some = paths[start : start + TOGETHER]
        texts = [{Path(path).name: Path(path).read_bytes()} for path in some]
        folder = tmp_path / str(start)
        compile_programs([make(each, "kdl", general=False)[1] for each in texts], folder)
        for number, path in enumerate(some):
            command = [folder / "programs", str(number)]
            difference = compare_kdl(Reference(pin, *robots[path]), command)
            if difference > TOLERANCE:
                far[path] = difference
    assert far == {}


def compile_programs(programs, folder):
    """Compile *programs*, each in a namespace of its own, as one that takes the number of one.

    What they include of others is compiled once.
    """
    if not shutil.which("g++") or not Path("/usr/include/kdl/tree.hpp").exists():
        pytest.skip("compiles with KDL, Debian's liborocos-kdl-dev")
    code = [*(f"#include <{each}>" for each in INCLUDED), '#include "0/kinematics.hpp"']
    mains: list[str] = []
    for number, files in enumerate(programs):
        (folder / str(number)).mkdir(parents=True)
        for name, text in files.items():
            if name != "kinematics.hpp" or not number:
                (folder / str(number) / name).write_text(text)
        own = folder / str(number) / "robot.hpp"  # the once of a copy would hold for both
        own.write_text(f"// {number}\n{own.read_text()}")
        code.append(f'namespace n{number} {{\n#include "{number}/main.cpp"\n}}')
        mains.append(f"n{number}::main")
    code.append(f"int (*const mains[])(int, char**) = {{ {', '.join(mains)} }};")
    code.append(CHOICE)
    (folder / "programs.cpp").write_text("\n".join(code))
    options = ["-std=c++17", "-O0", "-I/usr/include/eigen3", "-I0"]
    command = ["g++", *options, "programs.cpp", "-o", "programs", "-lorocos-kdl"]
    subprocess.run(command, cwd=folder, check=True)


def compare_kdl(reference, command) -> float:
    """The largest difference of what *command* prints of poses, twists and forces."""
    count = len(reference.robot.POSITIONS)
    given = np.random.default_rng(21).uniform(-3.0, 3.0, (CONFIGURATIONS, 3, count))
    stdin = "".join(" ".join(map(repr, each.ravel().tolist())) + "\n" for each in given)
    run = subprocess.run([*command, "-"], input=stdin, capture_output=True, text=True, check=True)
    printed = lines(run.stdout)
    assert len(printed) == CONFIGURATIONS
    found = 0.0
    for line, (q, v, a) in zip(printed, given, strict=True):
        state = reference.move(q, v, a)
        found = max(found, worst(line["poses"], flat(reference.poses())))
        if count:  # without a position, there is nothing to give velocities of
            found = max(found, worst(line["twists"], reference.twists()))
        if hasattr(reference.robot, "inverse_dynamics") and count:
            forces = reference.pin.rnea(reference.model, reference.data, *state)
            found = max(found, apart(line["forces"], reference.spread.T @ forces))
    return found


@pytest.mark.parametrize("library", LIBRARIES)
def test_one_robot_in_four_formats(pin, make, library):
    """The samples describe one arm."""
    found = []
    for place, name in SAME:
        home = SAMPLES / place
        files = {str(path): path.read_bytes() for path in sorted(home.glob(name))}
        errors, files = make(files, library)
        assert errors == []
        found.append(module(files["robot.py"]))
    numbers = np.random.default_rng(22)
    for _ in range(CONFIGURATIONS):
        q, v, a = numbers.uniform(-3.0, 3.0, (3, 6))
        wrists = [each.forward_position(q)["wrist"] for each in found]
        assert all(apart(wrist, wrists[0]) <= TOLERANCE for wrist in wrists)
        forces = [each.inverse_dynamics(q, v, a) for each in found]
        assert all(apart(each, forces[0]) <= TOLERANCE for each in forces)


@pytest.mark.parametrize("library", ["numpy", "pinocchio", "kdl"])
def test_the_kinova_arm(pin, make, library, tmp_path):
    """Its chain is complete, so it is compared with what its poses say, read for themselves."""
    home = locate_data("comp-rob2b", "robot-models", "kinova", "gen3", "7dof")
    models = texts(sorted(home.glob("robot.*.json")))
    errors, files = make(models, "numpy" if library == "kdl" else library, general=False)
    assert errors == []
    robot = module(files["robot.py"])
    nodes = json.loads((home / "robot.geom.json").read_text())["@graph"]
    poses = {each["of-pose"]: each for each in nodes if "of-pose" in each}
    model = pin.Model()
    for number in range(7):
        name = f"rob:pose-link{number}-joint{number + 1}-wrt-link{number}-root"
        at = poses[name]
        turn = np.array([at[f"direction-cosine-{axis}"] for axis in "xyz"]).T
        placement = pin.SE3(turn, np.array([at[axis] for axis in "xyz"]))
        joint = model.addJoint(number, pin.JointModelRZ(), placement, f"joint{number + 1}")
        frame = pin.Frame(f"link{number + 1}", joint, pin.SE3.Identity(), pin.FrameType.BODY)
        model.addFrame(frame)
    model.addFrame(pin.Frame("link0", 0, pin.SE3.Identity(), pin.FrameType.BODY))
    reference = Reference(pin, model, robot)
    if library != "kdl":
        assert compare(reference, robot) <= TOLERANCE
        return
    compile_programs([make(models, library, general=False)[1]], tmp_path)
    assert compare_kdl(reference, [tmp_path / "programs", "0"]) <= TOLERANCE


NAMES = (
    *("class", "int", "np", "main", "a b", "a-b", "a_b", "a_b_2", "__init__", "0", "KDL::Frame"),
    *('"; std::abort(); //', "*/ #error", "\\", "??/", "ü关节\U0001f916", "\n#error\n", "\t"),
    *("'''", '"""', "{{ 7 }}", "{% raw %}", "%s", 'R"(', "\u2028", "//\\", "NoName"),
)
"""Names of links and of joints that would break a program that wrote them down as they are."""


def test_any_name(pin, make, tmp_path):
    attribute = partial(quoteattr, entities={"\n": "&#10;", "\t": "&#9;"})
    parts = [f"<robot name={attribute(NAMES[-10])}>"]
    for number, name in enumerate(NAMES):
        parts.append(f"<link name={attribute(name)}>{INERTIAL}</link>")
        ends = f"<parent link={attribute(NAMES[number - 1])}/><child link={attribute(name)}/>"
        joint = f"<joint name={attribute(name)} type='continuous'>{ends}<axis xyz='0 1 0'/></joint>"
        parts += [joint] * (number > 0)
    text = {'r"*/\\.urdf': "".join([*parts, "</robot>"]).encode()}
    modules = [module(make(text, each, general=False)[1]["robot.py"]) for each in LIBRARIES]
    assert all(each.POSITIONS == NAMES[1:] for each in modules)
    compile_programs([make(text, "kdl", general=False)[1]], tmp_path)
    run = subprocess.run(
        [tmp_path / "programs", "0", "-"],
        input=" ".join(["0.1"] * 3 * (len(NAMES) - 1)),
        capture_output=True,
        text=True,
        check=True,
    )
    (found,) = lines(run.stdout)
    q = np.full(len(NAMES) - 1, 0.1)
    for each in modules:
        assert worst(found["poses"], flat(each.forward_position(q))) <= TOLERANCE
        assert worst(found["twists"], each.forward_velocity(q, q)) <= TOLERANCE
        assert apart(found["forces"], each.inverse_dynamics(q, q, q)) <= TOLERANCE
