"""The matrix has the features of a robot by consumers, as a table, as JSON and as a page."""

import json
from html.parser import HTMLParser
from pathlib import Path

import pytest
from facts.arm_in_formats import Arm, collada, xacro
from support.linting import lint
from targets.simulator_fixtures import MJCF, SDF
from targets.stage_fixtures import USD
from targets.urdf_fixtures import FIXTURES, MESHES

from kinlint.cli.main import main
from kinlint.configuration.settings import FileSettings
from kinlint.targets.consumer_files import consumer_table
from kinlint.targets.portability import departing_targets

SAMPLES = Path(__file__).parents[2] / "samples"
HAND = """<robot name="hand" version="1.1">
  <link name="palm"><inertial><mass value="1"/>
    <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <link name="left"/><link name="right"/>
  <joint name="a" type="fixed"><parent link="palm"/><child link="left"/>
    <origin quat_xyzw="1 0 0 0"/></joint>
  <joint name="b" type="fixed"><parent link="palm"/><child link="right"/></joint>
</robot>
"""


@pytest.fixture
def hand(tmp_path, monkeypatch):
    """The name of a file in the working directory."""
    (tmp_path / "hand.urdf").write_text(HAND, "utf-8")
    monkeypatch.chdir(tmp_path)
    return "hand.urdf"


def test_rows_are_features_with_their_places(hand, capsys):
    """What is read differently comes first; a version is a column of its own."""
    command = ["targets", "mujoco@3.3", "pinocchio", "--matrix", hand, "--output-format", "json"]
    assert main(command) == 0

    said = json.loads(capsys.readouterr().out)

    assert said["targets"] == ["mujoco@3.3", "pinocchio"]
    rows = {each["feature"]: each for each in said["features"]}
    assert rows["fixed-child"]["places"] == ["hand.urdf:5:25", "hand.urdf:7:25"]
    assert rows["quaternion"]["advice"] == "Write the orientation as 'rpy'."
    behaviours = {name: cell["behaviour"] for name, cell in rows["quaternion"]["targets"].items()}
    assert behaviours == {"mujoco@3.3": "ignored-silently", "pinocchio": "honoured"}
    alike = [each["alike"] for each in said["features"]]
    assert alike == sorted(alike)


def test_what_all_read_alike_is_told_too(hand, capsys):
    """A feature that no target departs from has a row."""
    assert main(["targets", "pinocchio", "--matrix", hand]) == 0
    told = capsys.readouterr().out
    assert "quat_xyzw (1)" in told
    assert "quat_xyzw, at" not in told


def test_a_healthy_robot_has_rows(tmp_path, monkeypatch, capsys):
    """Features that no rule reports are told, each with its place."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "arm.urdf").write_text(FIXTURES["plain"], "utf-8")
    assert main(["targets", "--matrix", "arm.urdf", "--output-format", "json"]) == 0
    rows = {each["feature"]: each for each in json.loads(capsys.readouterr().out)["features"]}
    assert rows["revolute-joint"]["places"] == ["arm.urdf:5:16", "arm.urdf:10:16"]
    assert rows["revolute-joint"]["alike"]
    assert rows["inertia"]["targets"]["pybullet"]["behaviour"] == "changed"
    assert {"box", "effort-limit", "position-limits"} <= rows.keys()


@pytest.mark.slow
@pytest.mark.parametrize(("suffix", "files"), [("xml", MJCF), ("sdf", SDF), ("usda", USD)])
def test_each_feature_of_simulators_has_a_row(suffix, files, tmp_path, monkeypatch, capsys):
    """A file has the row of each of its features, and none of another format's."""
    monkeypatch.chdir(tmp_path)
    for feature in files.keys() - {"mjcf", "sdf", "usd"}:
        (tmp_path / f"arm.{suffix}").write_text(files[feature], "utf-8")
        assert main(["targets", "--matrix", f"arm.{suffix}", "--output-format", "json"]) == 0
        rows = {each["feature"] for each in json.loads(capsys.readouterr().out)["features"]}
        assert feature in rows
        assert not rows & FIXTURES.keys()


def _rows(capsys, *files):
    """The features that the matrix of *files* has."""
    command = ["targets", *(word for file in files for word in ("--matrix", str(file)))]
    assert main([*command, "--output-format", "json"]) == 0
    return {each["feature"] for each in json.loads(capsys.readouterr().out)["features"]}


def _known(prefix):
    """The features that the vocabulary can find in a format."""
    features = consumer_table().features.values()
    return {each.name for each in features if each.query and each.name.startswith(prefix)}


