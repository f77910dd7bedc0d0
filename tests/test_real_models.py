"""What is found in the published models is what their defects are, at their lines."""

from functools import cache
from pathlib import Path

import pytest
from data import locate_data
from real_models import MODELS, findings, page
from support.linting import lint

from kinlint.rule import Severity

pytestmark = [pytest.mark.corpus, pytest.mark.xdist_group("published models")]

KEPT = Path(__file__).with_name("real_models.md")
KINOVA = "kinova/gen3/7dof"

DEFECTS = {
    "tutorial": {
        "a reflection instead of a rotation": ("cartesian-coordinates.json", "FRM004", [17]),
        "a context that is not loaded": ("cartesian-coordinates.json", "LD030", [3]),
        "types that no context maps": ("cartesian-coordinates.json", "LD003", [13, 26]),
        "a reference frame that is dropped": ("cartesian-coordinates.json", "LD001", [28]),
        "inertia without point and frame": ("dynamics.json", "LD001", [16, 17]),
        "an operator without operands": ("fpk-algorithm.json", "LD001", [22, 23, 24]),
        "slots that stay empty": ("fpk-algorithm.json", "ALG001", [20]),
        "an operand that is a relation": ("fpk-algorithm.json", "ALG009", [17]),
        "a joint without a value": ("joint-coordinates.json", "LD001", [17]),
        "a graph with the name of another": ("joint-coordinates.json", "ID001", [9]),
        "a frame without geometry": ("skeleton.json", "FRM014", [49]),
        "a pose without coordinates": ("spatial-relations.json", "FRM028", [33]),
        "no polarity": ("chain.json", "FRM013", [11]),
        "no zero configuration": ("chain.json", "FRM026", [11]),
    },
    "Kinova": {
        "basis vectors of vectors": (f"{KINOVA}/robot.geom.json", "LD019", [191, 226]),
        "inertias of no body": (f"{KINOVA}/robot.dyn.json", "LD001", list(range(15, 177, 23))),
        "values that are dropped": (f"{KINOVA}/robot.kin-chain.json", "LD001", [163, 386]),
        "polarities that are dropped": (
            f"{KINOVA}/robot.kin-chain.json",
            "LD001",
            list(range(21, 70, 8)),
        ),
        "joint types that are unmapped": (
            f"{KINOVA}/robot.kin-chain.json",
            "LD003",
            [*range(17, 66, 8), 391],
        ),
        "unmapped velocities": (f"{KINOVA}/mounting-upright.geom.json", "LD003", [54, 77]),
        "and what they relate": (
            f"{KINOVA}/mounting-upright.geom.json",
            "LD001",
            [55, 78],
        ),
        "a graph with the name of a chain": (f"{KINOVA}/robot.kin-chain.json", "ID001", [13]),
        "a graph with the name of another": (f"{KINOVA}/robot.geom.json", "ID001", [11]),
        "vectors on no body": (
            f"{KINOVA}/robot.geom.json",
            "TOP012",
            list(range(659, 737, 11)),
        ),
        "frames without x and y": (f"{KINOVA}/robot.geom.json", "FRM035", [36]),
        "the world's as well": (f"{KINOVA}/mounting-upright.geom.json", "FRM035", [18]),
        "a frame with the type of a vector": (f"{KINOVA}/robot.geom.json", "LD012", [19]),
        "so the world's": (f"{KINOVA}/mounting-upright.geom.json", "LD012", [19]),
        "relations without coordinates": (
            f"{KINOVA}/robot.geom.json",
            "FRM028",
            [line for start in range(292, 605, 52) for line in (start, start + 7)],
        ),
        "offsets without coordinates": (
            f"{KINOVA}/robot.kin-chain.json",
            "FRM028",
            list(range(73, 146, 12)),
        ),
    },
    "sc1": {
        "a context of units that is not loaded": ("00-common/01-world-model.json", "LD030", [4]),
        "gravity without a unit": ("00-common/01-world-model.json", "LD001", [18, 27]),
        "a twist without kind and unit": ("00-common/01-world-model.json", "LD001", [40, 43]),
        "gravity upwards": ("00-common/01-world-model.json", "FRM030", [15, 24]),
        "a context of operators that is not loaded": ("01-right-arm/00-misc.json", "LD030", [4]),
        "nor on the left": ("02-left-arm/00-misc.json", "LD030", [4]),
        "an operator that vanishes": ("01-right-arm/00-misc.json", "LD003", [78]),
        "and its arguments": ("01-right-arm/00-misc.json", "LD001", [79]),
        "so on the left": ("02-left-arm/00-misc.json", "LD001", [79]),
        "a chain that is none": ("01-right-arm/00-misc.json", "LD003", [54]),
        "units of another kind": (
            "01-right-arm/01-world-model.json",
            "UNI002",
            [143, 207, 235, 263],
        ),
        "directions that are unmapped": (
            "03-scenarios/01-world-model.json",
            "LD003",
            [42, 49, 56, 133, 204],
        ),
        "constraints that are unmapped": ("03-scenarios/03-constraints.json", "LD003", [13, 29]),
        "a context that is not loaded": ("04-sc1/01-world-model.json", "LD030", [4]),
        "vectors that are unmapped": ("04-sc1/01-world-model.json", "LD003", [42, 79, 90]),
        "chains dropped from solvers": ("04-sc1/07-scenario.json", "LD001", [66, 120]),
        "a model imported twice": ("sc1.json", "CMP015", [37, 38]),
        "a configuration that nobody defines": ("00-common/00-misc.json", "LD006", [33]),
        "another": ("04-sc1/07-scenario.json", "LD006", [14]),
    },
}


