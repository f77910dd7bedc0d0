"""Joints of SDF with two axes, a thread or gears, and poses seen by other bodies, are lifted."""

from __future__ import annotations

from pathlib import Path

import pytest
from lifted import triples

from kinlint.terms import Term, Triple, iri, literal_value
from kinlint.vocabulary import KIN

LINKS = '<link name="base"/><link name="{}"><pose>0 0 1 0 0 0</pose></link>'
ENDS = "<parent>base</parent><child>{}</child>"
VECTOR = tuple(
    iri(f"https://comp-rob2b.github.io/metamodels/geometry/coordinates#{each}") for each in "xyz"
)


def lift(tmp_path: Path, body: str, version: str = "1.10") -> tuple[Triple, ...]:
    """What a model of *body* says and what is lifted from it."""
    path = tmp_path / "robot.sdf"
    path.write_text(f'<sdf version="{version}"><model name="m">{body}</model></sdf>')
    return triples(path)


def kin(said: tuple[Triple, ...], name: str) -> list[Term]:
    """The values of a property of kinlint's own vocabulary."""
    return [o for _, p, o in said if p == iri(KIN + name)]


def vector(said: tuple[Triple, ...], node: Term) -> list[float]:
    """The coordinates of *node*."""
    return [
        float(literal_value(o)) for axis in VECTOR for s, p, o in said if s == node and p == axis
    ]


@pytest.mark.parametrize("kind", ["universal", "revolute2"])
def test_both_axes_of_a_joint_of_two(tmp_path: Path, kind: str) -> None:
    body = LINKS.format("fork") + (
        f'<joint name="j" type="{kind}">{ENDS.format("fork")}<axis><xyz>2 0 0</xyz></axis>'
        "<axis2><xyz>0 1 0</xyz></axis2></joint>"
    )
    found = lift(tmp_path, body)
    (first,), (second,) = kin(found, "first-axis"), kin(found, "second-axis")
    assert vector(found, first) == [1, 0, 0]
    assert vector(found, second) == [0, 1, 0]
    simplices = {(s.rpartition("/")[2], o) for s, p, o in found if p.endswith("#simplices>")}
    assert {("base>", first), ("fork>", second)} <= simplices


@pytest.mark.parametrize(
    ("said", "advance"),
    [
        ("<screw_thread_pitch>0.005</screw_thread_pitch>", [0.005]),
        ("<screw_thread_pitch>-0.005</screw_thread_pitch>", [-0.005]),
        ("<thread_pitch>-1256.6370614359173</thread_pitch>", [0.005]),
        ("<thread_pitch>1256.6370614359173</thread_pitch>", [-0.005]),
        (
            "<thread_pitch>3</thread_pitch><screw_thread_pitch>0.01</screw_thread_pitch>",
            [0.01],
        ),
        ("<thread_pitch>0</thread_pitch>", []),
        ("<screw_thread_pitch>wide</screw_thread_pitch>", []),
        ("", []),
    ],
)
def test_how_far_a_screw_advances(tmp_path: Path, said: str, advance: list[float]) -> None:
    body = LINKS.format("nut") + f'<joint name="j" type="screw">{ENDS.format("nut")}{said}</joint>'
    found = [float(literal_value(each)) for each in kin(lift(tmp_path, body), "advance-per-turn")]
    assert found == pytest.approx(advance)


@pytest.mark.parametrize(("said", "multiplier"), [("<gearbox_ratio>4</gearbox_ratio>", 4), ("", 1)])
def test_a_gearbox_couples_hinges(tmp_path: Path, said: str, multiplier: float) -> None:
    hinges = "".join(
        f'<joint name="{name}" type="revolute"><parent>base</parent><child>{child}</child>'
        "<axis><xyz>0 0 1</xyz></axis></joint>"
        for name, child in (("motor", "rotor"), ("elbow", "forearm"))
    )
    body = f"""<link name="base"/><link name="rotor"/><link name="forearm"/>{hinges}
        <joint name="gear" type="gearbox"><parent>rotor</parent><child>forearm</child>
        <gearbox_reference_body>base</gearbox_reference_body>{said}</joint>"""
    found = lift(tmp_path, body)
    assert [float(literal_value(each)) for each in kin(found, "multiplier")] == [-multiplier]
    assert [each.rpartition("/")[2] for each in kin(found, "leader")] == ["motor>"]
    assert [each.rpartition("/")[2] for each in kin(found, "follower")] == ["elbow>"]


def test_a_pose_seen_from_another_body_lifts_to_where_it_is_on_its_own(tmp_path: Path) -> None:
    """The tip is two metres above the base, by way of the joint; the tool three, by the tip."""
    body = """<link name="base"><pose>1 0 0 0 0 0</pose></link>
        <link name="tip"><pose relative_to="j">0 0 1 0 0 0</pose></link>
        <joint name="j" type="fixed"><pose relative_to="base">0 0 1 0 0 0</pose>
        <parent>base</parent><child>tip</child></joint>
        <frame name="tool" attached_to="base"><pose relative_to="tip">0 0 1 0 0 0</pose></frame>"""
    found = lift(tmp_path, body)
    assert vector(found, node(found, "frame/tool/pose/position")) == [0, 0, 3]
    assert vector(found, node(found, "joint/j/pose/position")) == [0, 0, 1]
    assert vector(found, node(found, "joint/j/child-pose/position")) == [0, 0, -1]


def node(said: tuple[Triple, ...], address: str) -> Term:
    """What has an address that ends with *address*."""
    return next(s for s, _, _ in said if s.endswith(f"{address}>"))
