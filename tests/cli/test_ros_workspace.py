"""A ROS workspace is linted as its build tool sees it."""

import pytest
import ros_workspace
from ros_workspace import ARM_FILE, GRIPPER_FILE, SRDF_FILE

FLAGS = ("--output-format", "concise", "-q", "--select", "SRC,TOP,LIM,CMP001", "--show", "info")


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


@pytest.mark.slow
def test_faults_in_it_are_found(faulty, kinlint):
    """With and without a configuration at the top, and when files are named."""
    assert found(kinlint) == LIMIT
    assert found(kinlint, "src") == LIMIT
    assert found(kinlint, ARM_FILE) == LIMIT
    faulty.write("kinlint.toml", "")
    assert found(kinlint) == LIMIT


def test_a_workspace_around(faulty, kinlint, monkeypatch):
    """Below `src`, packages are found from any directory, built or not."""
    monkeypatch.chdir(faulty.top / "src" / "arm_repo")
    limit = "../gripper_repo/my_gripper_description/urdf/gripper.xacro"
    assert found(kinlint, "my_arm_description") == [(limit, "LIM001")]
    faulty.build()
    assert found(kinlint, "my_arm_description") == [(limit, "LIM001")]


@pytest.mark.slow
def test_where_packages_were_found_is_told(ws, kinlint, monkeypatch):
    """By -v, with the way that led there."""
    home = ws.top / "src" / "gripper_repo" / "my_gripper_description"
    told = kinlint("-v")[2]
    assert f"package my_gripper_description: {home}, found in {ws.top}, which is linted" in told
    ws.build()
    monkeypatch.chdir(ws.top / "src" / "arm_repo")
    told = kinlint("-v")[2]
    assert f"package my_gripper_description: {home}, found in the workspace {ws.top}" in told


@pytest.mark.slow
def test_a_missing_package_ends_only_what_depends_on_it(ws, kinlint):
    """The rest is judged, but for what that part may have; a line says how to name it."""
    ws.change(ARM_FILE, "$(find my_gripper", "$(find their_gripper")
    ws.change(ARM_FILE, '<limit lower="-2"', '<limit lower="3"')
    ws.change(ARM_FILE, "</robot>", '<gazebo reference="left_finger"/></robot>')
    ws.write(f"{ARM_FILE}.xacro", (ws.top / ARM_FILE).read_text("utf-8"))
    found = kinlint("--output-format", "concise", "src/arm_repo/my_arm_description")
    codes = [line[-7:-1] for line in found[1].splitlines()[:-1]]
    assert (found[0], codes) == (1, ["LIM001", "LIM001"])
    assert found[2] == (
        "kinlint: warning: package 'their_gripper_description' was not found, which"
        f" {ARM_FILE} and 1 other file name; source its workspace, or add"
        " --package their_gripper_description=DIR\n"
    )
    listed = kinlint("--output-format", "concise", "--show", "info", ARM_FILE)[1]
    assert "4:28: info: Package 'their_gripper_description' was not found" in listed


def test_a_robot_that_lacks_a_package_but_no_part(ws, kinlint):
    """Meshes of a package that is not there change nothing of the robot."""
    mesh = '<visual><geometry><mesh filename="file://$(find nowhere)/a.stl"/></geometry></visual>'
    ws.change(ARM_FILE, "</robot>", f'<link name="free">{mesh}</link></robot>')
    assert found(kinlint, ARM_FILE) == [(ARM_FILE, "SRC014"), (ARM_FILE, "TOP002")]


@pytest.mark.parametrize("place", ["install/my_gripper_description/share", "opt/site-packages"])
def test_findings_in_installed_files_are_counted(ws, kinlint, place):
    """They fail no run; a file that is named is reported as any other."""
    file = ws.top / "src" / "gripper_repo" / "my_gripper_description"
    home = ws.top / place / "my_gripper_description"
    ws.change(GRIPPER_FILE, 'lower="-3" upper="3"', 'lower="3" upper="-3"')
    home.parent.mkdir(parents=True)
    file.rename(home)
    asked = (ARM_FILE, "--package", f"my_gripper_description={home}", "--select", "LIM")
    code, out, _ = kinlint(*asked)
    assert (code, out) == (0, "All checks passed in 1 file; 1 more in installed files.\n")
    assert kinlint(home / "urdf" / "gripper.xacro", *asked)[0] == 1


