"""Loops of turning joints with a side that is longer than all others together."""

from __future__ import annotations

from computed import Node, computed, frame, shift

BARS = {"rail": 0.3, "rod": 0.2, "link": 0.25}
"""Lengths of a triangle of bars in m."""


def bar(name: str, size: float, begin: str, end: str) -> list[Node]:
    """A body with a frame at each end, and the distance of these along x."""
    return [
        *frame(begin),
        *frame(end),
        {
            "@id": f"ex:{name}",
            "@type": "SimplicialComplex",
            "simplices": [f"ex:{begin}", f"ex:{end}"],
        },
        position(f"{name}-length", begin, end, size),
    ]


def position(name: str, begin: str, end: str, size: float) -> Node:
    return {
        "@id": f"ex:{name}",
        "@type": ["Position", "PositionCoordinate", "VectorXYZ"],
        "of": f"ex:{end}-origin",
        "with-respect-to": f"ex:{begin}-origin",
        "as-seen-by": f"ex:{begin}",
        "unit": "M",
        **shift(size, 0, 0),
    }


def joint(name: str, kind: str, one: str, other: str) -> list[Node]:
    ends = [f"ex:{one}", f"ex:{other}"]
    return [
        {"@id": f"ex:{name}", "@type": ["Joint", kind], "between-attachments": ends},
        position(f"{name}-offset", one, other, 0),
    ]


def loop(kind: str = "RevoluteJoint", **sizes: float) -> list[Node]:
    size = BARS | sizes
    return [
        *bar("rail", size["rail"], "rail-a", "rail-b"),
        *bar("rod", size["rod"], "rod-b", "rod-c"),
        *bar("link", size["link"], "link-c", "link-a"),
        *joint("a", "RevoluteJoint", "rail-a", "link-a"),
        *joint("b", "SphericalJoint", "rail-b", "rod-b"),
        *joint("c", kind, "rod-c", "link-c"),
    ]


def stretched(*nodes: Node) -> list[tuple[str, float, float]]:
    """The coordinates of sides that are too long, with the length and that of the others."""
    found = computed(*nodes)
    told = [node for node, name, _ in found.triples if name == "fact:other-sides"]
    return [
        (node, found.value(node, "side-length"), found.value(node, "other-sides")) for node in told
    ]


def test_a_triangle_closes() -> None:
    """As long as no side is above the sum of the others, even if it is equal."""
    assert stretched(*loop()) == []
    assert stretched(*loop(rail=0.45)) == []


def test_one_side_is_too_long() -> None:
    """The coordinates of the longest side are told, with its length and that of the others."""
    assert stretched(*loop(link=2.5)) == [("ex:link-length", 2.5, 0.5)]


def test_slides_change_lengths() -> None:
    """A loop with a prismatic joint is left out."""
    assert stretched(*loop("PrismaticJoint", link=2.5)) == []


def test_unknown_lengths() -> None:
    """A loop with a side without numbers is left out."""
    nodes = [each for each in loop(link=2.5) if each["@id"] != "ex:rod-length"]

    assert stretched(*nodes) == []
