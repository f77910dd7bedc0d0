"""`--profile`: the symptoms that come with a format, a line for each symptom and file."""

import re

import pyoxigraph as ox
import pytest

from kinlint import resources
from kinlint.cli.main import main
from kinlint.format_profile import lines, profile
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import decode, read
from kinlint.formats.usd.prim_schemas import prim_schemas
from kinlint.vocabulary import ATTRIBUTE, FMT

ARM = """
<robot name="arm">
  <link name="base"/>
  <link name="tool"><inertial><origin xyz="0 0 1"/><mass value="2"/></inertial></link>
  <joint name="elbow" type="revolute">
    <origin xyz="0 0 1" rpy="0 0 1"/>
    <parent link="base"/>
    <child link="tool"/>
    <limit lower="-1" upper="1" effort="2" velocity="3"/>
    <dynamics damping="0.1"/>
  </joint>
  <transmission name="drive"><joint name="elbow"/></transmission>
</robot>
"""
FORMATS = ("collada", "sdf", "srdf", "urdf")


def told(text, name="arm.urdf"):
    document = read(decode(name, text.encode()), ReadOptions())
    return dict(line.removeprefix(f"{name}: ").split(": ", 1) for line in lines([document]))


def test_each_symptom_is_a_line_with_what_shows_it():
    """Most of it first; what is not there is left out, and so is what has nothing."""
    found = told(ARM)

    assert found["AP1.1"] == (
        "elements take no name, so nothing can refer to them: "
        "2 origin, 1 child, 1 dynamics, 1 inertial, 1 limit, 1 mass, 1 parent"
    )
    assert found["AP3.3"] == "dampings are linear: 1 damping"
    assert found["AP3.6"] == "orientations are roll, pitch and yaw: 1 rpy"
    assert "AP3.4" not in found


def test_joints_of_a_transmission_are_none_of_the_robot():
    """They share its tags."""
    assert told(ARM)["AP3.13"] == "kinds come from closed lists: 1 joint"


def test_symptoms_come_in_the_order_of_the_anti_patterns():
    """AP3.10 after AP3.9."""
    found = list(told(ARM))

    assert found == sorted(found, key=lambda each: [int(n) for n in re.findall(r"\d+", each)])


def test_sdf_and_srdf_have_profiles_of_their_own():
    """A symptom may be of one format only."""
    sdf = told(
        '<sdf version="1.9"><model name="m"><pose>0 0 1 0 0 0</pose><link name="a"/></model></sdf>',
        "m.sdf",
    )
    srdf = told(
        '<robot name="arm"><group name="g"><chain base_link="a" tip_link="b"/></group></robot>',
        "arm.srdf",
    )

    assert sdf["AP1.4"].endswith(": 1 pose")
    assert "AP3.1" not in sdf
    assert srdf["AP5.6"].endswith(": 1 base_link, 1 tip_link")


def test_models_that_are_composable_have_nothing_inherent():
    """They were made to have none."""
    assert told('{"@context": {"@vocab": "https://example.org/"}, "a": 1}', "arm.jsonld") == {}


@pytest.mark.parametrize("form", FORMATS)
def test_a_profile_counts_what_the_format_has(form):
    """No slip of the pen in a property: each is an element or an attribute of the schema."""
    files = (resources.data("shapes") / "formats").glob(f"{form}*.ttl")
    quads = [quad for file in files for quad in ox.parse(path=file, format=ox.RdfFormat.TURTLE)]
    namespace = f"https://w3id.org/kinlint/{form}#"
    tags = {namespace + q.object.value for q in quads if q.predicate.value == f"{FMT}tag"}
    kinds = {"text", "number", "integer", "boolean", "vectors", "vector3", "vector4"}
    attributes = {
        ATTRIBUTE + q.object.value + suffix
        for q in quads
        if q.predicate.value.removeprefix(FMT) in kinds
        for suffix in (("", "-1") if "vector" in q.predicate.value else ("",))
    }
    known = profile(form)
    counted = {term for symptom in known.symptoms for term in symptom.shown_by}

    assert known.symptoms
    assert {term.strip("<>") for term in counted | known.passed_over} <= tags | attributes


def test_a_profile_of_usd_counts_properties_of_schemas():
    """No slip of the pen, either; those of multiple schemas stand for angular and linear ones."""
    known = {
        f"<{ATTRIBUTE}{name.replace('*', instance)}"
        for schema in prim_schemas().values()
        for name in schema.properties
        for instance in ("angular", "linear")
    }
    counted = {term for symptom in profile("usd").symptoms for term in symptom.shown_by}

    assert counted
    assert {re.sub("(-1)?>$", "", each) for each in counted if ATTRIBUTE in each} <= known


@pytest.mark.parametrize("form", [*FORMATS, "usd"])
def test_a_symptom_is_told_once(form):
    """One line each."""
    numbers = [symptom.number for symptom in profile(form).symptoms]

    assert len(numbers) == len(set(numbers))
    assert all(re.fullmatch(r"AP[1-6]\.\d\d?", number) for number in numbers)


def test_the_option_shows_the_profile_and_stops(tmp_path, monkeypatch, capsys):
    """No rule speaks; a file that cannot be read makes the exit code 2."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "arm.urdf").write_text(ARM, "utf-8")
    assert main(["--profile", "arm.urdf"]) == 0
    out, err = capsys.readouterr()

    assert out.startswith("arm.urdf: AP1.1: elements take no name")
    assert not err

    (tmp_path / "leg.jsonld").write_text("{", "utf-8")
    assert main(["--profile", "."]) == 2
    out, err = capsys.readouterr()
    assert out.startswith("arm.urdf: AP1.1")
    assert "leg.jsonld" in err
