"""One mistake is one finding: what follows from it is counted there, and nothing else is hidden."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from kinlint import lint
from kinlint.catalogue import rulebook
from kinlint.configuration.settings import Settings
from kinlint.report import Report
from kinlint.text import SourceText

MODEL = Path(__file__).parents[1] / "samples" / "algorithms"
NAMES = "https://w3id.org/kinlint/samples/algorithms#"
BASE = "https://comp-rob2b.github.io/metamodels"
Edit = tuple[str, str, str]
"""A file, a text in it, and what stands there instead."""


@pytest.fixture(scope="module")
def lint_edited() -> Callable[..., Report]:
    book = rulebook.load()

    def run(*edits: Edit, first: bool = True, without: str = "") -> Report:
        texts = {path.stem: path.read_text("utf-8") for path in sorted(MODEL.glob("*.jsonld"))}
        texts.pop(without, None)
        for name, old, new in edits:
            assert old in texts[name]
            texts[name] = texts[name].replace(old, new, 1 if first else -1)
        sources = [SourceText(f"{name}.jsonld", text) for name, text in texts.items()]
        return lint.run(sources, (), Settings(), book)

    return run


def _inline(definition: str) -> Edit:
    """An edit that adds *definition* to the context of the coordinates."""
    prefix = f'{{ "arm": "{NAMES}"'
    return ("coordinates", prefix, f"{prefix}, {definition}")


CASCADES: dict[str, tuple[Edit, str]] = {
    "prefix without a definition": (("skeleton", '"arm": "', '"am": "'), "LD015"),
    "prefix without a definition, of what relations ask for": (
        ("coordinates", '"arm": "', '"am": "'),
        "LD015",
    ),
    "context that cannot be read": (
        ("coordinates", "geometry/coordinates.json", "geometry/numbers.json"),
        "LD014",
    ),
    "context that cannot be read, of entities": (
        ("skeleton", "structural-entities.json", "skeletons.json"),
        "LD014",
    ),
    "misspelt type whose keys are dropped": (
        ("coordinates", '"PoseCoordinate", "VectorXYZ"', '"PoseCoordinate", "VectorXY"'),
        "LD003",
    ),
    "misspelt type of a relation": (("relations", '"@type": "Pose"', '"@type": "Poze"'), "LD003"),
    "misspelt type of a joint": (("chain", '"RevoluteJoint"', '"RevolutJoint"'), "LD003"),
    "misspelt reference": (("relations", '"of": "arm:elbow-seat"', '"of": "arm:elbo"'), "LD006"),
    "misspelt frame of coordinates": (
        ("coordinates", '"as-seen-by": "arm:upper-arm-root"', '"as-seen-by": "arm:uper-arm"'),
        "LD006",
    ),
    "misspelt unit key": (("coordinates", '"unit": "M"', '"unti": "M"'), "LD001"),
    "prefix without its #": (("skeleton", f'"{NAMES}"', f'"{NAMES[:-1]}"'), "LD015"),
    "prefix with / for #": (("skeleton", f'"{NAMES}"', f'"{NAMES[:-1]}/"'), "LD031"),
    "prefix of another robot": (("coordinates", f'"{NAMES}"', f'"{NAMES[:-2]}#"'), "LD031"),
    "identifier of another frame": (
        ("skeleton", '"@id": "arm:elbow-seat",', '"@id": "arm:upper-arm-root",'),
        "ID004",
    ),
    "identifier misspelt where it is defined": (
        ("skeleton", '"@id": "arm:elbow-seat-origin"', '"@id": "arm:elbow-seat-orign"'),
        "LD040",
    ),
    "identifier of another joint": (
        ("chain", '"@id": "arm:elbow",', '"@id": "arm:shoulder",'),
        "ID004",
    ),
    "identifier of another relation": (
        ("relations", '"@id": "arm:elbow-offset",', '"@id": "arm:shoulder-offset",'),
        "ID004",
    ),
    "graph without its @": (("skeleton", '"@graph"', '"graph"'), "LD001"),
    "context that is not loaded": (
        ("coordinates", f'"{BASE}/geometry/coordinates.json",', ""),
        "LD030",
    ),
    "context of entities that is not loaded": (
        ("skeleton", f'"{BASE}/geometry/structural-entities.json",', ""),
        "LD030",
    ),
    "context of one key that is not loaded": (("coordinates", f'"{BASE}/qudt.json",', ""), "LD030"),
    "term without its coercion": (_inline('"unit": "http://qudt.org/schema/qudt/unit"'), "LD032"),
    "term with relative values": (
        _inline('"unit": {"@id": "http://qudt.org/schema/qudt/unit", "@type": "@id"}'),
        "LD032",
    ),
    "prefix called as a term": (_inline('"unit": "http://qudt.org/vocab/unit/"'), "LD016"),
    "namespace of units": (
        _inline(
            '"unit": {"@id": "http://qudt.org/schema/qudt/unit", "@type": "@vocab", '
            '"@context": {"@vocab": "http://qudt.org/vocab/units/"}}'
        ),
        "LD009",
    ),
}


SLIPS: dict[str, Edit] = {
    "letter": ("coordinates", "geometry/coordinates.json", "geometry/coordinate.json"),
    "two letters": ("skeleton", "structural-entities.json", "strctural-entites.json"),
    "scheme": ("chain", "https://comp-rob2b", "http://comp-rob2b"),
    "end": ("chain", "structural-entities.json", "structural-entities"),
}
"""Contexts that cannot be read, but are known by nearly the same name."""


@pytest.mark.slow
@pytest.mark.parametrize("slip", SLIPS)
def test_a_context_is_read_as_the_one_that_was_meant(
    slip: str, lint_edited: Callable[..., Report]
) -> None:
    """Nothing follows then, and the rest of the file is judged."""
    name, old, new = SLIPS[slip]
    (found,) = lint_edited((name, old, new)).findings
    assert (found.rule.code, found.consequences) == ("LD014", ())
    assert old.removeprefix("https://") in found.message


@pytest.mark.slow
@pytest.mark.parametrize("name", CASCADES)
def test_one_mistake_is_one_finding(name: str, lint_edited: Callable[..., Report]) -> None:
    edit, code = CASCADES[name]
    report = lint_edited(edit)
    assert [each.rule.code for each in report.findings] == [code]
    (cause,) = report.findings
    assert cause.consequences
    assert f"{len(cause.consequences)} other finding" in cause.message


@pytest.mark.slow
def test_what_an_unread_file_describes_follows_from_it(lint_edited: Callable[..., Report]) -> None:
    """A comma is missing: the error counts the references; a slip elsewhere is a finding still."""
    broken = ("skeleton", '"Vector", "BoundVector"', '"Vector" "BoundVector"')
    slip = ("chain", '"arm:shoulder", "arm:elbow"', '"arm:shoulder", "arm:elbw"')
    report = lint_edited(broken, slip)
    assert [each.rule.code for each in report.findings] == ["LD006"]
    (error,) = report.errors
    assert error.consequences
    assert f"{len(error.consequences)} other findings follow from this" in error.cause


@pytest.mark.slow
@pytest.mark.parametrize("gone", ["skeleton", "relations"])
def test_what_a_missing_file_describes_follows_from_its_absence(
    gone: str, lint_edited: Callable[..., Report]
) -> None:
    """Nothing follows from a name that is a slip of the pen for one that is described."""
    slip = ("chain", '"arm:shoulder", "arm:elbow"', '"arm:shoulder", "arm:elbw"')
    report = lint_edited(slip, without=gone)
    first, other = sorted(report.findings, key=lambda each: each.rule.code)
    assert (first.rule.code, other.rule.code) == ("CMP032", "LD006")
    assert {each.rule.code for each in first.consequences} >= {"LD006"}
    assert "'arm:elbw'" in other.message


@pytest.mark.slow
def test_of_two_causes_the_first_has_the_consequences(lint_edited: Callable[..., Report]) -> None:
    """Whatever order the store answers in, which differs between processes."""
    types = '"PoseCoordinate", "VectorXYZ"'
    report = lint_edited(("coordinates", types, '"PoseCoordinat", "VectorXY"'))
    told = [each for each in report.findings if each.rule.code == "LD003"]
    first, second = sorted(told, key=lambda each: each.sort_key)
    assert first.consequences
    assert not second.consequences


INDEPENDENT: dict[str, tuple[Edit, str]] = {
    "zero axis": (("coordinates", "[ 1.0, 0.0, 0.0 ]", "[ 0.0, 0.0, 0.0 ]"), "FRM004"),
    "reference to nothing": (
        ("chain", '"arm:shoulder", "arm:elbow"', '"arm:shoulder", "arm:elbw"'),
        "LD006",
    ),
    "key of nobody": (
        ("relations", '"@type": "Pose",', '"@type": "Pose", "colour": "red",'),
        "LD001",
    ),
    "unit of another kind": (("coordinates", '"unit": "M"', '"unit": "KiloGM"'), "UNI002"),
}


@pytest.mark.slow
@pytest.mark.parametrize("defect", INDEPENDENT)
@pytest.mark.parametrize("name", CASCADES)
def test_other_mistakes_are_not_hidden(
    name: str, defect: str, lint_edited: Callable[..., Report]
) -> None:
    cause, other = CASCADES[name], INDEPENDENT[defect]
    if cause[0][0] == other[0][0]:
        pytest.skip("in one file one may stand in the way of reading the other")
    report = lint_edited(cause[0], other[0])
    codes = [each.rule.code for each in report.findings]
    assert sorted(codes) == sorted([cause[1], other[1]])


def _arm(side: str, y: float) -> str:
    """Three links of an arm, with the joints between them."""
    shape = '<collision><geometry><box size="0.1 0.1 0.1"/></geometry></collision>'
    links = "".join(f'<link name="{side}_{part}">{shape}</link>' for part in ("upper", "lower"))
    limit = '<limit lower="-1" upper="1" effort="9" velocity="2"/>'
    joints = "".join(
        f'<joint name="{side}_{name}" type="revolute"><parent link="{parent}"/>'
        f'<child link="{side}_{child}"/><origin xyz="0 {y} {z}"/><axis xyz="0 1 0"/>{limit}</joint>'
        for name, parent, child, z in (
            ("shoulder", "base", "upper", 0.5),
            ("elbow", f"{side}_upper", "lower", -0.3),
        )
    )
    return links + joints


ARMS = f'<robot name="arms"><link name="base"/>{_arm("left", 0.2)}{_arm("right", -0.2)}</robot>'
GROUPS = """<robot name="arms">
<group name="left_arm"><chain base_link="base" tip_link="left_lower"/></group>
<group name="right_arm"><chain base_link="base" tip_link="right_lower"/></group>
<group_state name="home" group="left_arm"><joint name="left_shoulder" value="0"/>
<joint name="left_elbow" value="0"/></group_state>
<group_state name="rest" group="right_arm"><joint name="right_shoulder" value="0"/>
<joint name="right_elbow" value="0"/></group_state>
<disable_collisions link1="left_upper" link2="left_lower" reason="Adjacent"/>
<disable_collisions link1="right_upper" link2="right_lower" reason="Adjacent"/>
</robot>"""


@pytest.mark.slow
@pytest.mark.parametrize(
    ("old", "new", "code"),
    [
        ('<link name="left_lower"', '<link name="left_lowr"', "TOP001"),
        ('<child link="right_lower"/>', '<child link="left_lower"/>', "TOP004"),
        ('<parent link="left_upper"/>', '<parent link="right_upper"/>', "TOP062"),
        ('<parent link="base"/><child link="left_', '<parent link="left_lower"/><child link="left_',
         "TOP003"),
        ('tip_link="right_lower"', 'tip_link="left_lower"', "CMP095"),
    ],
)  # fmt: skip
def test_one_mistake_in_a_robot_is_one_finding(old: str, new: str, code: str) -> None:
    """What its planning groups, states and collision pairs lack follows from it."""
    texts = {"arms.urdf": ARMS, "arms.srdf": GROUPS}
    sources = [SourceText(name, text.replace(old, new, 1)) for name, text in texts.items()]
    found = [
        each
        for each in lint.run(sources, (), Settings(), rulebook.load()).findings
        if each.severity.label != "info"
    ]

    assert [each.rule.code for each in found] == [code]
    assert found[0].consequences


@pytest.mark.slow
def test_a_robot_without_mistakes_has_no_findings() -> None:
    sources = [SourceText("arms.urdf", ARMS), SourceText("arms.srdf", GROUPS)]
    assert [
        each
        for each in lint.run(sources, (), Settings(), rulebook.load()).findings
        if each.severity.label != "info"
    ] == []
