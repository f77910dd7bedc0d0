"""What differs between files of two formats that describe one robot."""

from __future__ import annotations

import itertools
import json

from described import closed, inertial, joint, link

from kinlint.facts.computation import facts
from kinlint.terms import literal_value
from kinlint.vocabulary import FACT

LIMIT = '<limit lower="-1" upper="{}" effort="1" velocity="1"/>'
ARM = """<sdf version="1.9"><model name="{name}">
  <link name="base"/>
  <link name="hand"><pose>0 0 {z} 0 0 0</pose>
    <inertial><mass>{mass}</mass></inertial></link>
  <joint name="wrist" type="revolute"><parent>base</parent><child>hand</child>
    <axis><xyz>{axis}</xyz><limit><lower>-1</lower><upper>1</upper></limit></axis></joint>
</model></sdf>"""
SAME = {"name": "arm", "z": 0.5, "mass": 2, "axis": "0 0 1"}


def robot(*more: str, mass: float = 2.0, upper: float = 1.0, z: float = 0.5) -> str:
    origin = f'<origin xyz="0 0 {z}"/><axis xyz="0 0 2"/>'
    parts = (
        *(link("base"), link("hand", inertial(mass))),
        joint("wrist", "base", "hand", "revolute", origin, LIMIT.format(upper)),
        *more,
    )
    return f'<robot name="Arm">{"".join(parts)}</robot>'


def drift(**texts: str) -> list[tuple[str, float, float]]:
    """What differs, with the value of the first file and that of the other."""
    return drifts({f"a.{form}": text for form, text in texts.items()})


def drifts(texts: dict[str, str]) -> list[tuple[str, float, float]]:
    """What differs between *texts* by the names of their files."""
    store = closed(texts)
    said: dict[str, dict[str, str]] = {}
    for subject, predicate, value in facts(store):
        if "urn:kinlint:fact:drift:" in subject:
            said.setdefault(subject, {})[predicate[1:-1].removeprefix(FACT)] = value
    return sorted(
        (
            literal_value(each["quantity"]),
            float(literal_value(each["here"])),
            float(literal_value(each["there"])),
        )
        for each in said.values()
    )


def test_the_same_robot_twice_is_no_drift():
    """Upper and lower case of its name, and the length of an axis, do not matter."""
    assert drift(urdf=robot(), sdf=ARM.format(**SAME)) == []


def test_what_differs_is_told_once():
    """With the number of the file that comes first."""
    assert drift(urdf=robot(mass=2.5), sdf=ARM.format(**SAME)) == [("mass in kg", 2.5, 2.0)]
    assert drift(urdf=robot(upper=1.2), sdf=ARM.format(**SAME)) == [("upper limit", 1.2, 1.0)]
    assert drift(urdf=robot(z=0.54), sdf=ARM.format(**SAME)) == [("origin along z", 0.54, 0.5)]
    turned = ARM.format(**SAME | {"axis": "0 1 0"})
    assert [what for what, _, _ in drift(urdf=robot(), sdf=turned)] == ["axis along y"]


def test_less_than_the_tolerances_is_no_drift():
    """One percent, and a millimetre."""
    assert drift(urdf=robot(mass=2.01, z=0.5005), sdf=ARM.format(**SAME)) == []


def test_robots_of_other_names_or_joints_are_other_robots():
    """Two thirds of the joints have to be shared."""
    assert drift(urdf=robot(mass=3), sdf=ARM.format(**SAME | {"name": "leg"})) == []
    other = ARM.format(**SAME).replace("wrist", "ankle")
    assert drift(urdf=robot(mass=3), sdf=other) == []


def test_what_is_fixed_to_a_body_weighs_with_it():
    """Converters to SDF make one link of links that are fixed to each other."""
    tip = link("tip", inertial(0.5)), joint("screw", "hand", "tip", "fixed")

    assert drift(urdf=robot(*tip, mass=1.5), sdf=ARM.format(**SAME)) == []


def test_composable_models_are_compared_by_their_joints():
    """They have no name for the robot as a whole."""
    limit = {"@id": "ex:wrist-limit", "@type": "JointPositionLimit", "of-joint": "ex:wrist"}
    nodes = [
        {"@id": "ex:wrist", "@type": ["Joint", "RevoluteJoint"]},
        limit | {"unit": "RAD", "lower": -1.0, "upper": 2.0},
    ]
    context = ["https://w3id.org/kinlint/composable.json", {"ex": "https://example.org/arm#"}]
    model = json.dumps({"@context": context, "@graph": nodes})

    assert drift(jsonld=model, urdf=robot()) == [("upper limit", 2.0, 1.0)]


LONG = ("base", "upper", "lower", "hand", "finger")


