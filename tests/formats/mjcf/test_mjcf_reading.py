"""MJCF is assembled from its files, and its values are those that count in the end."""

from __future__ import annotations

import pytest
from reading_mjcf import file, model, node, nodes, numbers, values, whole, written

from kinlint.formats.recognition import recognise
from kinlint.terms import RDF_TYPE, iri, literal_value
from kinlint.vocabulary import SRC

SAID = iri(f"{SRC}resembles")

ARM = '<worldbody><body name="arm">{}<geom size="0.1"/></body></worldbody>'


@pytest.mark.parametrize("text", ["<mujoco/>", "<!-- a --><mujoco model='a'>", "<mujocoinclude>"])
def test_it_is_recognised_by_its_root(text: str) -> None:
    found = recognise("robot.xml", text)
    assert found is not None
    assert found.name == "mjcf"


def test_a_urdf_with_settings_for_mujoco_is_a_urdf() -> None:
    text = '<robot name="a"><mujoco><compiler/></mujoco><link name="b"/></robot>'
    found = recognise("robot.xml", text)
    assert found is not None
    assert found.name == "urdf"


def test_a_number_comes_from_the_class_and_is_where_that_is_written() -> None:
    text = '<default><default class="big"><joint range="-12.5 3"/></default></default>'
    read = model(text + ARM.format('<joint name="j" class="big"/>'))
    joint = node(read, "worldbody/body/arm/joint/j")
    assert numbers(read, joint, "inh:range", "1 2") == [-12.5, 3]
    assert written(read, joint, "inh:range-1") == "-12.5"
    assert values(read, joint, "src:limited") == ["true"]


def test_what_an_element_says_itself_is_not_inherited() -> None:
    text = '<default><joint damping="3" range="1 2"/></default>'
    read = model(text + ARM.format('<joint name="j" range="0 1"/>'))
    joint = node(read, "worldbody/body/arm/joint/j")
    assert values(read, joint, "inh:damping-1") == ["3"]
    assert values(read, joint, "inh:range-1") == []


def test_the_class_of_the_body_around_holds_for_its_own_joints() -> None:
    text = '<default><default class="a"><joint damping="7"/></default></default>'
    read = model(
        text + '<worldbody><body name="arm" childclass="a"><joint name="j"/><freejoint name="f"/>'
        '<frame childclass="main"><joint name="k"/></frame></body></worldbody>'
    )
    damping = {
        name: values(read, node(read, f"worldbody/body/arm/{path}"), "inh:damping-1")
        for name, path in (("j", "joint/j"), ("f", "freejoint/f"), ("k", "frame/joint/k"))
    }
    assert damping == {"j": ["7"], "f": [], "k": []}


def test_an_inner_class_has_what_the_outer_one_says_behind_it() -> None:
    text = '<default><default class="a"><joint/></default><joint damping="2"/></default>'
    read = model(text + ARM.format('<joint name="j" class="a"/>'))
    assert values(read, node(read, "worldbody/body/arm/joint/j"), "inh:damping-1") == ["2"]


def test_an_orientation_replaces_that_of_the_class_whatever_its_form() -> None:
    text = '<default><geom euler="90 0 0"/></default>'
    read = model(text + ARM.format('<geom name="g" quat="1 0 0 0" size="1"/>'))
    geom = node(read, "worldbody/body/arm/geom/g")
    assert numbers(read, geom, "src:placed", "qx qy qz qw") == [0, 0, 0, 1]


def test_shortcuts_take_gains_of_their_own_kind_and_ranges_of_any() -> None:
    text = '<default><position kp="9" ctrlrange="-1 1"/></default>'
    drive = '<actuator><motor name="m" joint="j"/></actuator>'
    read = model(text + ARM.format('<joint name="j"/>') + drive)
    motor = node(read, "actuator/motor/m")
    assert values(read, motor, "inh:ctrlrange-2") == ["1"]
    assert values(read, motor, "inh:kp") == []
    assert values(read, motor, "src:ctrllimited") == ["true"]


