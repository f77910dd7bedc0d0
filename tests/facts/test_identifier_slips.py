"""What identifiers resemble that nobody describes, and names for what has none."""

from __future__ import annotations

import pytest
from computed import Computed, Node, store_of

from kinlint.facts.computation import facts, hints
from kinlint.facts.fact_statements import fact


def hinted(*nodes: Node) -> Computed:
    """What rules and repairs are told of a file with these nodes."""
    store, wanted = store_of(*nodes), frozenset({fact("slip-for"), fact("free-name")})
    return Computed([*facts(store, wanted), *hints(store, wanted)])


def frame(origin: str, *points: str) -> Computed:
    """The same of a frame with this origin, beside points."""
    given = [{"@id": f"ex:{point}", "@type": "Point"} for point in points]
    return hinted({"@id": "ex:tool", "@type": "Frame", "origin": f"ex:{origin}"}, *given)


def test_a_slip_is_for_what_lies_nearest() -> None:
    """The nearest described identifier of the namespace is meant."""
    found = frame("tol-origin", "tool-origin", "elbow-origin")
    assert found.value("ex:tol-origin", "slip-for") == "ex:tool-origin"


@pytest.mark.parametrize(
    ("origin", "points"),
    [
        ("origin1", ["origin2"]),
        ("left-tip", ["heft-tip", "deft-tip"]),
        ("nowhere", ["tip"]),
        ("a", ["b"]),
        ("tip", ["tip", "tap"]),
    ],
)
def test_what_is_not_one_slip_away_from_one_name_is_left(origin: str, points: list[str]) -> None:
    """Siblings with another number, ties and words of their own are no slips."""
    assert frame(origin, *points).values(f"ex:{origin}", "slip-for") == []


def test_terms_are_compared_with_those_of_their_kind() -> None:
    """A class is a slip for a class, a property for a property."""
    found = hinted({"@id": "ex:elbow", "@type": "kc:RevoluteJiont", "kc:atachments": 1})
    (slip,) = [(start, end) for start, name, end in found.triples if name == "fact:slip-for"]
    assert [each.rpartition("#")[2] for each in slip] == ["RevoluteJiont", "RevoluteJoint"]


def test_names_are_made_of_the_type_and_a_free_number() -> None:
    """What has a name is not called so again."""
    found = hinted(
        {"@id": "ex:revolute-joint-1", "@type": "Frame"},
        {"@id": "ex:arm", "@type": "KinematicChain", "joints": [{"@type": "RevoluteJoint"}] * 2},
    )
    names = sorted(end for _, name, end in found.triples if name == "fact:free-name")
    assert names == ["ex:revolute-joint-2", "ex:revolute-joint-3"]
