"""`kinlint diff`: what differs between two descriptions of a robot, and its exit codes."""

import json

import pytest
from facts.arm_in_formats import Arm, urdf
from gitting import git, needs_git

ARM = """\
<robot name="arm">
  <link name="base"/>
  <link name="forearm">
    <inertial>
      <origin xyz="0 0 0.2"/>
      <mass value="2.1"/>
      <inertia ixx="0.02" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.01"/>
    </inertial>
  </link>
  <link name="tool"/>
  <joint name="elbow" type="revolute">
    <origin xyz="0 0 0.1"/>
    <parent link="base"/>
    <child link="forearm"/>
    <axis xyz="0 1 0"/>
    <limit lower="-1" upper="1.5" effort="2" velocity="3"/>
  </joint>
  <joint name="flange" type="fixed">
    <origin xyz="0 0 0.85"/>
    <parent link="forearm"/>
    <child link="tool"/>
  </joint>
</robot>
"""
HEAVY = ARM.replace("2.1", "2.4").replace("0.85", "0.87").replace('upper="1.5"', 'upper="1.6"')


@pytest.fixture(autouse=True)
def robots(write):
    """An arm, and the same with another mass, length and limit."""
    write("old.urdf", ARM)
    write("new.urdf", HEAVY)


def test_differences_are_told_in_physical_terms(kinlint):
    """Each once, with both places; the exit code is that of diff."""
    code, out, err = kinlint("diff", "old.urdf", "new.urdf")
    assert (code, err) == (1, "")
    assert out.splitlines() == [
        "old.urdf -> new.urdf (1 of 1 and 1 joints in common)",
        "  robot",
        "    mass 2.1 to 2.4 kg",
        "    reach 0.85 to 0.87 m",
        "  joint 'elbow'",
        "    upper limit 1.5 to 1.6 rad (85.9437° to 91.6732°)  old.urdf:16, new.urdf:16",
        "  link 'forearm'",
        "    mass 2.1 to 2.4 kg  old.urdf:6, new.urdf:6",
        "  joint 'flange'",
        "    origin (0, 0, 0.85) to (0, 0, 0.87) m (0.02 m apart)  old.urdf:18, new.urdf:18",
        "",
        "3 differences.",
    ]


@pytest.mark.slow
def test_the_same_robot_gives_zero(kinlint, write):
    """Layout and the order of elements say nothing about the robot."""
    write("same.urdf", ARM.replace("\n  ", " \n\n "))
    assert kinlint("diff", "old.urdf", "same.urdf")[0] == 0
    assert kinlint("diff", "old.urdf", "old.urdf")[1].endswith("No differences.\n")


@pytest.mark.slow
def test_what_cannot_be_read_is_told_as_it_is_written(kinlint, write):
    """A decimal comma is no number, and what follows from it is no difference of its own."""
    write("comma.urdf", ARM.replace('upper="1.5"', 'upper="1,5"'))
    code, out, _ = kinlint("diff", "old.urdf", "comma.urdf")
    assert code == 1
    assert out.splitlines()[1:] == [
        "  not read, so as if it were not given",
        "    <limit upper> is '1,5', decimal comma in 1,5  comma.urdf:16",
        "",
        "1 difference.",
    ]
    assert kinlint("diff", "comma.urdf", "comma.urdf")[0] == 0
    told = json.loads(kinlint("diff", "comma.urdf", "old.urdf", "--output-format", "json")[1])
    assert told[0]["changes"][0]["quantity"] == "<limit upper>"


@pytest.mark.slow
def test_dependencies_of_joints_are_compared(kinlint, write):
    """By the joint that is followed, the factor and the offset; one that came is told, too."""
    gripper = """<robot name="gripper"><link name="palm"/><link name="left"/><link name="right"/>
<joint name="a" type="prismatic"><parent link="palm"/><child link="left"/><axis xyz="0 1 0"/>
<limit lower="0" upper="0.1" effort="1" velocity="1"/></joint>
<joint name="b" type="prismatic"><parent link="palm"/><child link="right"/><axis xyz="0 1 0"/>
<limit lower="0" upper="0.1" effort="1" velocity="1"/></joint></robot>"""
    follow = '<mimic joint="a" multiplier="-1"/></joint></robot>'
    write("free.urdf", gripper)
    write("tied.urdf", gripper.replace("</joint></robot>", follow))
    write("slow.urdf", gripper.replace("</joint></robot>", follow.replace("-1", "-0.5")))
    told = kinlint("diff", "tied.urdf", "slow.urdf")[1].splitlines()
    assert told[1:3] == ["  joint 'b'", "    multiplier -1 to -0.5  tied.urdf:5, slow.urdf:5"]
    code, out, _ = kinlint("diff", "free.urdf", "tied.urdf")
    assert (code, "mimic only in the new one, in the old one not given: 'b'" in out) == (1, True)