def test_an_srdf_alone_is_checked_against_a_robot_of_arguments(configured, kinlint):
    """In a package that its own depends on, however its arguments are set elsewhere."""
    configured.change(SRDF_FILE, '"wrist" value="0"', '"wrist" value="9"')
    out = kinlint(SRDF_FILE, "-q", "--output-format", "concise")[1]
    assert "9 is above the upper limit 3 of joint 'wrist'" in out


MACRO = """<robot name="my_arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="my_arm">
    <group name="arm"><joint name="elbow"/><joint name="wrist"/></group>
    <disable_collisions link1="base" link2="forearm" reason="Adjacent"/>
  </xacro:macro>
</robot>
"""
CALL = """<robot name="my_arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="my_arm.xacro"/>
  <xacro:my_arm/>
</robot>
"""


def test_a_file_of_macros_of_an_srdf_is_no_robot(configured, kinlint):
    """Though it has the name of one, and lies beside the SRDF and the YAML."""
    (configured.top / SRDF_FILE).unlink()
    configured.write(f"{CONFIG}my_arm.xacro", MACRO)
    configured.write(f"{CONFIG}my_arm.srdf.xacro", CALL)
    assert kinlint(*FLAGS, "--select", "CMP") == (0, "", "")


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


CONTROLLERS = """controller_manager:
  ros__parameters:
    update_rate: 100
arm_controller:
  ros__parameters:
    joints:
      - {}
      - wrist
    interface_name: position
"""
LIMITS = """joint_limits:
  elbow:
    has_velocity_limits: true
    max_velocity: {}
    has_position_limits: false
    max_position: 9
"""
CONFIG = "src/arm_repo/my_arm_moveit_config/config/"


@pytest.fixture
def configured(ws):
    """The workspace with controllers, limits and first positions, in a package that depends."""
    ws.write(f"{CONFIG}ros2_controllers.yaml", CONTROLLERS.format("elbow"))
    ws.write(f"{CONFIG}joint_limits.yaml", LIMITS.format("1.0"))
    ws.write(f"{CONFIG}initial_positions.yaml", "initial_positions:\n  elbow: 0\n  wrist: 1\n")
    ws.write(f"{CONFIG}other.yaml", "a: &x [1]\nb: *x\n")
    ws.change(
        "src/arm_repo/my_arm_moveit_config/package.xml",
        "</package>",
        "  <exec_depend>my_arm_description</exec_depend>\n</package>",
    )
    return ws


def of_yaml(kinlint, *paths):
    """What is found in YAML files."""
    lines = kinlint(*paths, "--output-format", "concise", "-q", "--select", "CMP")[1].splitlines()
    return [line.removeprefix(CONFIG) for line in lines if ".yaml:" in line]


UNKNOWN = (
    "ros2_controllers.yaml:7:9: error: The robot has no joint named 'elbo'; closest name: 'elbow'."
    " [CMP001]"
)


def test_yaml_that_fits_the_robot(configured, kinlint):
    """Is passed over in silence, as is YAML about other things."""
    assert kinlint(*FLAGS) == (0, "", "")
    assert f"{CONFIG}other.yaml" not in files(kinlint)
    assert files(kinlint, f"{CONFIG}other.yaml") == [f"{CONFIG}other.yaml"]
    assert kinlint(f"{CONFIG}other.yaml", *FLAGS) == (0, "", "")


