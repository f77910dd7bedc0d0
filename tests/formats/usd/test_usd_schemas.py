"""The schemas of USD are those that packages register, and what is added fits them.

The packages with schemas lie where KINLINT_USD_PLUGINS says, as paths of directories with a
`plugInfo.json`, and the list of units where KINLINT_USD_UNITS says, or beside the data.
"""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from usd_schemas import elements

from kinlint.formats.usd.prim_schemas import (
    base_types,
    expanded,
    owners_of,
    prim_schemas,
    properties_of,
)
from kinlint.formats.xml.schema import schema
from kinlint.resources import data


@pytest.mark.external
def test_the_file_is_what_the_script_makes_of_the_packages() -> None:
    """The packages register their schemas in the process, so no other test may do it."""
    pytest.importorskip("pxr")
    plugins = os.environ.get("KINLINT_USD_PLUGINS")
    shared = Path(__file__).resolve().parents[4] / "shared" / "reference" / "usd-collada"
    units = Path(os.environ.get("KINLINT_USD_UNITS", shared / "schemas" / "usd-physics.tsv"))
    if not plugins or not units.exists():
        pytest.skip("set KINLINT_USD_PLUGINS to directories, and KINLINT_USD_UNITS to the list")
    made = elements(units, [Path(each) for each in plugins.split(os.pathsep)])
    kept = data("shapes") / "formats" / "usd-elements.ttl"
    assert kept.read_text(encoding="utf-8") == made


def test_what_is_referred_to_is_there() -> None:
    known = prim_schemas()
    for each in known.values():
        others = (each.extends, *each.includes, *each.applies_to)
        assert set(others) - {""} <= set(known), each.name
        for property_ in each.properties.values():
            assert set(property_.targets) <= set(known), property_.name
            assert not property_.reference or property_.type == "rel", property_.name


def test_additions_speak_of_properties_that_there_are() -> None:
    """Choices, units and references of a property stand beside its type."""
    for name, types in schema("usd").types.items():
        known = prim_schemas().get(name)
        for each in types:
            for place in each.choices:
                assert known is None or place in known.properties, (name, place)


def test_a_revolute_joint_has_what_every_joint_has() -> None:
    found = properties_of("PhysicsRevoluteJoint", ())
    assert base_types("PhysicsRevoluteJoint") == (
        "PhysicsRevoluteJoint",
        "PhysicsJoint",
        "Imageable",
    )
    assert (found["physics:lowerLimit"].type, found["physics:lowerLimit"].unit) == (
        "float",
        "degree",
    )
    assert found["physics:localPos0"].type == "point3f"
    assert found["physics:axis"].choices == ("X", "Y", "Z")
    assert found["physics:axis"].uniform
    assert found["physics:body0"].reference.endswith("body0")
    assert "physics:mass" not in found


def test_an_instance_gives_properties_their_names() -> None:
    found = properties_of("PhysicsRevoluteJoint", ("PhysicsDriveAPI:angular",))
    assert found["drive:angular:physics:maxForce"].type == "float"
    assert found["drive:angular:physics:type"].choices == ("force", "acceleration")
    assert "drive:linear:physics:maxForce" not in found
    assert owners_of("drive:angular:physics:maxForce") == (("PhysicsDriveAPI",), "angular")
    assert owners_of("drive:angular:physics:maximum") == ((), "angular")


def test_a_schema_brings_others() -> None:
    """NewtonMassAPI applies PhysicsMassAPI."""
    assert expanded(("NewtonMassAPI",)) == ("NewtonMassAPI", "PhysicsMassAPI")
    assert "physics:mass" in properties_of("Xform", ("NewtonMassAPI",))


def test_schemas_of_vendors_are_known() -> None:
    known = prim_schemas()
    assert {"NewtonActuator", "PhysxRigidBodyAPI", "MjcJointAPI", "IsaacRobotAPI"} <= set(known)
    assert not {"DistancePhysicsJoint", "prim", "stage"} & set(known)
    assert known["PhysxMimicJointAPI"].replaced_by == "NewtonMimicAPI"
