"""The symptoms of the anti-patterns that rules are tagged with.

Numbers follow the anti-patterns. Symptoms that come with a format, and that no author could avoid,
are shown by `--profile` and found by no rule.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from kinlint.format_profile import profile
from kinlint.formats.records import GRAPHS, LIFTED
from kinlint.rule import Rule

SYMPTOMS = {
    "AP1.1": "an entity has no identifier",
    "AP1.2": "an identifier is relative, malformed, or used for two things",
    "AP1.3": "a reference is dangling",
    "AP1.4": "a relation has no identity apart from its coordinates",
    "AP1.5": "others can add only where the format lets them",
    "AP2.1": "one type is stated where the metamodel composes several",
    "AP2.2": "a type hides in a plain property",
    "AP2.3": "types are disjoint, or not defined anywhere",
    "AP3.1": "one root closes the model",
    "AP3.2": "a kinematic chain is not connected",
    "AP3.3": "damping is linear",
    "AP3.4": "friction is Coulomb friction",
    "AP3.5": "a safety controller is linear",
    "AP3.6": "coordinates have a representation outside of all metamodels",
    "AP3.7": "an inertia is six named entries",
    "AP3.8": "numbers show errors of manual conversion",
    "AP3.9": "the two levels of position limits contradict each other",
    "AP3.10": "a body is drawn and does not collide, or collides as it is drawn",
    "AP3.11": "several measurements of one quantity disagree",
    "AP3.12": "several representations of one relation disagree",
    "AP3.13": "kinds come from a closed list",
    "AP4.1": "one node belongs to several domains",
    "AP4.2": "a joint contains limits, actuation or control",
    "AP4.3": "a robot description contains elements of one simulator",
    "AP4.4": "a domain is nested in another, and not replaceable by itself",
    "AP4.5": "a robot description contains its environment",
    "AP4.6": "a model depends on one release of its metamodels",
    "AP5.1": "a type has no metamodel to check it",
    "AP5.2": "shapes and contexts contradict each other",
    "AP5.3": "an addition is silently ignored",
    "AP5.4": "units and quantity kinds are missing, unknown or contradictory",
    "AP5.5": "the convention of an angle is not stated",
    "AP5.6": "a reference, a number or a list is only a string",
    "AP5.7": "a metamodel cannot be read",
    "AP6.1": "a force limit is tied to the joint, not to what drives it",
    "AP6.2": "a velocity limit is tied to the joint, not to what drives it",
    "AP6.3": "a joint contains its controller",
    "AP6.4": "numbers imply a relation that is not stated",
    "AP6.5": "where a joint attaches is left open",
    "AP6.6": "axis, handedness or polarity is left open",
    "AP6.7": "the zero configuration is left open",
    "AP6.8": "units and the upward axis of a whole document are left open",
    "AP6.9": "two joint frames on one link are indistinguishable",
    "AP6.10": "a number is left to a default that does not exist",
    "AP6.11": "the sign of gravity is left open",
    "AP6.12": "point or frame of an inertia is left open",
}
_DESCRIBING_FIRST = sorted(LIFTED, key=lambda each: each.speaks_of is not None)
FORMATS = {each.name: each.title for each in (GRAPHS[0], *_DESCRIBING_FIRST)}
"""The titles of the table's columns: one format for all composable files, and all lifted ones."""


def symptom_table(rules: Iterable[Rule]) -> Iterator[str]:
    """Yield the rows of a Markdown table: which of *rules* find each symptom in each format.

    *inherent* stands where no author of that format can avoid the symptom.
    """
    ordered = tuple(rules)
    inherent = {form: {each.number for each in profile(form).symptoms} for form in FORMATS}
    yield f"| Symptom | Description | {' | '.join(FORMATS.values())} |"
    yield f"|---|---|{'---|' * len(FORMATS)}"
    for symptom, title in SYMPTOMS.items():
        found = [rule for rule in ordered if symptom in rule.symptoms]
        cells = []
        for form in FORMATS:
            codes = [rule.code for rule in found if form in rule.formats]
            cells.append(", ".join([*codes, *["*inherent*"] * (symptom in inherent[form])]))
        yield f"| {symptom} | {title} | {' | '.join(cells)} |"
