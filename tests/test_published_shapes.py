"""The authors' published shapes have errors; kinlint does right what each of them does wrong.

The numbers are those by which the errors are counted, S1 to S15.
"""

from __future__ import annotations

from pathlib import Path

import pyoxigraph as ox
import pytest
from support.linting import findings, told

from kinlint import resources

SAMPLES = Path(__file__).parents[1] / "samples"
CONTEXT = """
    "@context": ["https://w3id.org/kinlint/composable.json",
        {"ex": "https://example.org/arm#", "kind": "http://qudt.org/vocab/quantitykind/"}]
"""


def found(*nodes: str, rule: str) -> list[str]:
    """The messages of *rule* about a model of *nodes*, whose frames nobody describes."""
    text = f'{{ {CONTEXT}, "@graph": [ {", ".join(nodes)} ] }}'
    return [each.message for each in told(text, "arm.jsonld") if each.rule.code == rule]


def cosines(x: str, y: str, z: str) -> str:
    return f"""{{ "@id": "ex:tool-coord", "unit": "UNITLESS", "as-seen-by": "ex:base",
        "@type": ["OrientationReference", "OrientationCoordinate", "DirectionCosineXYZ"],
        "of-orientation": "ex:tool-orientation", "direction-cosine-x": {x},
        "direction-cosine-y": {y}, "direction-cosine-z": {z} }}"""


def pose(name: str, of: str, with_respect_to: str, as_seen_by: str) -> tuple[str, str]:
    """A pose, and the coordinates that point to it."""
    return (
        f"""{{ "@id": "ex:{name}", "@type": "Pose", "of": "ex:{of}",
            "with-respect-to": "ex:{with_respect_to}" }}""",
        f"""{{ "@id": "ex:{name}-coord", "@type": ["PoseReference", "PoseCoordinate", "VectorXYZ"],
            "of-pose": "ex:{name}", "as-seen-by": "ex:{as_seen_by}", "unit": "M",
            "x": 1.0, "y": 0.0, "z": 0.0 }}""",
    )


COMPOSITION = """{ "@id": "ex:compose", "@type": "ComposePose", "in1": "ex:lower-coord",
    "in2": "ex:upper-coord", "composite": "ex:whole-coord" }"""


def composed(upper: str = "elbow", whole: str = "hand") -> list[str]:
    """base to elbow, composed with *upper* to hand, called base to *whole*."""
    return [
        COMPOSITION,
        *pose("lower", "elbow", "base", "base"),
        *pose("upper", "hand", upper, upper),
        *pose("whole", whole, "base", "base"),
    ]


def wrench(name: str, frame: str, point: str = "tip") -> str:
    return f"""{{ "@id": "ex:{name}", "@type": ["Wrench", "WrenchReference", "WrenchCoordinate"],
        "acts-on": "ex:hand", "reference-point": "ex:{point}", "as-seen-by": "ex:{frame}",
        "force": [1.0, 0.0, 0.0], "torque": [0.0, 0.0, 0.0], "unit": ["N", "N-M"] }}"""


ADDITION = """{ "@id": "ex:add", "@type": "AddWrench", "in1": "ex:a", "in2": "ex:b",
    "out": "ex:sum" }"""


def constraint(kinds: str, **properties: str) -> str:
    said = "".join(f', "{key.replace("_", "-")}": {value}' for key, value in properties.items())
    return f'{{ "@id": "ex:gentle", "@type": ["Constraint", {kinds}], "quantity": "ex:q"{said} }}'


def test_s1_a_rotation_by_nothing_is_a_rotation():
    """Rows are lists of three numbers, however often a number stands in them."""
    rows = ("[1.0, 0.0, 0.0]", "[0.0, 1.0, 0.0]", "[0.0, 0.0, 1.0]")

    assert found(cosines(*rows), rule="FRM004") == []
    assert found(cosines("[1.0, 0.0]", *rows[1:]), rule="FRM017")


def test_s2_a_velocity_is_a_list_of_three_numbers():
    """Whole numbers and repeated ones are as good as others."""
    velocity = """{{ "@id": "ex:spin", "unit": "RAD-PER-SEC", "as-seen-by": "ex:base",
        "@type": ["VelocityReference", "VelocityTwistCoordinate", "AngularVelocityVectorXYZ"],
        "of-velocity": "ex:turn", "angular-velocity": {} }}"""

    assert found(velocity.format("[0, 0, 1.5]"), rule="FRM017") == []
    assert found(velocity.format("[0, 1.5]"), rule="FRM017")


def test_s3_a_shear_is_no_rotation():
    """Its determinant is one, but its axes are not orthogonal."""
    assert found(cosines("[1.0, 1.0, 0.0]", "[0.0, 1.0, 0.0]", "[0.0, 0.0, 1.0]"), rule="FRM004")


def test_s4_the_frame_of_coordinates_is_compared_with_the_relation_they_point_to():
    """Not only where coordinates and relation are one node."""
    assert found(*pose("whole", "hand", "base", "world"), rule="FRM019")
    assert found(*pose("whole", "hand", "base", "base"), rule="FRM019") == []


def test_s5_the_result_of_a_composition_relates_the_outer_frames():
    """What is composed to a pose of the elbow cannot be called the pose of the hand."""
    assert found(*composed(whole="elbow"), rule="ALG002")
    assert found(*composed(), rule="ALG002") == []


def test_s6_operands_are_judged_by_the_relations_they_point_to():
    """The poses of a composition meet in one frame, although their coordinates do not say so."""
    assert found(*composed(upper="shoulder"), rule="ALG002")


