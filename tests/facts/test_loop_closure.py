"""Cycles of poses, positions and orientations."""

from __future__ import annotations

import math
from typing import Any

import pytest
from computed import QUARTER, STRAIGHT, Computed, Node, computed, frame, pose, shift, turn
from hypothesis import given, settings
from hypothesis import strategies as st

from kinlint.facts.linear_algebra import Matrix, Vector, add, angle, apply, product, transpose
from kinlint.facts.rotation import from_euler

HALF = turn((-1, 0, 0), (0, -1, 0), (0, 0, 1))


def cycles(found: Computed) -> list[dict[str, Any]]:
    return [found.of(node) for node in found.nodes("cycle")]


def triangle(*last: Node) -> list[Node]:
    """Two quarter turns, each after a step of 1 m along x, and the pose of their composition."""
    return [
        *frame("one"),
        *frame("two"),
        *frame("base"),
        *pose("p", "one", "base", QUARTER | shift(1, 0, 0)),
        *pose("q", "two", "one", QUARTER | shift(1, 0, 0)),
        *pose("r", "two", "base", *last),
    ]


def test_poses_that_compose_close() -> None:
    """Without a residual, under the last one, with the way gone."""
    found = computed(*triangle(HALF | shift(1, 1, 0)))

    assert cycles(found) == [
        {
            "closed-by": "ex:r",
            "length": 3,
            "distance": 0,
            "angle": pytest.approx(0, abs=1e-15),
            "magnitude": pytest.approx(2 + math.sqrt(2)),
        }
    ]
    assert set(found.values("cycle:1", "member")) == {"ex:p", "ex:q", "ex:r"}
    assert set(found.values("cycle:1", "derived-from")) == {
        "ex:p-coord",
        "ex:q-coord",
        "ex:r-coord",
    }


def test_what_is_missing_is_measured() -> None:
    """In metres and radians."""
    (found,) = cycles(computed(*triangle(QUARTER | shift(1, 1, 0.25))))

    assert found["distance"] == pytest.approx(0.25)
    assert found["angle"] == pytest.approx(math.pi / 2)


def test_the_way_to_a_cycle_is_no_part_of_it() -> None:
    """What lies between the root and the cycle adds neither to its length nor to its magnitude."""
    far = [*frame("root"), *pose("a", "base", "root", STRAIGHT | shift(100, 0, 0))]
    (found,) = cycles(computed(*far, *triangle(HALF | shift(1, 1, 0))))

    assert found["length"] == 3
    assert found["magnitude"] == pytest.approx(2 + math.sqrt(2))


def test_orientation_and_position_may_stand_apart() -> None:
    """On two nodes, of which one even sees from another frame: they are one edge."""
    seen = shift(1, -1, 0) | {"as-seen-by": "ex:one"}
    (found,) = cycles(computed(*triangle(HALF, seen)))

    assert found["distance"] == pytest.approx(0, abs=1e-15)
    assert found["angle"] == pytest.approx(0, abs=1e-15)


def test_positions_of_points_close_with_poses() -> None:
    """A pose places the origins of its frames."""
    found = computed(
        *frame("one"),
        *frame("base"),
        *pose("p", "one", "base", STRAIGHT | shift(1, 0, 0)),
        {"@id": "ex:d", "@type": "Position", "of": "ex:base-origin"}
        | {"with-respect-to": "ex:one-origin"},
        {"@id": "ex:d-coord", "@type": ["PositionReference", "PositionCoordinate", "VectorXYZ"]}
        | {"of-position": "ex:d", "as-seen-by": "ex:one", "unit": "M", **shift(-1, 0, 0.5)},
    )
    (cycle,) = cycles(found)

    assert cycle["closed-by"] == "ex:d"
    assert cycle["length"] == 2
    assert cycle["distance"] == 0.5
    assert "angle" not in cycle