def test_other_names_of_the_same_parts_are_differences(kinlint, write):
    """Controllers and plans name joints and links."""
    arm = Arm()
    write("one.urdf", urdf(arm))
    write(
        "other.urdf", urdf(arm.with_change("elbow", name="bend").with_change("hand", name="tool"))
    )
    code, out, _ = kinlint("diff", "one.urdf", "other.urdf")
    assert code == 1
    told = [line.strip().partition("  ")[0] for line in out.splitlines()[1:5]]
    assert told == [
        "joint 'elbow' (now 'bend')",
        "name elbow to bend",
        "link 'hand' (now 'tool')",
        "name hand to tool",
    ]


@pytest.mark.slow
def test_of_two_revisions_each_link_counts_by_itself(kinlint, write):
    """What is fixed to a link does not make that heavier, and a joint that stops is no other."""
    mount = '</joint><joint name="mount" type="fixed"><parent link="forearm"/>'
    lamp = '<link name="lamp"><inertial><mass value="0.2"/></inertial></link>'
    write("lit.urdf", ARM.replace("</joint>\n</r", f'{mount}<child link="lamp"/></joint>{lamp}</r'))
    write("stiff.urdf", ARM.replace("revolute", "fixed"))
    lit, stiff = (kinlint("diff", "old.urdf", each)[1] for each in ("lit.urdf", "stiff.urdf"))
    assert "  + link 'lamp' (fixed, 0.2 kg)  lit.urdf:22" in lit
    assert "forearm" not in lit
    assert "    movement revolute to fixed  old.urdf:11, stiff.urdf:11" in stiff
    assert "1 difference." in lit
    assert "1 difference." in stiff


def test_what_a_revision_leaves_out_is_a_difference(kinlint, write):
    """Of two files in one format, one lost what the other says."""
    write("light.urdf", ARM.replace('<mass value="2.1"/>', ""))
    code, out, _ = kinlint("diff", "old.urdf", "light.urdf")
    assert code == 1
    assert "mass only in the old one, in the new one not given: 'forearm'" in out
    assert out.endswith("1 difference.\n")


@pytest.mark.parametrize("command", [("diff", "old.urdf"), ("convert",), ("targets", "--matrix")])
def test_a_file_that_cannot_be_parsed_is_an_error_with_its_place(command, kinlint, write):
    """The cause is that of the text, not that no robot was found."""
    write("cut.urdf", ARM[:300])
    code, out, err = kinlint(*command, "cut.urdf")
    assert (code, out) == (2, "")
    assert "cut.urdf:11:4: <joint> is never closed" in err


def test_robots_on_other_links_reach_as_they_did(kinlint, write):
    """A robot written from its other end is the same; its reach is not compared."""
    turned = ARM.replace('<parent link="base"/>', '<parent link="forearm"/>')
    turned = turned.replace(
        '<child link="forearm"/>\n    <axis xyz="0 1 0"',
        '<child link="base"/>\n    <axis xyz="0 -1 0"',
    )
    assert kinlint("diff", "old.urdf", write("turned.urdf", turned).name)[1].count("reach") == 0


def test_trouble_gives_two(kinlint, write):
    """Files that are not there, that describe no robot, or only one of them."""
    write("empty.urdf", "<robot name='none'/>")
    assert kinlint("diff", "old.urdf", "missing.urdf")[0] == 2
    assert kinlint("diff", "old.urdf", "empty.urdf")[0] == 2
    assert kinlint("diff", "old.urdf")[0] == 2
    assert kinlint("diff", "old.urdf", ".")[0] == 2
    assert kinlint("diff", "old.urdf", "new.urdf", "--tolerance", "loose")[0] == 2