def included(finding):
    """Yield *finding*, those that it groups, and all that follow from them."""
    yield finding
    for each in (*finding.members, *finding.consequences):
        if each is not finding:
            yield from included(each)


@cache
def found(model):
    return frozenset(
        (each.location.source.name, each.rule.code, each.location.start.line)
        for finding in findings(model)
        for each in included(finding)
    )


@pytest.mark.parametrize(
    ("model", "defect"), [(model, defect) for model in DEFECTS for defect in DEFECTS[model]]
)
def test_a_known_defect_is_found_at_its_lines(model, defect):
    """Whoever published these models did not see it."""
    locate_data()
    file, code, lines = DEFECTS[model][defect]

    assert {(file, code, line) for line in lines} <= found(model)


def test_the_page_of_findings_is_fresh():
    """If not: `python tests/real_models.py > tests/real_models.md`, and look at what changed."""
    locate_data()

    assert KEPT.read_text("utf-8").splitlines() == list(page())


@pytest.mark.parametrize("model", MODELS)
def test_whatever_is_an_error_is_a_known_defect(model):
    """No rule calls something an error that nobody has looked at."""
    locate_data()
    known = {(file, code) for defects in DEFECTS.values() for file, code, _ in defects.values()} | {
        ("00-common/00-misc.json", "ALG011"),
        ("02-left-arm/00-misc.json", "LD003"),
        ("02-left-arm/01-world-model.json", "UNI002"),
        ("04-sc1/01-world-model.json", "UNI002"),
        ("05-sc2/07-scenario.json", "LD001"),
        ("05-sc2/07-scenario.json", "LD006"),
    }

    errors = [each for each in findings(model) if each.rule.severity is Severity.ERROR]

    assert {(each.location.source.name, each.rule.code) for each in errors} <= known


def test_the_release_decides_what_is_lost():
    """Read with the contexts of its time, the tutorial keeps its operands."""
    files = sorted(locate_data("comp-rob2b", "modelling-tutorial").rglob("*.json"))
    report = lint({file.name: file.read_bytes() for file in files}, contexts="59e0b06")
    codes = {(each.location.source.name, each.rule.code) for each in report.findings}

    assert ("fpk-algorithm.json", "LD001") not in codes
    assert "ALG001" not in {code for _, code in codes}