def test_what_joints_leave_open_is_no_cycle() -> None:
    """Positions seen by frames whose orientation is unknown do not add up."""
    found = computed(
        *frame("one"),
        *frame("two"),
        *frame("base"),
        *pose("p", "one", "base", QUARTER | shift(1, 0, 0)),
        *pose("q", "two", "one", shift(1, 0, 0)),
        *pose("r", "two", "base", shift(9, 9, 9) | {"as-seen-by": "ex:two"}),
    )

    assert not cycles(found)


def test_frames_on_one_origin_are_no_distance_apart() -> None:
    """One relation between them closes a cycle by itself."""
    shared = {"@type": "Frame", "origin": "ex:o"}
    found = computed(
        {"@id": "ex:a", **shared}, {"@id": "ex:b", **shared}, *pose("p", "a", "b", shift(0, 0, 2))
    )

    assert [(cycle["length"], cycle["distance"]) for cycle in cycles(found)] == [(1, 2)]


@pytest.mark.parametrize(
    "said",
    [
        {"unit": "UNITLESS"},
        {"unit": ["M", "CentiM"]},
        {"x": [1, 2]},
        {"as-seen-by": ["ex:a", "ex:b"]},
        {"as-seen-by": ["ex:b", "ex:a"]},
        {"as-seen-by": "ex:camera"},
    ],
)
def test_what_is_not_understood_closes_nothing(said: Node) -> None:
    """Rather no cycle than a wrong one."""
    twice = [*pose("p", "a", "b", shift(1, 2, 3)), *pose("q", "a", "b", shift(4, 5, 6) | said)]

    assert len(cycles(computed(*pose("p", "a", "b", shift(1, 2, 3)), *twice[2:]))) == 0
    assert len(cycles(computed(*twice[:2], *pose("q", "a", "b", shift(4, 5, 6))))) == 1


def test_a_reflection_turns_nothing() -> None:
    """Its cycle is known by position only."""
    mirror = turn((1, 0, 0), (0, 1, 0), (0, 0, -1))
    facts = computed(
        *pose("p", "a", "b", STRAIGHT | shift(1, 0, 0)),
        *pose("q", "a", "b", mirror | shift(1, 0, 0)),
    )

    assert ["angle" in cycle for cycle in cycles(facts)] == [False]


def test_every_independent_cycle_is_told() -> None:
    """Four frames with all six poses between them have three."""
    nodes: list[Node] = []
    names = "abcd"
    for at, name in enumerate(names):
        nodes += frame(name)
        for other in names[:at]:
            step = float(at - names.index(other))
            nodes += pose(f"{other}{name}", name, other, STRAIGHT | shift(step, 0, 0))
    found = cycles(computed(*nodes))

    assert len(found) == 3
    assert all(cycle["distance"] == 0 for cycle in found)


def test_a_long_cycle_names_some_members_only() -> None:
    """But all are counted."""
    count = 40
    nodes = [node for index in range(count) for node in frame(f"f{index}")]
    for index in range(count):
        nodes += pose(
            f"p{index}", f"f{(index + 1) % count}", f"f{index}", STRAIGHT | shift(1, 0, 0)
        )
    found = computed(*nodes)
    (cycle,) = cycles(found)

    assert cycle["length"] == count
    assert cycle["distance"] == cycle["magnitude"] == count
    assert len(found.values("cycle:1", "member")) == 12


angles = st.tuples(*[st.floats(-math.pi, math.pi)] * 3)
vectors = st.tuples(*[st.floats(-2, 2)] * 3)


def written(matrix: Matrix, vector: Vector) -> Node:
    return turn(*transpose(matrix)) | shift(*vector)


