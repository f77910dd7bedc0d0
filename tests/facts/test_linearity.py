"""The work that facts take grows with the model, not with its square."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from typing import Any

import pytest
from computed import OF_MODELS, STRAIGHT, Node, frame, pose, shift, store_of

from kinlint.engine.store import Store
from kinlint.facts.computation import facts
from kinlint.facts.spanning_forest import SpanningForest


class Counting:
    """An Oxigraph store that counts what is read from it."""

    def __init__(self, inner: Any, reads: Counter[str]) -> None:
        self.inner = inner
        self.reads = reads

    def quads_for_pattern(self, *pattern: Any) -> Iterator[Any]:
        self.reads["patterns"] += 1
        for quad in self.inner.quads_for_pattern(*pattern):
            self.reads["quads"] += 1
            yield quad

    def __getattr__(self, name: str) -> Any:
        raise AssertionError(f"facts are read by pattern, not by {name}")


def reads(store: Store) -> tuple[Counter[str], int]:
    """How much is read from *store* to find its facts, and how many they are."""
    counter: Counter[str] = Counter()
    store.oxigraph = Counting(store.oxigraph, counter)  # type: ignore[assignment]
    return counter, len(list(facts(store, OF_MODELS)))


def ladder(rungs: int) -> list[Node]:
    """Two rows of frames with poses along both and across: a cycle for each rung."""
    nodes: list[Node] = []
    for index in range(rungs):
        nodes += [*frame(f"l{index}"), *frame(f"r{index}")]
        nodes += pose(f"x{index}", f"r{index}", f"l{index}", STRAIGHT | shift(0, 1, 0))
        if index:
            nodes += pose(f"p{index}", f"l{index}", f"l{index - 1}", STRAIGHT | shift(1, 0, 0))
            nodes += pose(f"q{index}", f"r{index}", f"r{index - 1}", STRAIGHT | shift(1, 0, 0))
    return nodes


def test_twice_the_model_is_read_twice_as_much() -> None:
    """By the same number of scans, and with twice the facts."""
    empty, _ = reads(store_of())
    small, few = reads(store_of(*ladder(20)))
    large, many = reads(store_of(*ladder(40)))

    assert large["patterns"] == small["patterns"]
    assert large["quads"] - empty["quads"] < 2.1 * (small["quads"] - empty["quads"])
    assert many < 2.2 * few


def test_a_model_of_something_else_costs_a_few_scans() -> None:
    """None of which finds anything that belongs to it."""
    other, found = reads(store_of(*({"@id": f"ex:n{n}", "@type": "Affine"} for n in range(50))))
    empty, _ = reads(store_of({"@id": "ex:n", "@type": "Affine"}))

    assert found == 0
    assert other == empty


def test_a_run_without_files_computes_nothing() -> None:
    """Not even a scan."""
    counter, found = reads(Store())

    assert (counter["patterns"], found) == (0, 0)


@pytest.mark.parametrize("size", [100, 1000])
def test_where_two_branches_meet_is_found_by_jumps(
    size: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """On a path of any length in a few steps; the way of a cycle is followed only so far."""
    edges = [(f"n{index}", f"n{index + 1}") for index in range(size)]
    edges += [(f"n{index}", f"n{size - index}") for index in range(size // 2)]
    tree = SpanningForest(edges)
    steps: Counter[str] = Counter()

    class Counted(dict[str, Any]):
        def __getitem__(self, key: str) -> Any:
            steps["looks"] += 1
            return super().__getitem__(key)

    tree.parent, tree._jump = Counted(tree.parent), Counted(tree._jump)
    way = list(tree.way("n0", f"n{size}", 12))

    assert len(way) == 12
    assert steps["looks"] < 120
    assert tree.between("n0", f"n{size}") == size
    assert len(tree.closing) == size // 2