def test_joints_that_no_robot_has(configured, kinlint):
    """They are found in the whole workspace and in the one file."""
    configured.write(f"{CONFIG}ros2_controllers.yaml", CONTROLLERS.format("elbo"))
    assert of_yaml(kinlint) == [UNKNOWN]
    assert of_yaml(kinlint, f"{CONFIG}ros2_controllers.yaml") == [UNKNOWN]
    # All the names are slips for names of the robot.
    written = CONTROLLERS.format("elbo").replace("- wrist", "- elbow\n      - ellbow")
    configured.write(f"{CONFIG}ros2_controllers.yaml", written)
    assert [each.partition(":")[2][:2] for each in of_yaml(kinlint)] == ["7:", "9:"]


def test_a_configuration_of_a_package_that_depends_on_nothing(configured, kinlint):
    """It is checked against the only robot of the project; without one, `-v` and CMP019 tell it."""
    (configured.top / CONFIG / "../package.xml").write_text("<package><name>a</name></package>")
    name = f"{CONFIG}ros2_controllers.yaml"
    configured.write(name, CONTROLLERS.format("elbo"))
    assert of_yaml(kinlint, name, "--in-project") == [UNKNOWN]
    code, _, err = kinlint(name, "-v")
    assert code == 0
    assert f"robot of {name}: not found" in err
    (told,) = of_yaml(kinlint, name, "--show", "info")
    assert told.endswith("such as 'elbo', so they are not checked. [CMP019]")


CALLS = f"""<robot name="my_arm" {ros_workspace.XMLNS}>
  <xacro:include filename="macro.xacro"/>
  <xacro:arm/>
</robot>
"""


def test_a_robot_of_nothing_but_calls(configured, kinlint):
    """Its file has no link and no joint: it calls the macro of another file that makes them."""
    own = configured.top / ARM_FILE
    text = own.read_text("utf-8").replace(' name="my_arm"', "")
    text = text.replace("  <link", "  <xacro:macro name='arm'>\n  <link", 1)
    configured.write(
        ARM_FILE.replace("my_arm.urdf", "macro"), text.replace("</robot>", "</xacro:macro></robot>")
    )
    own.write_text(CALLS, "utf-8")
    configured.write(f"{CONFIG}ros2_controllers.yaml", CONTROLLERS.format("elbo"))
    assert of_yaml(kinlint) == [UNKNOWN]


def test_limits_wider_than_those_of_the_robot(configured, kinlint):
    """Only those that count."""
    configured.write(f"{CONFIG}joint_limits.yaml", LIMITS.format("2.5"))
    (told,) = of_yaml(kinlint)
    said = "The max_velocity of joint 'elbow' is 2.5, but the robot allows 1.5."
    assert told == f"joint_limits.yaml:4:19: warning: {said} [CMP009]"


def test_which_robot_yaml_is_about_is_told(configured, kinlint):
    """As a related place, and by -v."""
    configured.write(f"{CONFIG}ros2_controllers.yaml", CONTROLLERS.format("elbo"))
    _, out, err = kinlint("-v")
    why = "because it is in a package that this one depends on"
    assert f"robot of {CONFIG}ros2_controllers.yaml: {ARM_FILE}, {why}" in err
    assert f"names are looked up in this robot, {why}" in out


@pytest.mark.slow
def test_the_robot_of_yaml_can_be_configured(configured, kinlint):
    """By the file; and a launch file that names both tells it."""
    configured.write(f"{CONFIG}ros2_controllers.yaml", CONTROLLERS.format("elbo"))
    other = "src/arm_repo/my_arm_description/urdf/other.urdf"
    joints = "".join(
        f'<link name="{name}l"/><joint name="{name}" type="fixed"><parent link="base"/>'
        f'<child link="{name}l"/></joint>'
        for name in ("elbo", "wrist")
    )
    configured.write(other, f'<robot name="other"><link name="base"/>{joints}</robot>')
    assert of_yaml(kinlint) == []
    configured.write("kinlint.toml", f'srdf = {{ "**/ros2_*.yaml" = "{ARM_FILE}" }}')
    assert of_yaml(kinlint) == [UNKNOWN]
    (configured.top / "kinlint.toml").unlink()
    configured.write(
        "src/arm_repo/my_arm_moveit_config/launch/demo.launch.py",
        "xacro = 'urdf/my_arm.urdf.xacro'\ncontrollers = 'config/ros2_controllers.yaml'\n",
    )
    assert of_yaml(kinlint) == [UNKNOWN]


