"""Efforts are compared at the joint, and the mass of a whole only where all of it is known."""

from __future__ import annotations

import json

from kinlint.cli.main import main

ARM = """<mujoco>
  <compiler inertiafromgeom="auto"/>
  <asset>{asset}</asset>
  <worldbody>
    <body name="base"><geom size="0.1" mass="5"/>
      <body name="arm" pos="0 0 1">
        <joint name="elbow" axis="0 1 0" range="-90 90"/>
        {geom}
      </body>
    </body>
  </worldbody>
  <actuator><motor joint="elbow" gear="{gear}" ctrlrange="-{control} {control}"/></actuator>
</mujoco>
"""
BALL = '<geom size="0.1" mass="1"/>'
HULL = '<mesh name="hull" file="meshes/hull.stl"/>'


def changes(tmp_path, capsys, *models):
    """The quantities that differ between two models."""
    files = []
    for number, model in enumerate(models):
        path = tmp_path / f"arm{number}.xml"
        path.write_text(model, "utf-8")
        files.append(str(path))
    main(["diff", "--output-format", "json", *files])
    said = json.loads(capsys.readouterr().out)[0]
    return {(each["kind"], each["quantity"]) for each in said["changes"]}


def test_what_a_gear_makes_of_a_force_is_compared(tmp_path, capsys):
    """A gear of 100 and a control of 0.4 are a gear of 40 and a control of 1."""
    one = ARM.format(asset="", geom=BALL, gear=100, control=0.4)
    other = ARM.format(asset="", geom=BALL, gear=40, control=1)
    third = ARM.format(asset="", geom=BALL, gear=50, control=1)

    assert changes(tmp_path, capsys, one, other) == set()
    assert ("joint", "effort limit") in changes(tmp_path, capsys, one, third)


def test_a_mass_that_a_mesh_decides_is_not_part_of_a_sum(tmp_path, capsys):
    """The mass of the robot is not said to differ."""
    known = ARM.format(asset="", geom=BALL, gear=1, control=1)
    unknown = ARM.format(asset=HULL, geom='<geom type="mesh" mesh="hull"/>', gear=1, control=1)

    assert ("robot", "mass") not in changes(tmp_path, capsys, known, unknown)
