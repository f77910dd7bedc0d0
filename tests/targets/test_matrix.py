"""The matrix has the features of a robot by consumers, as a table, as JSON and as a page."""

import json
from html.parser import HTMLParser

import pytest
from targets.simulator_fixtures import MJCF, SDF
from targets.urdf_fixtures import FIXTURES

from kinlint.cli.main import main

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
@pytest.mark.parametrize(("suffix", "files"), [("xml", MJCF), ("sdf", SDF)])
def test_each_feature_of_simulators_has_a_row(suffix, files, tmp_path, monkeypatch, capsys):
    """A file has the row of each of its features, and none of another format's."""
    monkeypatch.chdir(tmp_path)
    for feature in files.keys() - {"mjcf", "sdf"}:
        (tmp_path / f"arm.{suffix}").write_text(files[feature], "utf-8")
        assert main(["targets", "--matrix", f"arm.{suffix}", "--output-format", "json"]) == 0
        rows = {each["feature"] for each in json.loads(capsys.readouterr().out)["features"]}
        assert feature in rows
        assert not rows & FIXTURES.keys()


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
    """A rule that reports it has its name, or the vocabulary a query."""
    (tmp_path / "arm.urdf").write_text(FIXTURES[feature], "utf-8")
    command = ["targets", "--matrix", str(tmp_path / "arm.urdf"), "--output-format", "json"]
    assert main(command) == 0
    rows = json.loads(capsys.readouterr().out)["features"]
    assert feature in {each["feature"] for each in rows}


def test_a_table_is_divided_where_it_is_too_wide(hand, capsys, monkeypatch):
    """Each part begins with the names of its columns."""
    monkeypatch.setattr("kinlint.cli.target_matrix.WIDE", 60)
    assert main(["targets", "--matrix", hand]) == 0
    table, _, _ = capsys.readouterr().out.partition("adapted")
    assert max(map(len, table.splitlines())) <= 60
    assert table.count("link fixed to its parent (2)") > 1


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
