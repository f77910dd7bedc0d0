"""Consumers do with a robot that has a feature what the table of consumers says.

Those that pip installs are driven over a file for each feature. They do not go together in one
environment (urdf-usd-converter brings an OpenUSD of its own), so `KINLINT_REFEREES` names another
Python that has them; without it, this one is asked for those that it has.
"""

import json
import os
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest
from targets.consumer_drivers import MODULES
from targets.observed_outcomes import HONOURED, outcome
from targets.simulator_fixtures import MJCF, SDF
from targets.stage_fixtures import USD
from targets.urdf_fixtures import FIXTURES as URDF
from targets.urdf_fixtures import MESHES

from kinlint.targets.consumer_files import consumer_table
from kinlint.targets.version_range import read_version

pytestmark = [pytest.mark.external, pytest.mark.oracle, pytest.mark.xdist_group("consumers")]

PYTHON = os.environ.get("KINLINT_REFEREES", sys.executable)
DRIVERS = Path(__file__).with_name("consumer_drivers.py")
FILES = {
    **{name: ("plain", "urdf", text) for name, text in URDF.items()},
    **{name: ("mjcf", "xml", text) for name, text in MJCF.items()},
    **{name: ("sdf", "sdf", text) for name, text in SDF.items()},
    **{name: ("usd", "usda", text) for name, text in USD.items()},
}
"""By feature, the robot that has none in its format, the suffix, and the file."""
READ = {"mujoco": {"xml"}, "newton": {"xml", "usda"}, "pinocchio": {"xml"}}
READ |= {"drake": {"xml", "sdf"}, "pybullet": {"xml", "sdf"}}
"""Suffixes that consumers read beside URDF, with what pip installs."""
PATIENCE = 300
"""Seconds after which a consumer is not waited for."""
MEASURED = sorted(
    {
        (name, cell.feature)
        for name in MODULES
        for cell in consumer_table().consumers[name].cells
        if cell.measured and cell.feature in FILES
    }
)
UNSEEN = {
    "declared-version",
    "gazebo-extension",
    "ros2-control",
    "safety-controller",
    "transmission",
    "unknown-element",
    "usd-armature-of-physx",
    "usd-breakable-joint",
    "usd-joint-friction-of-physx",
    "usd-joint-velocity-of-physx",
}
"""Features of which nothing shows in a robot that is loaded."""


@cache
def made(consumer, directory):
    """The version of *consumer* and what it made of all files, or why it cannot be asked."""
    module, package = MODULES[consumer]
    known = subprocess.run([PYTHON, "-c", f"import {module}"], capture_output=True, check=False)
    if known.returncode:
        return f"{package} is not installed"
    files = {}
    for name, content in MESHES.items():
        (directory / name).write_bytes(content)
    for name, (_, suffix, text) in FILES.items():
        if suffix in {"urdf", *READ.get(consumer, ())}:
            files[name] = directory / f"{name}.{suffix}"
            files[name].write_text(text, "utf-8")
    done = subprocess.run(
        [PYTHON, DRIVERS, consumer, *files.values()],
        capture_output=True,
        check=True,
        timeout=PATIENCE,
    )
    said = json.loads(done.stdout[done.stdout.index(b'{"version"') :])
    return said["version"], {name: said["files"][str(path)] for name, path in files.items()}


@pytest.fixture(scope="session")
def directory(tmp_path_factory):
    """Where the files are, once for all consumers."""
    return tmp_path_factory.mktemp("robots")


@pytest.mark.parametrize("consumer", sorted(MODULES))
def test_a_plain_robot_is_read_as_written(consumer, directory):
    """What the features are compared with."""
    found = made(consumer, directory)
    if isinstance(found, str):
        pytest.skip(found)
    plain = found[1]["plain"]

    assert plain["links"]["upper"]["shapes"] == 1
    assert plain["joints"]["elbow"]["freedom"] == 1
    assert [round(each, 6) for each in plain["joints"]["elbow"]["limits"]] == [-1, 2]


@pytest.mark.parametrize(("consumer", "feature"), MEASURED)
def test_a_consumer_does_what_its_cell_says(consumer, feature, directory):
    """A version that does otherwise fails with the name of the cell."""
    found = made(consumer, directory)
    if isinstance(found, str):
        pytest.skip(found)
    release, files = found
    cell = consumer_table().cell(consumer, read_version(release), feature)
    assert cell is not None
    told = outcome(feature, files[feature], files[FILES[feature][0]])

    behaviour = cell.behaviour.name
    expected = {"refused": "refused", "crashes": "died", "honoured": HONOURED}.get(
        behaviour, cell.into or "ignored"
    )
    if expected == "ignored":
        agrees = told not in {HONOURED, "refused", "died"}
    else:
        agrees = told == expected
    assert agrees, f"{consumer} {release}, {feature}: {told} where its cell says {expected}"


def test_features_that_nothing_shows_are_few():
    """All other features of the table that have files are measured by what they are about."""
    from targets.observed_outcomes import OUTCOMES  # noqa: PLC0415

    assert FILES.keys() - OUTCOMES.keys() - {"plain", "mjcf", "sdf", "usd"} == UNSEEN