@pytest.mark.slow
def test_tolerances_decide_what_counts(kinlint, write):
    """Files of one format differ by any number, unless rounding is to be forgiven."""
    write("rounded.urdf", ARM.replace("2.1", "2.101"))
    assert kinlint("diff", "old.urdf", "rounded.urdf")[0] == 1
    assert kinlint("diff", "old.urdf", "rounded.urdf", "--tolerance", "rounded")[0] == 0


def test_numbers_have_the_digits_that_tell_them_apart(kinlint, write):
    write("hair.urdf", ARM.replace("2.1", "2.10000001"))
    assert "mass 2.1 to 2.10000001 kg" in kinlint("diff", "old.urdf", "hair.urdf")[1]


def test_json_has_values_and_places(kinlint):
    (found,) = json.loads(kinlint("diff", "old.urdf", "new.urdf", "--format=json")[1])
    assert (found["old"], found["new"], found["differs"]) == ("old.urdf", "new.urdf", True)
    assert found["joints"] == {"common": 1, "old": 1, "new": 1}
    mass = next(each for each in found["changes"] if each["part"] == "forearm")
    assert (mass["quantity"], mass["old"], mass["new"], mass["unit"]) == ("mass", 2.1, 2.4, "kg")
    assert mass["newPlace"]["line"] == 6


@pytest.mark.slow
def test_markdown_and_html_show_the_same_changes(kinlint, write):
    """Names are escaped; the page is well-formed as far as it is a table, and loads nothing."""
    odd = ARM.replace("forearm", "fore|&lt;b&gt;arm")
    write("odd.urdf", odd)
    write("odder.urdf", odd.replace("2.1", "2.4"))
    shown = kinlint("diff", "odd.urdf", "odder.urdf", "--output-format", "markdown")[1]
    assert "fore\\|&lt;b\\>arm" in shown
    assert "| mass 2.1 to 2.4 kg |" in shown
    page = kinlint("diff", "odd.urdf", "odder.urdf", "--output-format", "html")[1]
    assert "<b>arm" not in page
    assert "mass 2.1 to 2.4 kg" in page
    assert "default-src 'none'" in page


def test_the_suffix_of_the_output_file_decides_the_format(kinlint, here):
    """As for other commands; the exit code stays."""
    assert kinlint("diff", "old.urdf", "new.urdf", "-o", "report.md")[0] == 1
    assert (here / "report.md").read_text("utf-8").startswith("**3 differences")


def test_directories_are_compared_pairwise(kinlint, write):
    """By name, then by stem; a file that only one of them has is a difference."""
    for name, text in (("a/x.urdf", ARM), ("a/y.urdf", ARM), ("b/x.urdf", ARM), ("b/z.urdf", ARM)):
        write(name, text)
    code, out, _ = kinlint("diff", "a", "b")
    assert code == 1
    assert out.splitlines() == [
        "only in old: a/y.urdf",
        "",
        "only in new: b/z.urdf",
        "",
        "2 differences.",
    ]


def test_what_a_format_cannot_state_is_told_apart(kinlint, write):
    """MJCF has no speed limits; another joint without effort was merely not given one."""
    mjcf = """<mujoco model="arm"><compiler angle="radian"/><worldbody>
        <body name="forearm" pos="0 0 0.1">
        <joint name="elbow" axis="0 1 0" range="-1 1.5"/>
        <inertial pos="0 0 0.2" mass="2.1" diaginertia="0.02 0.02 0.01"/>
        <body name="tool" pos="0 0 0.85"/></body></worldbody></mujoco>"""
    write("arm.xml", mjcf)
    code, out, _ = kinlint("diff", "old.urdf", "arm.xml")
    assert code == 0
    assert "effort limit only in the old one, in the new one not given: 'elbow'" in out


@needs_git
def test_revisions_are_compared_with_files(kinlint, here, write):
    """`REVISION:PATH` as git knows it, by that name."""
    git(here, "init")
    git(here, "add", "old.urdf")
    git(here, "commit", "-m", "arm")
    write("old.urdf", HEAVY)
    code, out, _ = kinlint("diff", "HEAD:old.urdf", "old.urdf")
    assert code == 1
    assert "mass 2.1 to 2.4 kg  HEAD:old.urdf:6, old.urdf:6" in out
    assert kinlint("diff", "HEAD:gone.urdf", "old.urdf")[0] == 2
    assert kinlint("diff", "nowhere:old.urdf", "old.urdf")[0] == 2