@pytest.mark.parametrize(
    ("settings", "unit"),
    [
        ("", "DEG"),
        ('<compiler angle="radian"/>', "RAD"),
        ('<compiler angle="radian"/><compiler/>', "RAD"),
        ('<compiler angle="radian"/><compiler angle="degree"/>', "DEG"),
    ],
)
def test_the_last_compiler_says_what_angles_are_in(settings: str, unit: str) -> None:
    read = model(ARM.format('<joint name="j" range="0 1"/>') + settings)
    (found,) = values(read, node(read, "worldbody/body/arm/joint/j"), "src:rangeUnit")
    assert found.endswith(f"/{unit}>")


def test_a_range_counts_from_the_drawn_position() -> None:
    read = model(ARM.format('<joint name="j" ref="10" range="-20 40"/>'))
    joint = node(read, "worldbody/body/arm/joint/j")
    assert [*values(read, joint, "src:lower"), *values(read, joint, "src:upper")] == [
        "-30.0",
        "30.0",
    ]


def test_without_automatic_limits_a_range_is_none() -> None:
    settings = '<compiler autolimits="false"/>'
    read = model(settings + ARM.format('<joint name="j" range="-20 40"/>'))
    assert values(read, node(read, "worldbody/body/arm/joint/j"), "src:limited") == ["false"]


def test_joints_of_one_body_follow_each_other() -> None:
    read = model(ARM.format('<joint name="a"/><joint name="b" pos="0 0 1"/>'))
    body = node(read, "worldbody/body/arm")
    stage = node(read, "worldbody/body/arm/stage/1")
    first, second = (node(read, f"worldbody/body/arm/joint/{name}") for name in "ab")
    assert values(read, first, "src:childBody") == [stage]
    assert values(read, second, "src:parentBody") == [stage]
    assert values(read, second, "src:childBody") == [body]
    assert numbers(read, second, "src:parent") == [0, 0, 1]


def test_a_body_without_joints_is_welded() -> None:
    read = model(ARM.format(""))
    weld = node(read, "worldbody/body/arm/weld")
    assert values(read, weld, "src:type") == ["fixed"]
    assert values(read, weld, "src:parentBody") == [node(read, "worldbody")]


def test_copies_have_nodes_and_names_of_their_own() -> None:
    read = model(
        '<worldbody><replicate count="3" offset="0 1 0" sep="-">'
        '<body name="leg"><joint name="hip"/><geom size="1"/></body></replicate></worldbody>'
    )
    leg = node(read, "worldbody/replicate/body/leg")
    copies = [f"{leg[:-1]}@{number}>" for number in range(3)]
    assert [values(read, each, "src:name") for each in copies] == [["leg-0"], ["leg-1"], ["leg-2"]]
    assert [numbers(read, each, "src:placed")[1] for each in copies] == [0, 1, 2]
    assert values(read, copies[0], "src:compiledFrom") == [leg]


@pytest.mark.parametrize("count", ["1e9", "100000000000", "-1", "0", "nan", "x"])
def test_nobody_makes_endless_copies(count: str) -> None:
    inner = '<body><geom size="1"/></body>'
    read = model(f'<worldbody><replicate count="{count}">{inner}</replicate></worldbody>')
    assert len(read.statements) < 1_000


@pytest.mark.slow
def test_copies_of_copies_are_bounded() -> None:
    inner = '<body><geom size="1"/></body>'
    for _ in range(6):
        inner = f'<replicate count="1000">{inner}</replicate>'
    read = model(f"<worldbody>{inner}</worldbody>")
    assert nodes(read, "UnmadeCopies")


def test_an_included_file_takes_the_place_of_the_include(tmp_path) -> None:
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "hand.xml").write_text(
        '<mujocoinclude><joint name="j" range="1 2"/>'
        '<include file="parts/tip.xml"/></mujocoinclude>'
    )
    (tmp_path / "parts" / "tip.xml").write_text('<x><geom name="tip" size="0.25"/></x>')
    main = tmp_path / "robot.xml"
    main.write_text(
        '<mujoco><worldbody><body name="arm"><include file="parts/hand.xml"/></body></worldbody>'
        '<actuator><motor name="m" joint="j"/></actuator></mujoco>'
    )
    read = file(main)
    inside = "worldbody/body/arm/include/mujocoinclude"
    joint = node(read, f"{inside}/joint/j")
    assert values(read, joint, "src:childBody") == [node(read, "worldbody/body/arm")]
    assert values(read, node(read, "actuator/motor/m"), "ref:joint") == [joint]
    assert written(read, joint, "at:range-2") == "2"


