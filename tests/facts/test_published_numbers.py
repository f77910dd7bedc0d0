"""What is computed from the published models."""

from __future__ import annotations

from pathlib import Path

import pytest
from computed import Computed, closed
from data import locate_data

from kinlint.facts.computation import facts

KINOVA = "https://comp-rob2b.github.io/robots/kinova/gen3/7dof/"
TUTORIAL = "https://comp-rob2b.github.io/modelling-tutorial/robot#"


def of(*parts: str) -> Computed:
    files = sorted(Path(locate_data("comp-rob2b", *parts)).rglob("*.json"))
    return Computed(facts(closed({file.name: file.read_text("utf-8") for file in files})))


@pytest.fixture(scope="module")
def kinova() -> Computed:
    return of("robot-models")


def test_all_rotations_of_the_kinova_are_proper(kinova: Computed) -> None:
    """Eight poses from frame to frame."""
    found = {s: o for s, p, o in kinova.triples if p == "fact:determinant"}
    missed = [o for _, p, o in kinova.triples if p == "fact:orthonormality"]

    assert len(found) == 8
    assert set(found.values()) == {1.0}
    assert set(missed) == {0.0}


def test_the_kinova_weighs_eight_kilograms(kinova: Computed) -> None:
    """In eight links."""
    masses = [o for _, p, o in kinova.triples if p == "fact:mass"]

    assert len(masses) == 8
    assert sum(masses) == pytest.approx(8.1872)


def test_each_link_of_the_kinova_can_exist(kinova: Computed) -> None:
    """No principal moment exceeds the sum of the others, and centres are where they say."""
    links = [s for s, p, _ in kinova.triples if p == "fact:least-moment"]

    assert len(links) == 8
    for link in links:
        found = kinova.of(link)
        assert 0 < found["least-moment"]
        assert found["greatest-moment"] < found["least-moment"] + found["middle-moment"]
        assert found["centre-distance"] == 0


def test_the_kinova_is_one_chain_without_cycles(kinova: Computed) -> None:
    """Of seven joints."""
    (piece,) = kinova.values(f"{KINOVA}chain", "component")

    assert kinova.value(piece, "size") == 7
    assert not kinova.nodes("cycle")
    assert not kinova.nodes("agreement")


def test_the_tutorial_states_a_reflection() -> None:
    """Between frames that are right-handed."""
    found = of("modelling-tutorial", "models")
    pose = found.of(f"{TUTORIAL}pose-link1-joint1-wrt-link1-root-coord")

    assert (pose["determinant"], pose["orthonormality"]) == (-1, 0)
    assert (pose["x"], pose["y"], pose["z"]) == (1, 2, 3)
    assert len(found.values(f"{TUTORIAL}schedule1", "step")) == 2
