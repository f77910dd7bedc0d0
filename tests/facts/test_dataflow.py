"""Where data come from that operators read."""

from __future__ import annotations

from computed import Node, computed

KIN = "https://w3id.org/kinlint/kinematics#"
READER: Node = {"@id": "ex:op", f"{KIN}reads": {"@id": "ex:datum"}}


def coordinates(name: str, **said: object) -> Node:
    return {"@id": f"ex:{name}", f"{KIN}coordinate-of": {"@id": "ex:relation"}, **said}


def test_numbers_supply_all_coordinates_of_one_relation() -> None:
    """The same pose by other numbers can be computed; it is found by way of the relation."""
    found = computed(READER, coordinates("datum"), coordinates("known", **{f"{KIN}x": 0.5}))

    assert found.value("ex:datum", "supplied-by") == "ex:known"


def test_a_list_of_numbers_supplies_the_coordinates_that_have_it() -> None:
    """Direction cosines are lists."""
    row = {f"{KIN}row": {"@list": [1.0, 0.0, 0.0]}}

    assert computed(READER, coordinates("datum", **row)).value("ex:datum", "supplied-by") == (
        "ex:datum"
    )


def test_what_an_operator_writes_is_supplied() -> None:
    """Written itself, or as its relation, or as other coordinates of that."""
    for written in ("datum", "relation", "other"):
        writer = {"@id": "ex:writer", f"{KIN}writes": {"@id": f"ex:{written}"}}
        found = computed(READER, writer, coordinates("datum"), coordinates("other"))

        assert found.value("ex:datum", "supplied-by") == f"ex:{written}"


def test_what_nothing_writes_is_supplied_by_nothing() -> None:
    """Words are no numbers, and numbers of another relation are of no use."""
    words = coordinates("datum", **{f"{KIN}note": "set later"})
    stranger = {"@id": "ex:x", f"{KIN}coordinate-of": {"@id": "ex:elsewhere"}, f"{KIN}x": 0.5}

    assert computed(READER, words, stranger).values("ex:datum", "supplied-by") == []