def test_each_file_is_included_once(tmp_path) -> None:
    (tmp_path / "part.xml").write_text('<mujocoinclude><body name="b"/></mujocoinclude>')
    main = tmp_path / "robot.xml"
    include = '<include file="part.xml"/>'
    main.write_text(f"<mujoco><worldbody>{include}{include}</worldbody></mujoco>")
    (again,) = nodes(file(main), "RepeatedInclude")
    assert values(file(main), again, "src:written") == ["part.xml"]


def test_a_file_does_not_include_itself(tmp_path) -> None:
    main = tmp_path / "robot.xml"
    main.write_text('<mujoco><include file="./robot.xml"/></mujoco>')
    assert len(nodes(file(main), "CircularInclude")) == 1


def test_an_empty_file_is_not_included(tmp_path) -> None:
    (tmp_path / "part.xml").write_text("<mujoco><!-- nothing --></mujoco>")
    main = tmp_path / "robot.xml"
    main.write_text('<mujoco><include file="part.xml"/></mujoco>')
    (unread,) = nodes(file(main), "UnresolvedInclude")
    assert values(file(main), unread, "src:reason") == ["part.xml is empty"]


def test_what_a_model_lacks_is_not_attached(tmp_path) -> None:
    (tmp_path / "hand.xml").write_text(
        '<mujoco><worldbody><body name="palm"/></worldbody></mujoco>'
    )
    main = tmp_path / "robot.xml"
    attach = '<attach model="hand" body="{}" prefix="l_"/>'
    main.write_text(
        '<mujoco><asset><model name="hand" file="hand.xml"/></asset>'
        f"<worldbody>{attach.format('plam')}{2 * attach.format('palm')}</worldbody></mujoco>"
    )
    found = file(main)
    wrong, first, again = (node(found, f"worldbody/attach{each}") for each in ("", ";2", ";3"))
    (gap,) = values(found, wrong, "src:dangling")
    assert values(found, gap, "src:resembles") == ["palm"]
    assert values(found, again, "src:sameNameAs") == [first]


def test_names_may_be_those_of_a_file_that_is_not_there() -> None:
    text = ARM.format("") + '<actuator><motor name="m" joint="nobody"/></actuator>'
    read, unsure = model(text), model('<include file="nothing.xml"/>' + text)
    assert any(p == iri(f"{SRC}dangling") for _, p, _ in read.statements)
    assert not any(p == iri(f"{SRC}dangling") for _, p, _ in unsure.statements)


def test_a_pin_of_a_flex_needs_one_of_its_attributes() -> None:
    read = model('<worldbody><flexcomp name="f"><pin id="0 4"/></flexcomp></worldbody>')
    assert not nodes(read, "MissingAttribute")


def test_an_attached_model_keeps_its_own_unit_of_angles(tmp_path) -> None:
    (tmp_path / "hand.xml").write_text(
        '<mujoco model="hand"><compiler angle="radian"/><worldbody><body name="palm">'
        '<joint name="j" range="0 1"/><geom size="1"/></body></worldbody></mujoco>'
    )
    main = tmp_path / "robot.xml"
    main.write_text(
        '<mujoco><asset><model name="hand" file="hand.xml"/></asset><worldbody>'
        '<attach model="hand" body="palm" prefix="left_"/></worldbody></mujoco>'
    )
    read = file(main)
    named = {literal_value(o): s for s, p, o in read.statements if p == iri(f"{SRC}name")}
    assert "left_palm" in named
    units = [o for _, p, o in read.statements if p == iri(f"{SRC}rangeUnit")]
    assert [each.rpartition("/")[2] for each in units] == ["RAD>"]
    assert not [p for _, p, _ in read.statements if p == iri(f"{SRC}greatestAngle")]


