"""The URDF of an SRDF is found beside it, or where the configuration says."""

import pytest

URDF = '<robot name="{robot}"><link name="base"/></robot>'
SRDF = """<robot name="arm">
<group name="arm"><link name="base"/><link name="tip"/></group>
</robot>"""
FLAGS = ("--select", "CMP", "--output-format", "concise", "--show", "info", "-q")
DANGLING = "arm/config/arm.srdf:2:50: error: The robot has no link named 'tip'. [CMP001]\n"
UNJOINED = "The URDF of robot 'arm' was not found"


@pytest.fixture
def robot(write):
    """An SRDF, and a URDF at a path."""

    def make(path, robot="arm"):
        write("arm/config/arm.srdf", SRDF)
        write(path, URDF.format(robot=robot))

    return make


@pytest.mark.parametrize("folder", ["arm/config", "arm", "arm/urdf", "arm/robots"])
def test_it_is_found_beside(robot, kinlint, folder):
    """In the same folder and in those that packages have."""
    robot(f"{folder}/any.urdf")
    assert kinlint("arm/config/arm.srdf", *FLAGS)[1] == DANGLING


def test_one_that_lies_elsewhere_is_not(robot, kinlint):
    """It may be of another version of the robot."""
    robot("else/arm.urdf")
    assert UNJOINED in kinlint("arm/config/arm.srdf", *FLAGS)[1]


@pytest.mark.parametrize("path", ["arm/urdf/arm.urdf", "arm/urdf/any.urdf"])
def test_another_name_is_a_mismatch(robot, kinlint, path):
    """The file has the same stem, or is the only one of the package."""
    robot(path, "leg")
    out = kinlint("arm/config/arm.srdf", *FLAGS)[1]
    assert "This SRDF is for robot 'arm', but the URDF describes robot 'leg'. [CMP002]" in out
    assert DANGLING in out


def test_what_is_taken_is_told(robot, kinlint):
    """By a related place, and by -v."""
    robot("arm/urdf/arm.urdf")
    asked = ("arm/config/arm.srdf", "--select", "CMP")
    assert "because its file has the same name" in kinlint(*asked)[1]
    told = kinlint(*asked, "-v")[2]
    assert "robot of arm/config/arm.srdf: arm/urdf/arm.urdf, because its file has the" in told


@pytest.mark.slow
def test_nothing_is_reported_of_it(robot, write, kinlint):
    """Unless it is named, too."""
    robot("arm/urdf/arm.urdf")
    bad = URDF.format(robot="arm").replace("</robot>", '<gazebo reference="x"/></robot>')
    write("arm/urdf/arm.urdf", bad)
    alone = kinlint("arm/config/arm.srdf", *FLAGS)[1]
    write("leg.urdf", '<robot name="leg"><link name="foot"/></robot>')
    other = kinlint("arm/config/arm.srdf", "leg.urdf", *FLAGS)[1]
    assert other == alone == DANGLING
    both = kinlint("arm/config/arm.srdf", "arm/urdf/arm.urdf", *FLAGS)[1]
    assert (
        "arm/urdf/arm.urdf:1:57: warning: The robot has no link or joint named 'x'. [CMP006]"
        in both
    )


def test_a_companion_that_cannot_be_read_is_none(robot, write, kinlint):
    """And no error."""
    robot("arm/urdf/arm.urdf")
    write("arm/urdf/arm.urdf", '<robot name="arm"><link name="base"/><link name="tip">')
    code, out, err = kinlint("arm/config/arm.srdf", *FLAGS)
    assert (code, err) == (0, "")
    assert UNJOINED in out


def test_a_source_with_arguments_is_passed_over(robot, write, kinlint):
    """What is in it depends on them."""
    robot("arm/urdf/other.urdf", "other")
    root = '<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">'
    text = f'{root}{{}}<link name="base"/></robot>'
    write("arm/urdf/arm.urdf.xacro", text.format('<xacro:arg name="hand" default="true"/>'))
    assert UNJOINED in kinlint("arm/config/arm.srdf", *FLAGS)[1]
    write("arm/urdf/arm.urdf.xacro", text.format(""))
    assert kinlint("arm/config/arm.srdf", *FLAGS)[1] == DANGLING


def test_the_configuration_says_where(robot, write, kinlint):
    """By a pattern, from where the configuration lies."""
    robot("models/robot.urdf", "leg")
    write("arm/kinlint.toml", '[srdf]\n"config/*.srdf" = "../models/robot.urdf"\n')
    out = kinlint("arm/config/arm.srdf", *FLAGS)[1]
    assert DANGLING in out
    assert "for robot 'arm', but the URDF describes robot 'leg'" in out
    assert "urdf = models/robot.urdf" in kinlint("arm/config/arm.srdf", "--show-settings")[1]


def test_the_configuration_is_wrong(robot, write, kinlint):
    """What it names has to be there."""
    robot("models/robot.urdf")
    write("arm/kinlint.toml", '[srdf]\n"config/*.srdf" = "../models/robo.urdf"\n')
    code, _, err = kinlint("arm/config/arm.srdf", *FLAGS)
    assert code == 2
    assert "srdf: models/robo.urdf: no such file or directory, did you mean 'robot.urdf'?" in err


def test_what_is_given_comes_before_what_lies_beside(robot, write, kinlint):
    """A newer URDF somewhere else."""
    robot("arm/urdf/arm.urdf")
    new = URDF.format(robot="arm").replace("</robot>", '<link name="tip"/></robot>')
    write("new/arm.urdf", new)
    assert kinlint("arm/config/arm.srdf", "new/arm.urdf", *FLAGS)[1] == ""


@pytest.mark.slow
def test_a_target_is_named(write, kinlint):
    """On the command line or in a configuration."""
    text = """<robot name="arm"><link name="base"/><link name="tip"/>
<joint name="fix" type="fixed"><parent link="base"/><child link="tip"/></joint>
<gazebo reference="fix"><sensor name="force" type="force_torque"/></gazebo></robot>"""
    write("arm.urdf", text)
    assert "CMP010" not in kinlint("arm.urdf", *FLAGS)[1]
    assert (
        "arm.urdf:3:20: warning: Joint 'fix' is fixed"
        in kinlint("arm.urdf", *FLAGS, "--target", "gazebo")[1]
    )
    assert kinlint("arm.urdf", "--target", "gazbo")[2].endswith("did you mean 'gazebo'?\n")
    write("kinlint.toml", 'target = ["gazebo"]')
    assert "CMP010" in kinlint("arm.urdf", *FLAGS)[1]


def test_an_srdf_is_told_by_its_content(robot, write, kinlint):
    """Whatever it is called."""
    robot("arm/urdf/arm.urdf")
    write("arm/config/semantics.xml", SRDF)
    out = kinlint("arm/config/semantics.xml", *FLAGS)[1]
    assert out == DANGLING.replace("arm.srdf", "semantics.xml")
