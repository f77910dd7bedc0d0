"""The samples say what their README promises: good ones are clean, broken ones broken as marked."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import cache
from pathlib import Path

import pyoxigraph as ox
import pytest
from support.linting import book, lint

from kinlint import resources
from kinlint.configuration.settings import Choice, FileSettings
from kinlint.contexts.context_library import RELEASES, Contexts
from kinlint.contexts.declarations import PATH
from kinlint.formats.jsonld.reader import read
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import decode
from kinlint.text import SourceText
from kinlint.vocabulary import KIN, KINLINT, RDFS

SAMPLES = Path(__file__).parents[1] / "samples"
COMPANION = SAMPLES / "broken" / "gantry.urdf"
"""A robot that some broken samples are about, and read together with."""
BROKEN = sorted(
    file
    for file in (SAMPLES / "broken").iterdir()
    if file.suffix not in {"", ".expected"} and file != COMPANION
)
NO_MODELS = {
    "broken": "one fault each",
    "shapes": "a shape of a user's",
    "vendor": "comes with a context and shapes of its own: test_vendor",
}
GOOD = sorted(
    folder.name for folder in SAMPLES.iterdir() if folder.is_dir() and folder.name not in NO_MODELS
)
SUFFIXES = {".dae", ".jsonld", ".py", ".rviz", ".sdf", ".srdf", ".urdf", ".usda", ".yaml"}
"""Suffixes of the files that are read."""
FAULTY = {f"{KIN}LeftHanded": "no frame of a good model is left-handed"}
ALGORITHMS = (
    "kinematic-chain/operators#ForwardPositionKinematics",
    "geometry/spatial-operators#ComposePose",
    "newtonian-rigid-body-dynamics/operators#AccelerationTwistToWrenchWithRigidBodyInertia",
    "newtonian-rigid-body-dynamics/operators#InertialWrench",
    "newtonian-rigid-body-dynamics/operators#TransformWrenchToProximal",
    "newtonian-rigid-body-dynamics/operators#AddWrench",
    "newtonian-rigid-body-dynamics/coordinates#UniformGravitationalFieldCoordinate",
    "task/solver-specification#RecursiveNewtonEulerAlgorithm",
)


def files(name):
    return sorted(path for path in (SAMPLES / name).rglob("*") if path.suffix in SUFFIXES)


def sources(*models):
    return [decode(str(model), model.read_bytes()) for model in models]


@cache
def report(*models):
    return lint(sources(*models))


@cache
def broken(file):
    """What is found in *file*, where the rule that it is named for is made to speak.

    A matter of taste is asked for, a rule for one consumer hears of that, or of those in a comment.
    """
    rule = next((rule for rule in book().rules if rule.name == file.stem), None)
    assert rule, f"no rule is called {file.stem}"
    asked = (Choice(extend_select=(rule.code,)),) if rule.optional else ()
    text = file.read_text()
    named = re.search(r"<!-- target: (.+?) -->", text)
    targets = (*rule.targets, *(named[1].split(",") if named else ()))
    chosen = FileSettings(choices=asked, targets=targets)
    about = [COMPANION] if COMPANION.stem in text else []
    companions = [replace(one, companion=True) for one in sources(*about)]
    return lint([*sources(file), *companions], default=chosen).findings


@cache
def vocabulary_in_use():
    """The IRIs that good samples state something by: types, properties and values."""
    options = ReadOptions(Contexts.bundled(), RELEASES)
    found = set()
    every = (file for name in GOOD for file in files(name))
    for model in (file for file in every if file.suffix == ".jsonld"):
        for _, predicate, value in read(
            SourceText(str(model), model.read_text()), options
        ).statements:
            found |= {predicate.strip("<>"), value.strip("<>")}
    return found


def own_terms():
    """The classes and properties that kinlint's own contexts define."""
    store = ox.Store()
    store.load(resources.data("shapes").joinpath(PATH).read_bytes(), ox.RdfFormat.TURTLE)
    defined = store.quads_for_pattern(None, ox.NamedNode(f"{RDFS}isDefinedBy"), None)
    return {quad.subject.value for quad in defined if quad.object.value.startswith(KINLINT)}


@pytest.mark.parametrize("name", GOOD)
def test_a_good_sample_is_clean(name):
    """Good samples have no finding, read without an error, and rules applied to every file."""
    outcome = report(*files(name))

    assert [f"{finding.rule.code} {finding.message}" for finding in outcome.findings] == []
    assert outcome.errors == ()
    assert outcome.unapplied == ()


def test_the_readme_lists_the_samples_that_there_are():
    """Each folder has a row in the table, each row a folder, and eight or more are models."""
    listed = re.findall(r"^\| `([\w-]+)/`", (SAMPLES / "README.md").read_text(), re.MULTILINE)
    folders = {folder.name for folder in SAMPLES.iterdir() if folder.is_dir()}

    assert sorted(listed) == sorted(folders - {"broken"})
    assert len(GOOD) >= 8


@pytest.mark.slow
def test_each_term_of_kinlint_is_at_work_in_a_good_sample():
    """What kinlint adds to the metamodels can be seen in use, and found right."""
    assert own_terms() - vocabulary_in_use() == set(FAULTY)


@pytest.mark.slow
@pytest.mark.parametrize("term", ALGORITHMS)
def test_a_good_sample_computes_by_it(term):
    """Kinematics and dynamics are modelled by operators, and dynamics by a solver too."""
    assert f"https://comp-rob2b.github.io/metamodels/{term}" in vocabulary_in_use()


@pytest.mark.slow
@pytest.mark.parametrize("file", BROKEN, ids=lambda file: file.name)
def test_a_broken_sample_is_found_broken_where_it_is(file):
    """Its findings are those listed beside it, and one is of the rule that it is named for."""
    found, rules = [], set()
    for finding in broken(file):
        start = finding.location.start
        found.append(f"{start.line}:{start.column} {finding.rule.code}")
        rules.add(finding.rule.name)

    assert found == expected(file).read_text().splitlines()
    assert file.stem in rules


def expected(file):
    """What is listed beside *file*, or beside the first sample of its rule."""
    own = file.with_name(f"{file.name}.expected")
    return own if own.exists() else file.with_suffix(".expected")


def test_a_broken_sample_can_be_taken_in_at_a_glance():
    """Sixty lines are enough for a fault."""
    assert [file.name for file in BROKEN if len(file.read_text().splitlines()) > 60] == []


def test_every_rule_about_models_has_a_broken_sample():
    """A fault that a rule names can be seen in a file of that name."""
    about_models = {rule.name for rule in book().rules if rule.family != "LNT"}

    assert about_models == {file.stem for file in BROKEN}


def test_the_companion_of_the_broken_samples_is_whole():
    """What is found in a file beside it is the fault of that file."""
    assert report(COMPANION).findings == ()
