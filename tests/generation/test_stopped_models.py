"""Wrong models, each with one fault, of which no program is written."""

from __future__ import annotations

from pathlib import Path

import pytest
from test_wrong_models import WRONG, model

from kinlint.cli.main import main

pytest.importorskip("jinja2")
pytestmark = [pytest.mark.slow]

SAMPLE = Path(__file__).resolve().parents[2] / "samples" / "one-dof"
LIBRARIES = ("kdl", "numpy", "pinocchio")
RELATIVE, LINK, WHOLE = (
    f'"rob:pose-{each}-coord"'
    for each in (
        "link2-root-wrt-link1-joint1",
        "link1-joint1-wrt-link1-root-position",
        "link2-root-wrt-link1-root",
    )
)
BOTH = '[ "rob:fpk1", "rob:compose-pose1" ]'
FAULTS = {
    "operators in the wrong order": (BOTH, '[ "rob:compose-pose1", "rob:fpk1" ]', "ALG003"),
    "an operator that is not scheduled": (BOTH, '[ "rob:compose-pose1" ]', "GEN007"),
    "half of the schedule": (BOTH, '[ "rob:fpk1" ]', "ALG014"),
    "an empty schedule": (BOTH, "[]", "ALG008"),
    "a schedule of a name misspelt": (BOTH, BOTH.replace("fpk1", "fpk2"), "GEN007"),
    "the result as an operand": (f'"in2": {RELATIVE}', f'"in2": {WHOLE}', "ALG002"),
    "the operand as a result": (f'"composite": {WHOLE}', f'"composite": {RELATIVE}', "ALG002"),
    "no result": (f',\n      "composite": {WHOLE}', "", "ALG001"),
    "an operand only": (f'"in2": {RELATIVE},\n      ', "", "ALG001"),
    "kinematics of another pose": (f'motion": {RELATIVE}', f'motion": {WHOLE}', "GEN008"),
    "kinematics of a stated pose": (f'motion": {RELATIVE}', f'motion": {LINK}', "GEN008"),
    "kinematics of no joint": ('"joint": "rob:joint1",\n      ', "", "ALG001"),
    "kinematics of a lost joint": ('"joint": "rob:joint1"', '"joint": "rob:joint9"', "LD006"),
    "kinematics at no position": ('"joint-space-motion": "rob:q1",\n      ', "", "ALG001"),
    "kinematics at a pose": ('-motion": "rob:q1"', f'-motion": {RELATIVE}', "ALG013"),
    "an unknown operator": ('"@type": "ComposePose"', '"@type": "ComposeTwist"', "LD003"),
    "an angle in metres": ('"unit": "RAD"', '"unit": "M"', "UNI002"),
    "a reflection": ("[ -1.0, 0.0, 0.0 ]", "[ 1.0, 0.0, 0.0 ]", "FRM004"),
    "an offset off the axis": (
        '"x": 0.0,\n      "y": 0.0,\n      "z": 0.42',
        '"x": 0.1,\n      "y": 0.0,\n      "z": 0.42',
        "GEN002",
    ),
    "two axes": ('"direction-cosine-x": [ 0.0, 0.0, 1.0 ],', "", "FRM017"),
}
"""What is replaced in the sample by what, and the code of a finding about it."""


def stopped(capsys, library, *models):
    """What is shown as *library* refuses *models* and writes nothing."""
    assert main(["generate", "--for", library, *models, "-o", "out"]) == 1
    assert not Path("out").exists()
    return capsys.readouterr().out


def cases(faults):
    """The *faults*, each with a library; all libraries ask for the same rules."""
    return [pytest.param(each, LIBRARIES[at % 3], id=each) for at, each in enumerate(faults)]


@pytest.fixture
def here(tmp_path, monkeypatch, rules_cache):
    monkeypatch.chdir(tmp_path)


@pytest.mark.parametrize(("fault", "library"), cases(WRONG))
def test_faults_that_shapes_let_pass(here, capsys, fault, library):
    code, nodes = WRONG[fault]
    Path("robot.jsonld").write_text(model(nodes))
    assert code in stopped(capsys, library, "robot.jsonld")


@pytest.mark.parametrize(("fault", "library"), cases(FAULTS))
def test_faults_of_an_algorithm(here, capsys, fault, library):
    right, wrong, code = FAULTS[fault]
    texts = {path.name: path.read_text() for path in SAMPLE.glob("*.jsonld")}
    assert sum(text.count(right) for text in texts.values()) == 1
    for name, text in texts.items():
        Path(name).write_text(text.replace(right, wrong))
    assert code in stopped(capsys, library, *sorted(texts))
