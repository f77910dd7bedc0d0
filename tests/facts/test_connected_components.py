"""Connected pieces of kinematic chains."""

from __future__ import annotations

from computed import Node, computed


def body(name: str, *attachments: str) -> Node:
    simplices = [f"ex:{each}" for each in attachments]
    return {"@id": f"ex:{name}", "@type": "SimplicialComplex", "simplices": simplices}


def joint(name: str, *attachments: str) -> Node:
    ends = [f"ex:{each}" for each in attachments]
    return {"@id": f"ex:{name}", "@type": "Joint", "between-attachments": ends}


def chain(*joints: str) -> Node:
    listed = [f"ex:{each}" for each in joints]
    return {"@id": "ex:chain", "@type": "KinematicChain", "joints": listed}


BODIES = [body("base", "a"), body("arm", "b", "c"), body("hand", "d"), body("tool", "e")]


def test_a_connected_chain_is_one_piece() -> None:
    """Whose members are its joints and the bodies they join."""
    found = computed(*BODIES, joint("one", "a", "b"), joint("two", "c", "d"), chain("two", "one"))
    (piece,) = found.values("ex:chain", "component")

    assert found.of(piece) == {"size": 2, "first": "ex:two", "derived-from": "ex:chain"}
    assert set(found.values(piece, "member")) == {
        "ex:one",
        "ex:two",
        "ex:base",
        "ex:arm",
        "ex:hand",
    }


def test_pieces_are_told_apart() -> None:
    """Also where a joint that the chain does not list would connect them."""
    joints = [joint("one", "a", "b"), joint("two", "d", "e"), joint("other", "c", "d")]
    found = computed(*BODIES, *joints, chain("two", "one"))
    pieces = found.values("ex:chain", "component")

    assert sorted(found.value(piece, "first") for piece in pieces) == ["ex:one", "ex:two"]
    assert [found.value(piece, "size") for piece in pieces] == [1, 1]


def test_an_attachment_on_no_body_leaves_it_undecided() -> None:
    """So does a joint without attachments."""
    for loose in (joint("two", "c", "nowhere"), joint("two")):
        found = computed(*BODIES, joint("one", "a", "b"), loose, chain("one", "two"))

        assert found.of("ex:chain") == {"undecided": "ex:two"}
        assert not found.nodes("component")
