"""Steps of schedules, and data that flow in a circle."""

from __future__ import annotations

import pytest
from computed import Computed, Node, computed, store_of
from hypothesis import given
from hypothesis import strategies as st

from kinlint.facts.computation import hints
from kinlint.facts.fact_statements import fact
from kinlint.facts.strongly_connected import strongly_connected_components

KIN = "https://w3id.org/kinlint/kinematics#"


def operator(name: str, reads: str = "", writes: str = "") -> Node:
    return {
        "@id": f"ex:{name}",
        **{
            f"{KIN}{what}": [{"@id": f"ex:{each}"} for each in said.split()]
            for what, said in (("reads", reads), ("writes", writes))
        },
    }


def test_a_schedule_has_steps() -> None:
    """In its order; an operator may come twice."""
    chain = ["ex:one", "ex:two", "ex:one"]
    found = computed({"@id": "ex:s", "@type": "Schedule", "trigger-chain": chain})
    steps = found.values("ex:s", "step")

    assert [found.value(step, "index") for step in steps] == [0, 1, 2]
    assert [found.value(step, "operator") for step in steps] == chain


def test_a_schedule_with_two_orders_has_none() -> None:
    """Nobody knows which of them holds."""
    one, other = ({"@list": [{"@id": f"ex:{name}"}]} for name in "ab")
    chain = "https://comp-rob2b.github.io/metamodels/algorithm#trigger-chain"

    assert not computed({"@id": "ex:s", chain: [one, other]}).nodes("step")


OPERATORS = (
    operator("first", "start", "a"),
    operator("second", "a", "b"),
    operator("third", "a b", "c"),
    operator("apart", "d", "d"),
    operator("again", "start", "a"),
    operator("ping", "f", "e"),
    operator("pong", "e", "f"),
)


def due(chain: str) -> list[str]:
    """The operators that get another place in a schedule, by that place."""
    names = [f"ex:{name}" for name in chain.split()]
    schedule = {"@id": "ex:s", "@type": "Schedule", "trigger-chain": names}
    found = Computed(hints(store_of(*OPERATORS, schedule), {fact("reordered")}))
    moves = found.values("ex:s", "reordered")
    cells = [found.value(move, "cell") for move in moves]

    assert len(set(cells)) == len(cells)
    return [str(found.value(move, "due")).removeprefix("ex:") for move in moves]


@pytest.mark.parametrize(
    ("chain", "moved"),
    [
        ("first apart second third", ""),
        ("second first", "first second"),
        ("third second first", "first third"),
        ("third second apart first", "apart first second third"),
        ("apart third second first", "first third"),
        ("second third", ""),
        ("second second first", ""),
        ("second first again", ""),
        ("second first ping pong", ""),
        ("second first ping", "first second"),
    ],
)
def test_operators_can_run_after_what_feeds_them(chain: str, moved: str) -> None:
    """In the order that they have where that is open; not where that is impossible or a choice."""
    assert due(chain) == moved.split()


def test_operators_that_wait_for_each_other() -> None:
    """They share a cycle, which rests on what they pass on; others are in none."""
    found = computed(
        operator("first", "start c", "a"),
        operator("second", "a", "b"),
        operator("third", "b", "c d"),
        operator("after", "d", "e"),
    )
    cycles = {name: found.values(f"ex:{name}", "in-cycle") for name in ("first", "second", "third")}

    assert len({tuple(each) for each in cycles.values()}) == 1
    (cycle,) = cycles["first"]
    assert found.values(cycle, "member") == ["ex:first", "ex:second", "ex:third"]
    assert found.value(cycle, "size") == 3
    assert found.values(cycle, "derived-from") == ["ex:a", "ex:b", "ex:c"]
    assert not found.values("ex:after", "in-cycle")


def test_an_operator_may_work_in_place() -> None:
    """A cycle of one."""
    found = computed(operator("sum", "total part", "total"))

    assert found.value(found.value("ex:sum", "in-cycle"), "size") == 1


arcs = st.dictionaries(st.sampled_from("abcdef"), st.lists(st.sampled_from("abcdef"), max_size=4))


def reached(graph: dict[str, list[str]], start: str) -> set[str]:
    found = {start}
    waiting = [start]
    while waiting:
        new = set(graph.get(waiting.pop(), ())) - found
        found |= new
        waiting += new
    return found


@given(arcs)
def test_strong_components_are_what_reaches_each_other(graph: dict[str, list[str]]) -> None:
    """Each node is in one of them."""
    pieces = list(strongly_connected_components(graph))
    nodes = {*graph, *(each for found in graph.values() for each in found)}

    assert sorted(each for piece in pieces for each in piece) == sorted(nodes)
    for piece in pieces:
        for one in piece:
            mutual = {each for each in reached(graph, one) if one in reached(graph, each)}
            assert mutual == set(piece)