@pytest.mark.slow
@settings(max_examples=25)
@given(st.lists(st.tuples(angles, vectors, st.booleans()), min_size=2, max_size=8))
def test_any_loop_of_rigid_motions_closes(
    steps: list[tuple[Vector, Vector, bool]],
) -> None:
    """Whichever way round each pose is written, and whatever its unit."""
    nodes = [node for index in range(len(steps) + 1) for node in frame(f"f{index}")]
    whole: Matrix = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    where: Vector = (0.0, 0.0, 0.0)
    for index, (euler, vector, backwards) in enumerate(steps):
        matrix = from_euler("xyz", euler, intrinsic=True)
        where = add(where, apply(whole, vector))
        whole = product(whole, matrix)
        of, base = f"f{index + 1}", f"f{index}"
        if backwards:
            x, y, z = apply(transpose(matrix), vector)
            said = written(transpose(matrix), (-x, -y, -z))
            nodes += pose(f"p{index}", base, of, said)
        else:
            x, y, z = vector
            said = written(matrix, (1e3 * x, 1e3 * y, 1e3 * z)) | {"unit": ["UNITLESS", "MilliM"]}
            nodes += pose(f"p{index}", of, base, said)
    nodes += pose("last", f"f{len(steps)}", "f0", written(whole, where))
    (cycle,) = cycles(computed(*nodes))

    assert cycle["length"] == len(steps) + 1
    assert cycle["distance"] < 1e-12 * max(1.0, cycle["magnitude"])
    assert cycle["angle"] < 1e-12
    assert angle(product(transpose(whole), whole)) < 1e-12


def fan(slip: Node, at: int, size: int = 6) -> list[Node]:
    """A row of frames a step and a quarter turn apart, and each but the second from the first.

    Step number *at* is *slip* instead.
    """
    nodes = [node for index in range(size) for node in frame(f"f{index}")]
    there: tuple[Vector, Matrix] = ((0.0, 0.0, 0.0), ((1, 0, 0), (0, 1, 0), (0, 0, 1)))
    whole: list[Node] = []
    for index in range(1, size):
        by = slip if index == at else QUARTER | shift(0.5, 0, 0.1)
        nodes += pose(f"s{index}", f"f{index}", f"f{index - 1}", by)
        place = add(there[0], apply(there[1], (0.5, 0.0, 0.1)))
        there = place, product(there[1], ((0, -1, 0), (1, 0, 0), (0, 0, 1)))
        if index > 1:
            whole += pose(
                f"w{index}", f"f{index}", "f0", turn(*transpose(there[1])) | shift(*place)
            )
    return nodes + whole


@pytest.mark.parametrize(
    "slip",
    [
        QUARTER | shift(0.5, 0, 0.2),
        STRAIGHT | shift(0.5, 0, 0.1),
        turn((0, 1, 0), (1, 0, 0), (0, 0, -1)) | shift(0.5, 0, 0.1),
    ],
)
@pytest.mark.parametrize("at", [1, 3, 4])
def test_cycles_that_miss_alike_are_traced_to_what_they_share(slip: Node, at: int) -> None:
    """A step, an angle or a half turn too much: all cycles miss that the relation is in."""
    missed = [each for each in cycles(computed(*fan(slip, at))) if _misses(each)]

    assert len(missed) == 6 - max(at, 2)
    assert {each["traced-to"] for each in missed} == {f"ex:s{at}"}


def test_cycles_that_miss_each_in_its_own_way_are_traced_to_nothing() -> None:
    """The relations that close them are wrong, not what they share."""
    nodes = fan(QUARTER | shift(0.5, 0, 0.1), 1)
    for index, height in (("w3", 7.0), ("w5", 9.0)):
        next(node for node in nodes if node["@id"] == f"ex:{index}-coord")["z"] = height
    found = cycles(computed(*nodes))

    assert [each["closed-by"] for each in found if _misses(each)] == ["ex:w3", "ex:w5"]
    assert not any("traced-to" in each for each in found)


def test_two_slips_are_told_apart() -> None:
    """Each cycle is traced to the slip nearest to its own end that explains it."""
    nodes = fan(QUARTER | shift(0.5, 0, 0.2), 1)
    next(node for node in nodes if node["@id"] == "ex:s4-coord")["x"] = 0.7

    assert {each["traced-to"] for each in cycles(computed(*nodes))} == {"ex:s1", "ex:s4"}


def _misses(cycle: dict[str, Any]) -> bool:
    return max(cycle["distance"], cycle["angle"]) > 1e-6