def long_urdf(mass: float, *, step: float = 0.5, name: str = "robot") -> str:
    """Return a chain of four joints with generic names, the bodies of *mass* in kg."""
    links = (link(each, inertial(mass)) for each in LONG)
    origin = f'<origin xyz="0 0 {step}"/><axis xyz="0 0 1"/>'
    pairs = itertools.pairwise(LONG)
    joints = (
        joint(f"joint{at}", parent, child, "revolute", origin, LIMIT.format(1))
        for at, (parent, child) in enumerate(pairs)
    )
    return f'<robot name="{name}">{"".join((*links, *joints))}</robot>'


def long_sdf(mass: float, *, step: float = 0.5) -> str:
    """Return the same chain as SDF, the last body half as heavy as it should be."""
    masses = [mass] * 4 + [mass / 2]
    links = (
        f'<link name="{each}"><pose>0 0 {step * at} 0 0 0</pose>'
        f"<inertial><mass>{masses[at]}</mass></inertial></link>"
        for at, each in enumerate(LONG)
    )
    joints = (
        f'<joint name="joint{at}" type="revolute"><parent>{parent}</parent><child>{child}</child>'
        "<axis><xyz>0 0 1</xyz><limit><lower>-1</lower><upper>1</upper></limit></axis></joint>"
        for at, (parent, child) in enumerate(itertools.pairwise(LONG))
    )
    return f'<sdf version="1.9"><model name="robot">{"".join((*links, *joints))}</model></sdf>'


ONE = [("mass in kg", 2.0, 1.0)]
"""What differs between the two chains."""


def test_robots_that_share_only_names_are_not_compared():
    """Names, structure, axes and ranges are alike; no mass and no origin is."""
    assert drifts({"x/arm.urdf": long_urdf(2), "y/model.sdf": long_sdf(2)}) == ONE
    other = long_sdf(31, step=0.21)
    assert drifts({"x/arm.urdf": long_urdf(2), "y/model.sdf": other}) == []
    assert len(drifts({"x/arm.urdf": long_urdf(2), "x/arm.sdf": other})) > len(LONG)


def test_joints_of_one_name_that_join_other_bodies_are_of_another_robot():
    """The names of joints are often the same in all robots of a maker; numbers decide."""
    renamed, other = long_sdf(2), long_sdf(31, step=0.21)
    for name in LONG:
        changes = (f"{name}<", f"{name}_link<"), (f'"{name}"', f'"{name}_link"')
        for old, new in changes:
            renamed, other = renamed.replace(old, new), other.replace(old, new)
    assert drifts({"x/arm.urdf": long_urdf(2), "y/model.sdf": renamed}) == ONE
    assert drifts({"x/arm.urdf": long_urdf(2), "y/model.sdf": other}) == []


def test_of_several_files_the_nearest_is_compared():
    """One stem, then one folder, then one run; several of the same distance decide nothing."""
    two = {"x/arm.urdf": long_urdf(2), "x/arm_with_tool.urdf": long_urdf(2)}
    assert drifts({**two, "x/arm.sdf": long_sdf(2)}) == ONE * 2
    assert drifts({**two, "y/model.sdf": long_sdf(2), "y/b.sdf": long_sdf(2)}) == []
    far = {"x/a.urdf": long_urdf(2), "y/b.urdf": long_urdf(4)}
    assert drifts({**far, "x/a1.sdf": long_sdf(2), "y/b1.sdf": long_sdf(4)}) == [
        *ONE,
        ("mass in kg", 4.0, 2.0),
    ]


def test_each_composable_mechanism_is_compared_by_itself():
    """Two models of one run are not one robot, whatever names they share."""

    def model(space: str, upper: float, count: int = 4) -> str:
        nodes = [
            {"@id": f"ex:{body}", "@type": "RigidBody", "simplices": [f"ex:frame{at}"]}
            for at, body in enumerate(LONG)
        ]
        for at in range(count):
            joint = {"@id": f"ex:joint{at}", "@type": ["Joint", "RevoluteJoint"]}
            ends = [f"ex:frame{at}", f"ex:frame{at + 1}"]
            limit = {
                "@id": f"ex:limit{at}",
                "@type": "JointPositionLimit",
                "of-joint": joint["@id"],
            }
            nodes += [joint | {"between-attachments": ends}]
            nodes += [limit | {"unit": "RAD", "lower": -1.0, "upper": upper}]
        context = ["https://w3id.org/kinlint/composable.json", {"ex": f"https://{space}.example/#"}]
        return json.dumps({"@context": context, "@graph": nodes})

    urdf = {"c.urdf": long_urdf(2, step=0)}
    two = {"a.jsonld": model("one", 2.0), "b.jsonld": model("two", 3.0)}
    upper = [("upper limit", 2.0, 1.0)] * 4 + [("upper limit", 3.0, 1.0)] * 4
    assert drifts({**two, **urdf}) == upper
    few = {"a.jsonld": model("one", 2.0, 2), "b.jsonld": model("two", 3.0, 2)}
    assert drifts({**few, **urdf}) == []