def test_a_model_is_not_attached_to_itself_without_end(tmp_path) -> None:
    main = tmp_path / "robot.xml"
    main.write_text(
        '<mujoco><asset><model name="a" file="robot.xml"/></asset><worldbody><body name="b">'
        '<attach body="b" prefix="x"/></body></worldbody></mujoco>'
    )
    assert len(file(main).statements) < 1_000


def test_attributes_in_a_frame_are_known_to_be_unchecked() -> None:
    frame = '<worldbody><frame name="f"><geom siz="1"/></frame><geom siz="1"/></worldbody>'
    read = model(frame)
    found = [values(read, each, "src:uncheckedIn") for each in nodes(read, "UndeclaredAttribute")]
    assert found == [[node(read, "worldbody/frame/f")], []]


@pytest.mark.parametrize(
    ("content", "attribute", "reason"),
    [
        ('<joint type="ball" axis="0 1 0"/>', "axis", "type"),
        ('<geom type="capsule" size="1" fromto="0 0 0 0 0 1" quat="1 0 0 0"/>', "quat", "fromto"),
        ('<inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/><geom mass="3" size="1"/>', "mass",
         "inertial"),
    ],
)  # fmt: skip
def test_what_something_else_makes_unread_is_stated(
    content: str, attribute: str, reason: str
) -> None:
    read = model(ARM.format(content))
    (unread,) = nodes(read, "UnreadAttribute")
    assert values(read, unread, "src:attribute") == [attribute]
    assert values(read, unread, "src:reason") == [reason]


def test_an_empty_value_is_none() -> None:
    read = model(ARM.format('<joint name="j" pos="" range=""/>'))
    kinds = {o for _, p, o in read.statements if p == RDF_TYPE}
    assert iri(f"{SRC}MalformedValue") not in kinds


def test_a_part_alone_is_no_error() -> None:
    read = whole('<mujocoinclude><body name="b"><joint class="x"/></body></mujocoinclude>')
    assert not any(p == iri(f"{SRC}dangling") for _, p, _ in read.statements)


def test_the_order_of_statements_is_that_of_the_text() -> None:
    text = ARM.format('<joint name="a"/><joint name="b"/>')
    assert model(text).statements == model(text).statements


@pytest.mark.slow
def test_attaching_each_other_ends(tmp_path) -> None:
    main = tmp_path / "robot.xml"
    attach = '<attach body="{}" prefix="{}"/>'
    one, other = (
        f'<body name="{name}">{attach.format(to, 1)}{attach.format(to, 2)}</body>'
        for name, to in (("a", "b"), ("b", "a"))
    )
    main.write_text(f"<mujoco><worldbody>{one}{other}</worldbody></mujoco>")
    assert nodes(file(main), "UnmadeCopies")


def test_an_infinite_bound_of_a_range_is_a_number() -> None:
    read = model(ARM.format('<joint name="j" range="-inf 3"/>'))
    joint = node(read, "worldbody/body/arm/joint/j")
    assert numbers(read, joint, "at:range", "1 2") == [float("-inf"), 3]
    assert nodes(read, "MalformedValue") == []


def test_a_frame_that_scales_leaves_places_unknown() -> None:
    body = '<body name="b" pos="1 0 0"><geom size="1"/></body>'
    read = model(f'<worldbody><frame scale="2">{body}</frame></worldbody>')
    inside = node(read, "worldbody/frame//body/b")
    assert values(read, inside, "src:inBody") == [node(read, "worldbody")]
    assert values(read, inside, "src:placed-x") == []


@pytest.mark.parametrize(
    ("written", "meant"),
    [
        ('<sight name="tip" pos="0 0 1" size="0.01"/>', "site"),
        ('<sight name="tip" pos="0 0 1" dir="0 0 1"/>', "light"),
        ("<sight/>", "light"),
        ('<goem size="0.1" rgba="1 0 0 1"/>', "geom"),
        ('<jiont name="hip" nmae="knee"/>', "joint"),
    ],
)
def test_what_a_misspelt_element_is_its_attributes_tell(written, meant) -> None:
    found = model(f'<worldbody><body name="leg">{written}</body></worldbody>')

    assert [literal_value(o) for _, p, o in found.statements if p == SAID][:1] == [meant]
