"""The elements of COLLADA are those of the classes of its schema, and what is added fits them.

The list of classes lies where KINLINT_COLLADA_CLASSES says, or beside the data.
"""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from collada_classes import elements

from kinlint.formats.xml.schema import schema
from kinlint.resources import data


def table() -> Path:
    """The list of classes; the test is skipped where it is absent."""
    shared = Path(__file__).resolve().parents[4] / "shared" / "reference" / "usd-collada"
    beside = shared / "schemas" / "collada-kinematics.tsv"
    path = Path(os.environ.get("KINLINT_COLLADA_CLASSES", beside))
    if not path.exists():
        pytest.skip(f"no classes at {path}; set KINLINT_COLLADA_CLASSES to their list")
    return path


def test_the_file_is_what_the_script_makes_of_the_classes() -> None:
    kept = data("shapes") / "formats" / "collada-elements.ttl"
    assert kept.read_text(encoding="utf-8") == elements(table())


def test_each_address_leads_to_elements_that_there_are() -> None:
    types = schema("collada").types
    for same in types.values():
        for each in same:
            for address in each.addresses.values():
                assert set(address.targets) <= set(types), (each.tag, address)


def test_a_tag_means_what_its_place_says() -> None:
    """An axis has numbers in a joint, a path in an axis_info, and a child in a binding."""
    root = schema("collada").roots["COLLADA"]
    joint = root.children["library_joints"].children["joint"]
    scene = root.children["scene"].children["instance_kinematics_scene"]
    assert joint.children["revolute"].children["axis"].content is not None
    assert set(scene.children["bind_joint_axis"].children["axis"].children) == {"SIDREF", "param"}