@pytest.mark.slow
def test_a_document_of_collada_has_rows(tmp_path, capsys):
    """Axes, bodies and what ties them, each with what its readers make of it."""
    arm = collada(Arm())
    axis, info = '<revolute sid="axis0"><axis>0 1 0</axis>', "arm/j2/axis0"
    told = f"""<library_articulated_systems>
<articulated_system id="a"><kinematics><technique_common>
<axis_info axis="{info}"><locked><bool>true</bool></locked></axis_info></technique_common>
</kinematics></articulated_system>
<articulated_system id="m"><motion><technique_common><axis_info axis="{info}">
<speed><float>1</float></speed><acceleration><float>2</float></acceleration></axis_info>
</technique_common></motion></articulated_system></library_articulated_systems>"""
    whole = arm.replace(axis, f'<prismatic sid="x"><axis>0 1 0</axis></prismatic>{axis}', 1)
    whole = whole.replace(
        '<link sid="l3" name="hand"></link>',
        '<link sid="l3" name="hand"><attachment_start joint="arm/j1"/></link>',
    )
    whole = whole.replace(
        "</technique_common></kinematics_model>",
        """<formula><target><param>arm/j3/axis0</param></target><technique_common/></formula>
</technique_common></kinematics_model>""",
    )
    whole = whole.replace(
        "<sphere><radius>0.05</radius></sphere>",
        "<capsule><height>0.1</height><radius>0.05 0.05</radius></capsule>",
    )
    whole = whole.replace(
        '<node id="n3" name="hand">', '<node id="n3" name="hand"><instance_geometry url="#g"/>'
    )
    whole = whole.replace("<library_kinematics_models>", f"{told}<library_kinematics_models>")
    (tmp_path / "arm.dae").write_text(arm, "utf-8")
    (tmp_path / "all.dae").write_text(whole, "utf-8")
    rows = _rows(capsys, tmp_path / "arm.dae") | _rows(capsys, tmp_path / "all.dae")
    assert rows == _known("collada-")


@pytest.mark.slow
def test_composable_models_have_rows(tmp_path, capsys):
    """Joints, couplings, limits and shapes, in JSON-LD as in Turtle."""
    (tmp_path / "left.ttl").write_text(
        "<urn:elbow> <https://w3id.org/kinlint/kinematics#handedness>"
        " <https://w3id.org/kinlint/kinematics#LeftHanded> .",
        "utf-8",
    )
    rows = _rows(capsys, tmp_path / "left.ttl")
    for name in ("joint-kinds", "gripper", "orientations"):
        rows |= _rows(capsys, SAMPLES / name)
    assert rows == _known("model-")


def test_a_xacro_has_the_rows_of_urdf(tmp_path, capsys):
    """Consumers read what it expands to."""
    (tmp_path / "arm.urdf.xacro").write_text(xacro(Arm()), "utf-8")
    assert {"revolute-joint", "inertia"} <= _rows(capsys, tmp_path / "arm.urdf.xacro")


def test_targets_that_do_not_read_a_format_are_named_once(tmp_path, monkeypatch, capsys):
    """They have no column."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "arm.sdf").write_text(SDF["sdf"], "utf-8")
    assert main(["targets", "mujoco", "pybullet", "--matrix", "arm.sdf"]) == 0
    told = capsys.readouterr().out.splitlines()
    assert told[0] == "mujoco does not read SDF."
    assert told[1].split() == ["pybullet"]


@pytest.mark.slow
@pytest.mark.parametrize("feature", sorted(FIXTURES.keys() - {"plain"}))
def test_each_feature_has_a_row(feature, tmp_path, capsys):
    """A rule that reports it has its name, or the vocabulary a query.

    With targets that depart from it, one finding tells what they do.
    """
    for name, content in MESHES.items():
        (tmp_path / name).write_bytes(content)
    if targets := tuple(departing_targets([feature])):
        text = {str(tmp_path / "arm.urdf"): FIXTURES[feature]}
        found = lint(text, default=FileSettings(targets=targets)).findings
        told = [each for each in found if each.feature == feature and each.departures]
        assert len({each.rule.code for each in told}) == 1
    else:
        (tmp_path / "arm.urdf").write_text(FIXTURES[feature], "utf-8")
        assert feature in _rows(capsys, tmp_path / "arm.urdf")


def test_a_table_is_divided_where_it_is_too_wide(hand, capsys, monkeypatch):
    """Each part begins with the names of its columns."""
    monkeypatch.setattr("kinlint.cli.target_matrix.WIDE", 60)
    assert main(["targets", "--matrix", hand]) == 0
    table, _, _ = capsys.readouterr().out.partition("adapted")
    assert max(map(len, table.splitlines())) <= 60
    assert table.count("link fixed to its parent (2)") > 1


@pytest.mark.slow
def test_a_page_is_well_formed(hand, capsys, tmp_path):
    """It has a row for each feature and a cell for each consumer."""
    assert main(["targets", "--matrix", hand, "-o", "page.html"]) == 0
    assert main(["targets", "--matrix", hand, "--output-format", "json"]) == 0
    said = json.loads(capsys.readouterr().out)
    counted = dict.fromkeys(("tr", "td", "th"), 0)

    class Counter(HTMLParser):
        def handle_starttag(self, tag, attrs):
            if tag in counted:
                counted[tag] += 1

    Counter().feed((tmp_path / "page.html").read_text("utf-8"))
    rows, columns = len(said["features"]), len(said["targets"])
    assert counted == {"tr": rows + 1, "td": rows * columns, "th": rows + 1 + columns}


def test_a_file_that_is_no_robot_is_an_error(tmp_path, capsys):
    """As for all commands."""
    assert main(["targets", "--matrix", str(tmp_path / "nowhere.urdf")]) == 2
    assert "nowhere.urdf" in capsys.readouterr().err