CRANE = """<mujoco model="crane"><compiler angle="radian"/><worldbody><body name="mast">
  <geom type="box" size="0.1 0.1 1" mass="9"/>
  <body name="boom" pos="0 0 1"><joint name="slew"/>
    <geom type="box" size="0.5 0.1 0.1" mass="4"/>
    <body name="trolley" pos="0.2 0 0"><joint name="travel" type="slide" axis="1 0 0"/>
      <geom type="box" size="0.1 0.1 0.05" mass="1"/>
      <body name="rope" pos="0 0 -0.1"><joint name="hoist" type="slide" axis="0 0 1"/>
        <geom type="box" size="0.01 0.01 0.4" mass="0.5"/>
        {hook}</body></body></body></body></worldbody></mujoco>"""
HOOK = '<body name="hook"><joint name="swivel"/><geom type="sphere" size="0.02" mass="0.1"/></body>'


def crane_differences(text: str) -> list[tuple[str, str, str]]:
    """What differs of the crane with a hook from *text*, by aspect."""
    store = closed({"a.sdf": SDF_CRANE, "a.xml": text})
    said: dict[str, dict[str, str]] = {}
    for subject, predicate, value in facts(store):
        if "urn:kinlint:fact:drift:" in subject:
            said.setdefault(subject, {})[predicate[1:-1].removeprefix(FACT)] = literal_value(value)
    return sorted((each["aspect"], each["here"], each["there"]) for each in said.values())


def _sdf_crane() -> str:
    parts = (
        ("mast", "0 0 0", 9, "0.2 0.2 2"),
        ("boom", "0 0 1", 4, "1 0.2 0.2"),
        ("trolley", "0.2 0 1", 1, "0.2 0.2 0.1"),
        ("rope", "0.2 0 0.9", 0.5, "0.02 0.02 0.8"),
        ("hook", "0.2 0 0.9", 0.1, ""),
    )
    joints = (
        ("slew", "revolute", "0 0 1"),
        ("travel", "prismatic", "1 0 0"),
        ("hoist", "prismatic", "0 0 1"),
        ("swivel", "revolute", "0 0 1"),
    )
    links = [
        f'<link name="{name}"><pose>{place} 0 0 0</pose><inertial><mass>{mass}</mass></inertial>'
        f'<collision name="c"><geometry>{_sdf_shape(edges)}</geometry></collision></link>'
        for name, place, mass, edges in parts
    ]
    ends = itertools.pairwise(name for name, *_ in parts)
    moving = [
        f'<joint name="{name}" type="{kind}"><parent>{parent}</parent><child>{child}</child>'
        f"<axis><xyz>{axis}</xyz></axis></joint>"
        for (name, kind, axis), (parent, child) in zip(joints, ends, strict=True)
    ]
    return f'<sdf version="1.9"><model name="crane">{"".join(links + moving)}</model></sdf>'


def _sdf_shape(edges: str) -> str:
    if edges:
        return f"<box><size>{edges}</size></box>"
    return "<sphere><radius>0.02</radius></sphere>"


SDF_CRANE = _sdf_crane()


def test_what_one_description_lacks_is_told():
    """A joint that is fixed or not there, and a shape; a part that is there twice as large."""
    whole = CRANE.format(hook=HOOK)
    assert crane_differences(whole) == []
    held = CRANE.format(hook=HOOK.replace('<joint name="swivel"/>', ""))
    assert crane_differences(held) == [("joint", "revolute", "fixed")]
    assert crane_differences(CRANE.format(hook="")) == [("missing", "revolute", "none")]
    bare = whole.replace(
        'type="sphere" size="0.02" mass="0.1"',
        'type="sphere" size="0.02" mass="0.1" contype="0" conaffinity="0"',
    )
    assert crane_differences(bare) == [("shape", "1 sphere", "none")]
    halved = whole.replace('"0.1 0.1 0.05"', '"0.2 0.2 0.1"')
    assert crane_differences(halved) == [("halved", "0.2", "0.4")]


def test_other_names_are_told_where_most_are_the_same():
    """Another part in the same place has more that differs than its name."""
    whole = CRANE.format(hook=HOOK)
    assert crane_differences(whole.replace('"hoist"', '"lift"')) == [("name", "hoist", "lift")]
    assert crane_differences(whole.replace('"boom"', '"jib"')) == [("name", "boom", "jib")]
    others = whole
    for name in ("mast", "boom", "trolley", "rope", "hook"):
        others = others.replace(f'"{name}"', f'"{name}_link"')
    assert crane_differences(others) == []
    gripper = (
        HOOK.replace("swivel", "open")
        .replace("hook", "jaw")
        .replace("joint ", 'joint type="slide" ')
    )
    assert not [
        each
        for each in crane_differences(CRANE.format(hook=gripper))
        if each[0] in {"name", "missing"}
    ]