def test_yaml_of_other_robots_is_not_judged(configured, kinlint):
    """Of whose names the robot has hardly any, or which macros make where other arguments are."""
    names = "[front_left_wheel, front_right_wheel, rear_left_wheel]"
    configured.write(f"{CONFIG}wheels.yaml", f"wheels:\n  joints: {names}\n")
    configured.write(f"{CONFIG}left.yaml", "left:\n  joints: [left_elbow, left_wrist, elbow]\n")
    assert of_yaml(kinlint) == []
    configured.change(ARM_FILE, "$(find my_gripper", "$(find their_gripper")
    configured.write(f"{CONFIG}ros2_controllers.yaml", CONTROLLERS.format("elbo"))
    assert of_yaml(kinlint) == []


@pytest.mark.slow
def test_hostile_yaml(configured, kinlint):
    """Aliases that multiply are read once, endless nesting is an error."""
    bomb = "a: &a [x, x]\n" + "".join(
        f"{new}: &{new} [{', '.join([f'*{old}'] * 9)}]\n"
        for old, new in zip("abcdefghijklm", "bcdefghijklmn", strict=True)
    )
    configured.write(f"{CONFIG}bomb.yaml", f"{bomb}joints: *n\n")
    configured.write(f"{CONFIG}loop.yaml", "joints: &a [*a, elbow]\n")
    assert kinlint(*FLAGS) == (0, "", "")
    configured.write(f"{CONFIG}deep.yaml", f"joints: {'[' * 20_000}\n")
    code, out, _ = kinlint(*FLAGS)
    assert code == 2
    assert out.endswith("deep.yaml:1:1: error: nested too deeply\n")


LAUNCHED = """from launch.substitutions import Command, PathJoinSubstitution
from launch_ros.substitutions import FindPackageShare

share = FindPackageShare("my_arm_description")
robot = Command(["xacro ", PathJoinSubstitution([share, "urdf", "my_arm.urdf.xacro"]), " sde:=l"])
params = "config/nav.yaml"
"""
NAVIGATION = """/**:
  ros__parameters:
    global_frame: map
    robot_base_frame: bsae
    # kinlint: ignore[CMP001] mounted at run time
    base_frame_id: bsse
"""


@pytest.mark.slow
def test_a_launch_file_tells_the_robot_and_passes_arguments(configured, kinlint):
    """In a package that depends on nothing; frames of others and ignored names are not told."""
    home = "src/arm_repo/my_arm_bringup/"
    configured.write(f"{home}package.xml", "<package><name>my_arm_bringup</name></package>")
    launch = configured.write(f"{home}launch/arm.launch.py", LAUNCHED)
    configured.write(f"{home}config/nav.yaml", NAVIGATION)
    out = kinlint("--output-format", "concise", "-q", "--select", "CMP,SRC026")[1]
    assert f"{home}config/nav.yaml:4:23: error: The robot has no link named 'bsae'" in out
    assert f"{home}launch/arm.launch.py:5:90: warning: Argument 'sde' is not declared" in out
    assert out.count("nav.yaml") == 1
    assert "robot of " + home + "launch" not in kinlint("-v")[2]
    launch.write_text(LAUNCHED.replace("sde", "prefix"), "utf-8")
    assert "SRC026" not in kinlint("--output-format", "concise", "-q", "--select", "SRC026")[1]


def test_many_missing_packages_are_one_line(ws, kinlint):
    mesh = '<visual><geometry><mesh filename="package://p{}/m.stl"/></geometry></visual>'
    meshes = "".join(f'<link name="l{n}">{mesh.format(n)}</link>' for n in range(5))
    ws.write("many.urdf", f'<robot name="many">{meshes}</robot>')
    assert kinlint("many.urdf")[2] == (
        "kinlint: warning: 5 packages were not found, which 1 file names: 'p0', 'p1', 'p2' and"
        " 2 others; source their workspace, or add --package NAME=DIR\n"
    )
