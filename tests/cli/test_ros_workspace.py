"""A ROS workspace is linted as its build tool sees it."""

import pytest
import ros_workspace
from ros_workspace import ARM_FILE, GRIPPER_FILE, SRDF_FILE

FLAGS = ("--output-format", "concise", "-q", "--select", "SRC,TOP,LIM,CMP001")


@pytest.fixture
def ws(here, monkeypatch):
    """A workspace with two repositories, linted from its top."""
    for name in ("AMENT_PREFIX_PATH", "ROS_PACKAGE_PATH", "CMAKE_PREFIX_PATH"):
        monkeypatch.delenv(name, raising=False)
    made = ros_workspace.make(here / "ws")
    monkeypatch.chdir(made.top)
    return made


@pytest.fixture
def faulty(ws):
    """The same, with a limit upside down in one repository."""
    ws.change(GRIPPER_FILE, 'lower="-3" upper="3"', 'lower="3" upper="-3"')
    return ws


def found(kinlint, *paths):
    """The codes found, and the files they are in."""
    lines = kinlint(*paths, *FLAGS)[1].splitlines()
    return sorted((line.split(":")[0], line[-7:-1]) for line in lines)


LIMIT = [(GRIPPER_FILE, "LIM001")]


def test_a_workspace_of_several_repositories(ws, kinlint):
    """Packages of one repository are known in the other, built or not."""
    assert kinlint(*FLAGS) == (0, "", "")
    ws.build()
    assert kinlint(*FLAGS) == (0, "", "")


def test_faults_in_it_are_found(faulty, kinlint):
    """With and without a configuration at the top, and when files are named."""
    assert found(kinlint) == LIMIT
    assert found(kinlint, "src") == LIMIT
    assert found(kinlint, ARM_FILE) == LIMIT
    faulty.write("kinlint.toml", "")
    assert found(kinlint) == LIMIT


def test_a_workspace_around(faulty, kinlint, monkeypatch):
    """Once there is `src` beside `install`, packages are found from any directory of it."""
    monkeypatch.chdir(faulty.top / "src" / "arm_repo")
    assert found(kinlint, "my_arm_description") == [
        ("my_arm_description/urdf/my_arm.urdf.xacro", "SRC014")
    ]
    faulty.build()
    limit = "../gripper_repo/my_gripper_description/urdf/gripper.xacro"
    assert found(kinlint, "my_arm_description") == [(limit, "LIM001")]


def test_where_packages_were_found_is_told(ws, kinlint, monkeypatch):
    """By -v, with the way that led there."""
    home = ws.top / "src" / "gripper_repo" / "my_gripper_description"
    told = kinlint("-v")[2]
    assert f"package my_gripper_description: {home}, found in {ws.top}, which is linted" in told
    ws.build()
    monkeypatch.chdir(ws.top / "src" / "arm_repo")
    told = kinlint("-v")[2]
    assert f"package my_gripper_description: {home}, found in the workspace {ws.top}" in told
    ws.change(ARM_FILE, "my_gripper_description", "their_gripper_description")
    told = kinlint("-v")[2]
    assert (
        "package their_gripper_description: not found, named by"
        " my_arm_description/urdf/my_arm.urdf.xacro\n"
    ) in told


def test_the_srdf_is_checked_against_the_robot_of_the_other_package(ws, kinlint):
    """A joint that it lacks is found."""
    ws.change(SRDF_FILE, '<joint name="elbow"/>', '<joint name="elbo"/>')
    assert found(kinlint) == [(SRDF_FILE, "CMP001")]


def files(kinlint, *paths):
    """The files that would be linted."""
    return kinlint("--show-files", *paths)[1].splitlines()


@pytest.mark.parametrize("marker", ["COLCON_IGNORE", "AMENT_IGNORE", "CATKIN_IGNORE", ".catkin"])
def test_what_build_tools_ignore(ws, kinlint, marker):
    """Unless it is named."""
    before = files(kinlint)
    ws.write(f"src/arm_repo/old/{marker}", "")
    old = ws.write("src/arm_repo/old/arm.urdf", "<robot name='old'/>")
    assert files(kinlint) == before
    assert "src/arm_repo/old/arm.urdf" not in files(kinlint, "src/**/*.urdf")
    assert files(kinlint, old.parent) == files(kinlint, old) == ["src/arm_repo/old/arm.urdf"]


@pytest.mark.parametrize("space", ["build", "install", "log"])
def test_what_is_built(ws, kinlint, space):
    """With and without the mark that colcon leaves."""
    before = files(kinlint)
    ws.build()
    (ws.top / space / "COLCON_IGNORE").unlink()
    assert files(kinlint) == before
    copy = ws.write(f"{space}/arm.urdf", "<robot name='old'/>")
    assert files(kinlint, copy) == [f"{space}/arm.urdf"]


def test_what_git_ignores(ws, kinlint):
    """Unless it is named, or asked for by option or configuration."""
    before = files(kinlint)
    ws.write("src/arm_repo/.gitignore", "generated/\n*.bak.urdf\n")
    for name in ("generated/arm.urdf", "arm.bak.urdf"):
        ws.write(f"src/arm_repo/{name}", "<robot name='old'/>")
    both = ["src/arm_repo/arm.bak.urdf", "src/arm_repo/generated/arm.urdf"]
    assert files(kinlint) == before
    assert files(kinlint, "src/**/*.urdf") == []
    assert files(kinlint, *both) == both
    assert files(kinlint, "src/arm_repo/generated") == both[1:]
    assert files(kinlint, "--no-respect-gitignore") == sorted((*before, *both))
    ws.write("src/kinlint.toml", "respect-gitignore = false")
    assert files(kinlint) == sorted((*before, *both))
    assert files(kinlint, "--respect-gitignore") == before
