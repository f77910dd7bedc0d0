"""What a conversion leaves out is told, by kind and with the reason."""

from __future__ import annotations

from support.linting import document

from kinlint.conversion.composition import compose

LINE = "only of joints that move along or about one line"


def lost(inside: str, name: str = "robot.urdf") -> dict[str, str]:
    """What is left out of a robot with *inside*, each with count and reason."""
    text = (
        inside if inside.startswith("<sdf") else f'<robot name="r"><link name="a"/>{inside}</robot>'
    )
    model = compose([document(text, name)])
    return {loss.what: f"{loss.count}: {loss.why}" for loss in model.losses}


def test_nothing_is_lost_of_what_is_lifted():
    assert (
        lost(
            """<link name="b"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1"
        iyz="0" izz="1"/></inertial><visual name="v"><geometry><box size="1 2 3"/></geometry>
        </visual></link><joint name="j" type="revolute"><parent link="a"/><child link="b"/>
        <origin xyz="1 2 3" rpy="0.1 0.2 0.3"/><axis xyz="0 0 1"/>
        <limit lower="-1" upper="1" effort="2" velocity="3"/></joint>"""
        )
        == {}
    )


def test_elements_and_attributes_that_are_not_lifted():
    found = lost(
        """<material name="red"/><material name="blue"/><link name="b" type="arm"><visual><geometry>
        <box size="1 1 1"/></geometry><material name="red"/></visual></link>"""
    )
    assert found["'robot/material'"].startswith("2: how a body looks")
    assert found["'visual/material'"].startswith("1: how a body looks")
    assert found["'link/@type'"] == "1: no reader gives it a meaning"


def test_root_that_stands_still():
    nothing = """<inertial><mass value="0"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0"
        izz="1"/></inertial>"""
    moved = '<joint name="j" type="prismatic"><parent link="b"/><child link="a"/></joint>'
    assert lost(f'<link name="b">{nothing}</link>{moved}') == {
        "'link/inertial'": "1: the root stands still and has no mass"
    }
    assert lost(f'<link name="b">{nothing}</link>{moved.replace("prismatic", "fixed")}') == {}
    turned = moved.replace("parent", "x").replace("child", "parent").replace("x link", "child link")
    assert lost(f'<link name="b">{nothing}</link>{turned}') == {}


def test_what_has_no_meaning_for_its_joint():
    found = lost(
        """<link name="b"/><joint name="j" type="fixed"><parent link="a"/><child link="b"/>
        <axis xyz="0 0 0"/><limit lower="0" upper="0"/></joint>"""
    )
    assert found["'joint/axis'"].startswith(f"1: {LINE}")
    assert found["'joint/limit'"] == f"1: {LINE}"


def test_values_without_a_meaning_for_their_joint():
    found = lost(
        """<link name="b"/><joint name="j" type="continuous"><parent link="a"/><child link="b"/>
        <limit lower="-3" upper="3" effort="5" velocity="7"/></joint>"""
    )
    reason = "1: a continuous joint has no end of its range"
    assert found == {"'limit/@lower'": reason, "'limit/@upper'": reason}


def test_what_counts_from_a_later_version_on():
    capsule = """<link name="b"><collision><geometry><capsule radius="1" length="2"/></geometry>
        </collision></link>"""
    assert lost(capsule) == {"'geometry/capsule'": "1: there are capsules from version 1.1 on"}


def test_what_is_malformed_unknown_or_repeated():
    found = lost(
        """<link name="b"><inertial><mass value="1,5"/></inertial><colision/></link>
        <joint name="j" type="fixed"><parent link="a"/><child link="b"/><origin xyz="1 0 0"/>
        <origin xyz="2 0 0"/></joint>"""
    )
    assert found["malformed values"] == "1: kinlint check lists the places"
    assert found["'link/colision'"] == "1: the format has no such thing here"
    assert found["'joint/origin'"] == "1: the first of several counts"


def test_sdf():
    found = lost(
        """<sdf version="1.9"><model name="m"><static>true</static><link name="a"><pose>1 0 0 0 0 0
        </pose><sensor name="s" type="imu"/></link></model></sdf>""",
        "model.sdf",
    )
    assert set(found) == {"'model/static'", "'link/sensor'"}


def test_nothing_is_said_of_where_a_sensor_is():
    text = """<sdf version="1.9"><model name="m"><link name="a"><sensor name="s" type="imu">
        <pose>1 0 0 0 0 0</pose></sensor></link></model></sdf>"""
    nodes = compose([document(text, "model.sdf")]).nodes
    assert [each["@id"] for each in nodes if "sensor" in str(each)] == []


def test_what_is_to_be_included_and_is_not_there():
    found = lost(
        """<sdf version="1.9"><model name="m"><link name="a"/><include><name>tool</name>
        <uri>https://example.org/tool</uri></include></model></sdf>""",
        "model.sdf",
    )
    assert found["included files that are not there"] == "1: kinlint check lists the places"
