"""Lifting of files in several formats: each is lifted by the queries for its own format only."""

from __future__ import annotations

import pytest
from support.linting import source

from kinlint.engine.lifting import lift
from kinlint.engine.store import Store
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import read

TEXTS = {
    "arm.urdf": (
        '<robot name="u"><link name="a"/><link name="b"/><joint name="j" type="continuous">'
        '<parent link="a"/><child link="b"/></joint></robot>'
    ),
    "arm.sdf": (
        '<sdf version="1.9"><model name="s"><link name="a"/><link name="b"/><joint name="j"'
        ' type="revolute"><parent>a</parent><child>b</child><axis><xyz>0 0 1</xyz></axis></joint>'
        "</model></sdf>"
    ),
    "arm.xml": (
        '<mujoco><worldbody><body name="b"><joint name="j" axis="0 1 0"/><geom size="0.1"/></body>'
        "</worldbody></mujoco>"
    ),
    "arm.usda": (
        '#usda 1.0\ndef Xform "arm" (prepend apiSchemas = ["PhysicsRigidBodyAPI",'
        ' "PhysicsMassAPI"])\n{\n    float physics:mass = 2\n}\n'
    ),
}


@pytest.fixture(scope="module")
def documents():
    """The documents, by name."""
    options = ReadOptions()
    return {name: read(source(text, name), options) for name, text in TEXTS.items()}


def lifted(documents):
    store = Store()
    store.load(documents)
    lift(store)
    return {each for each in store.lifted() if "_:" not in "".join(each)}


@pytest.mark.parametrize("name", TEXTS)
def test_others_change_nothing(documents, name):
    assert lifted(documents.values()) >= lifted([documents[name]])


def test_nothing_is_lifted_of_several_that_is_not_of_one(documents):
    apart = set().union(*(lifted([each]) for each in documents.values()))
    assert lifted(documents.values()) == apart
