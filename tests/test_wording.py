"""Messages speak in the words of the file: elements by tag and name, numbers without quotes."""

from __future__ import annotations

import pytest

from kinlint.catalogue import rulebook
from kinlint.configuration.settings import Settings
from kinlint.findings.brief_numbers import brief
from kinlint.lint import run
from kinlint.message_template import counted, filled
from kinlint.text import SourceText

JOINT = '<joint name="elbow" type="revolute">{}</joint>'
LIMIT = '<limit lower="2" upper="-2.50" effort="10" velocity="1"/>'


def messages(name: str, text: str, code: str) -> list[str]:
    """What the rule *code* says of a file."""
    report = run([SourceText(name, text)], (), Settings(), rulebook.load())
    return [finding.message for finding in report.findings if finding.rule.code == code]


@pytest.mark.slow
def test_a_lifted_node_is_called_by_its_element() -> None:
    """Not by the address that only the graph has."""
    found = messages("arm.urdf", f'<robot name="arm">{JOINT.format(LIMIT)}</robot>', "LIM001")

    assert found == ["<limit> of joint 'elbow': lower limit 2 is above upper limit -2.5."]


@pytest.mark.slow
def test_an_entity_is_called_as_its_file_abbreviates_it() -> None:
    """In quotes."""
    text = """{
        "@context": ["https://w3id.org/kinlint/composable.json", {"ex": "https://example.org/#"}],
        "@id": "ex:range", "@type": "JointPositionLimit", "quantity-kind": "Angle", "unit": "RAD",
        "lower": 2, "upper": -2.5 }"""

    assert messages("arm.jsonld", text, "LIM001") == [
        "'ex:range': lower limit 2 is above upper limit -2.5."
    ]


def test_a_shape_without_a_name_is_told_apart_by_its_order() -> None:
    """As the second visual of its link."""
    shapes = "".join(
        f'<visual><geometry><sphere radius="{radius}"/></geometry></visual>' for radius in (1, 0)
    )
    text = f'<robot name="arm"><link name="hand">{shapes}</link></robot>'

    assert messages("arm.urdf", text, "GEO004") == [
        "<sphere> of <visual> 2 of link 'hand': radius is 0, but must be positive."
    ]


@pytest.mark.slow
def test_a_nested_model_is_part_of_the_name() -> None:
    """As SDF writes it."""
    axis = "<axis><xyz>0 0 0</xyz></axis>"
    parts = f"<parent>base</parent><child>hand</child>{axis}"
    joint = (
        f'<link name="base"/><link name="hand"/><joint name="elbow" type="revolute">{parts}</joint>'
    )
    text = f'<sdf version="1.9"><model name="cell"><model name="arm">{joint}</model></model></sdf>'

    assert messages("cell.sdf", text, "FRM008") == [
        "The axis of joint 'arm::elbow' of type 'revolute' is the zero vector."
    ]


@pytest.mark.slow
def test_places_are_counted_only_where_they_are_several() -> None:
    """And without quotes."""
    package = '<visual><geometry><mesh filename="package://gone/a.stl"/></geometry></visual>'

    def found(times: int) -> list[str]:
        text = f'<robot name="arm"><link name="hand">{package * times}</link></robot>'
        return messages("arm.urdf", text, "GEO002")

    start = "Package or model 'gone' was not found, so its files are not checked"
    assert found(1) == [f"{start}."]
    assert found(3) == [f"{start} (3 such places)."]


@pytest.mark.parametrize(
    ("template", "message"),
    [
        ("Joint '{?joint}' has no axis.", "Joint 'elbow' has no axis."),
        ("'{?limit}' is '{?value}'.", "<limit> of joint 'elbow' is 2."),
        ("'{?kind}' and {?name}.", "Joint 'elbow' and rob:a."),
        ("<{?tag} {?name}>", "<mass rob:a>"),
    ],
)
def test_words_take_quotes_as_they_need_them(template: str, message: str) -> None:
    """Names do, numbers and elements do not; a sentence begins with a capital."""
    words = {
        "joint": "'elbow'",
        "limit": "<limit> of joint 'elbow'",
        "value": "2",
        "kind": "joint 'elbow'",
        "name": "'rob:a'",
        "tag": "'mass'",
    }

    assert filled(template, words) == message


@pytest.mark.parametrize(
    ("number", "read"),
    [
        ("0.000133328921628796", "0.000133329"),
        ("7.34641020683213e-06", "7.34641e-06"),
        ("1.570796", "1.5708"),
        ("3.14159265358979", "3.14159"),
        ("0.9999999", "0.9999999"),
        ("1234567.8", "1234570"),
        ("1000000", "1000000"),
        ("-1.7976931348623157e+308", "-1.79769e+308"),
        ("-0.25", "-0.25"),
        ("inf", "inf"),
    ],
)
def test_numbers_have_as_many_digits_as_people_read(number: str, read: str) -> None:
    """Few are kept as they are."""
    assert brief(number) == read


def test_numbers_that_differ_are_written_so_that_they_do() -> None:
    """However many digits that takes."""
    limit = '<limit lower="1.5707963268" upper="1.5707963267" effort="10" velocity="1"/>'
    found = messages("arm.urdf", f'<robot name="arm">{JOINT.format(limit)}</robot>', "LIM001")

    assert found == [
        "<limit> of joint 'elbow': lower limit 1.5707963268 is above upper limit 1.5707963267."
    ]


def test_one_is_not_counted() -> None:
    assert counted("A joint has no axis.", 1) == "A joint has no axis."
    assert counted("A joint has no axis.", 2) == "A joint has no axis (2 such places)."