@pytest.mark.parametrize("odd", ["a", "b", "sum"])
def test_s7_one_odd_operand_of_a_sum_is_enough(odd):
    """Whichever it is, it is seen from another frame than the other two."""
    operands = [wrench(name, "base" if name != odd else "hand") for name in ("a", "b", "sum")]

    assert found(ADDITION, *operands, rule="ALG006")
    assert found(ADDITION, *[wrench(n, "base") for n in ("a", "b", "sum")], rule="ALG006") == []


def test_s8_a_constraint_has_one_lower_threshold():
    """And one upper: neither two, nor none."""
    bounds = {"lower_threshold": '"ex:low"', "upper_threshold": '"ex:high"'}
    two = constraint('"BilateralConstraint"', **bounds | {"lower_threshold": '["ex:a", "ex:b"]'})
    none = constraint('"BilateralConstraint"', upper_threshold='"ex:high"')
    right = constraint('"BilateralConstraint"', **bounds)

    assert found(two, rule="ID004")
    assert found(none, rule="LD011")
    assert found(right, rule="ID004") == found(right, rule="LD011") == []


def test_s9_evaluators_are_constraint_evaluators():
    """They are called as the context calls them, and their kind matters."""
    handler = """{ "@id": "ex:handler", "@type": "ConstraintHandler", "motion": "ex:reach",
        "evaluators": "ex:e" }"""
    gain = '"proportional-gain": 1.0, "integral-gain": 0.1, "derivative-gain": 0.2'
    controller = f"""{{ "@id": "ex:e", "@type": ["Controller", "ProportionalIntegralDerivative"],
        "error-signal": "ex:error", "control-signal": "ex:force", {gain} }}"""
    evaluator = '{ "@id": "ex:e", "@type": "ConstraintEvaluator", "constraint": "ex:gentle" }'

    assert found(handler, controller, rule="LD011")
    assert found(handler, evaluator, rule="LD011") == []


def test_s10_a_damping_controller_needs_what_terms_exist_for():
    """There is none for a commanded force."""
    damping = """{ "@id": "ex:damp", "@type": ["Controller", "DampingController"],
        "error-signal": "ex:error", "control-signal": "ex:force",
        "maximum-velocity": "ex:v", "measured-velocity": "ex:w", "maximum-force": "ex:f" }"""

    assert found(damping, rule="LD011") == []
    assert found(damping.replace('"maximum-force": "ex:f"', '"ex:a": 1'), rule="LD011")


def test_s11_events_and_flags_may_be_of_any_metamodel():
    """The one that would define them is not published."""
    monitors = [
        """{ "@id": "ex:edge", "@type": ["Monitor", "EdgeTriggeredMonitor"],
            "error": "ex:error", "event": "ex:done", "event-queue": "ex:queue" }""",
        """{ "@id": "ex:level", "@type": ["Monitor", "LevelTriggeredMonitor"],
            "error": "ex:error", "flag": "ex:busy" }""",
        '{ "@id": "ex:done", "@type": "https://example.org/events#Event" }',
    ]

    assert found(*monitors, rule="LD011") == []
    assert found(monitors[1].replace("flag", "ex:flag"), rule="LD011")


def test_s12_priorities_are_said_with_the_terms_that_exist():
    """A hierarchy of levels, each with its drivers: nothing is lost and nothing refused."""
    nodes = [
        """{ "@id": "ex:drivers", "@type": "MotionDrivers", "cartesian-force": ["ex:push"],
            "prioritization-hierarchy": ["ex:first"] }""",
        '{ "@id": "ex:first", "@type": "PrioritizationLevel", "motion-drivers": ["ex:push"] }',
        """{ "@id": "ex:push", "@type": "CartesianForceSpecification", "force": "ex:wrench",
            "attached-to": "ex:hand" }""",
    ]

    assert found(*nodes, rule="LD011") == found(*nodes, rule="LD001") == []
    assert found(nodes[0].replace("push", "first"), nodes[1], rule="LD011")


def test_s13_a_kind_of_quantity_is_named_by_its_property():
    """As a class it is understood, but on a relation it is told apart from the relation."""
    gentle = constraint('"EqualityConstraint", "ForceConstraint"', reference_value='"ex:q"')
    typed = '{ "@id": "ex:q", "@type": ["Quantity", "kind:Torque"], "unit": "N-M" }'
    named = '{ "@id": "ex:q", "@type": "Quantity", "quantity-kind": "Torque", "unit": "N-M" }'
    force = '{ "@id": "ex:q", "@type": "Quantity", "quantity-kind": "Force", "unit": "N" }'
    relation = """{ "@id": "ex:offset", "@type": ["Position", "kind:Length"],
        "of": "ex:a", "with-respect-to": "ex:b" }"""

    assert len(found(gentle, typed, rule="LD011")) == len(found(gentle, named, rule="LD011")) == 2
    assert found(gentle, force, rule="LD011") == []
    assert found(relation, rule="UNI013")


@pytest.mark.parametrize(
    "file", sorted((SAMPLES / "one-dof").glob("*.jsonld")), ids=lambda f: f.stem
)
def test_s14_one_file_of_a_composed_model_is_no_noise(file):
    """What stands in the other files is not missed in this one."""
    found = findings(file.read_bytes(), str(file), partial=True)

    assert [f"{f.rule.code}: {f.message}" for f in found] == []


def test_s15_files_can_be_joined_and_lead_to_no_network():
    """Each ends with a line feed, and imports nothing but what lies beside it."""
    for folder in (resources.data("shapes"), resources.data("rules")):
        for file in sorted(folder.rglob("*.ttl")):
            assert file.read_bytes().endswith(b"\n"), file
            base = file.absolute().as_uri()
            for quad in ox.parse(path=file, format=ox.RdfFormat.TURTLE, base_iri=base):
                if quad.predicate.value.endswith("owl#imports"):
                    assert quad.object.value.startswith("file:"), file
