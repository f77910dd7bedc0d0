from __future__ import annotations

import json
import re
from dataclasses import replace
from pathlib import Path
from typing import Any
from uuid import UUID

import pytest
from reported import (
    BOTH,
    DYNAMICS,
    INERTIA,
    INERTIA_FINDING,
    SKELETON,
    UNIT,
    at,
    here,
    report,
    unit_finding,
)
from sarif_reader import results, rules

from kinlint.errors import SourceError
from kinlint.finding import Premise, Related
from kinlint.report import Invocation, Report
from kinlint.reporters.antipatterns import ANTIPATTERNS
from kinlint.reporters.sarif.rule_descriptors import friendly_name
from kinlint.reporters.sarif.sarif_log import log
from kinlint.rule import Severity


def run(made: Report) -> dict[str, Any]:
    (only,) = log(made)["runs"]
    loaded: dict[str, Any] = json.loads(json.dumps(only))
    return loaded


def test_a_result_has_a_message_a_place_taxa_and_links() -> None:
    result = run(BOTH)["results"][0]
    assert result["message"] == {
        "text": "Inertia 'rob:link2-inertia' is seen by frame 'rob:link1-root' of another body. "
        "See [models/dynamics.jsonld:5](1), [models/skeleton.jsonld:2](2).",
        "id": "message2",
        "arguments": [
            "rob:link2-inertia",
            "rob:link1-root",
            "models/dynamics.jsonld:5",
            "models/skeleton.jsonld:2",
        ],
    }
    (location,) = result["locations"]
    assert location["physicalLocation"]["artifactLocation"] == {
        "uri": "models/dynamics.jsonld",
        "uriBaseId": "SRCROOT",
    }
    assert location["logicalLocations"] == [
        {
            "name": "link2-inertia",
            "fullyQualifiedName": "https://example.org/robot#link2-inertia",
            "kind": "object",
        }
    ]
    assert [place["id"] for place in result["relatedLocations"]] == [1, 2]
    assert [taxon["id"] for taxon in result["taxa"]] == ["AP3"]


def test_a_derivation_goes_from_what_is_written_to_the_finding() -> None:
    (flow,) = run(BOTH)["results"][0]["codeFlows"]
    (thread,) = flow["threadFlows"]
    steps = [
        (
            step["location"]["message"]["text"],
            step["location"]["physicalLocation"]["region"]["startLine"],
            step["nestingLevel"],
        )
        for step in thread["locations"]
    ]
    assert steps == [
        ("link2-inertia of-body link2", 5, 1),
        ("link1-root of-body link1", 2, 2),
        ("link1-root a Frame (what has an origin is a Frame)", 2, 1),
        (INERTIA_FINDING.message, 7, 0),
    ]


def test_a_finding_that_rests_on_nothing_else_has_no_flow() -> None:
    finding = replace(INERTIA_FINDING, because=())
    assert "codeFlows" not in run(report(finding))["results"][0]


def test_a_premise_without_any_place_is_shown_at_the_finding() -> None:
    finding = replace(INERTIA_FINDING, because=(Premise("a b c", axiom="so"),))
    (flow,) = run(report(finding))["results"][0]["codeFlows"]
    lines = [
        step["location"]["physicalLocation"]["region"]["startLine"]
        for step in flow["threadFlows"][0]["locations"]
    ]
    assert lines == [7, 7]


def test_a_rule_is_described_as_github_wants_it() -> None:
    rule, other = rules(log(BOTH))
    assert rule["id"] == "INE007"
    assert rule["name"] == "InertiaSeenByForeignFrame"
    assert rule["shortDescription"]["text"] == "inertia is seen by a frame of another body"
    assert rule["fullDescription"]["text"].startswith("An inertia is a matrix of numbers, and")
    assert rule["helpUri"] == INERTIA.iri
    assert "kinlint rule INE007" in rule["help"]["text"]
    assert "```" in rule["help"]["markdown"]
    assert rule["defaultConfiguration"] == {"level": "error"}
    assert rule["properties"] == {
        "precision": "high",
        "problem.severity": "error",
        "tags": ["robotics", "ine", "ap3"],
    }
    targets = [relation["target"]["id"] for relation in other["relationships"]]
    assert targets == ["AP5", "AP6"]
    assert other["messageStrings"]["message1"]["text"] == "Unit '{0}' does not fit."


def test_rules_that_found_nothing_are_left_out_and_found_ones_need_not_be_given() -> None:
    assert rules(log(report())) == []
    made = replace(report(INERTIA_FINDING), rules=())
    assert [rule["id"] for rule in rules(log(made))] == ["INE007"]


def test_the_severity_of_a_finding_is_its_own() -> None:
    made = report(unit_finding(here("x", 0, 1), severity=Severity.INFO))
    assert run(made)["results"][0]["level"] == "note"
    assert rules(log(made))[0]["defaultConfiguration"]["level"] == "warning"


def test_a_rule_called_by_no_web_address_still_has_help() -> None:
    rule = replace(UNIT, iri="_:b0", messages=())
    made = Report(findings=(unit_finding(here("x", 0, 1), rule=rule),), root="/work")
    assert rules(log(made))[0]["helpUri"] == "https://w3id.org/kinlint/rules/"


@pytest.mark.parametrize(
    ("name", "friendly"),
    [
        ("not-a-rotation", "NotaRotation"),
        ("a-frame", "Aframe"),
        ("missing-3d-frame", "Missing3dFrame"),
        ("3d-frame", "Rule3dFrame"),
        ("axis-x-y", "Axisxy"),
    ],
)
def test_a_friendly_name_is_pascal_case_to_the_validator(name: str, friendly: str) -> None:
    assert friendly_name(name) == friendly
    assert re.fullmatch("([A-Z][a-z0-9]+)+", friendly)


def test_the_taxonomy_describes_all_anti_patterns() -> None:
    (taxonomy,) = run(report())["taxonomies"]
    assert taxonomy["name"] == "kinlint-antipatterns"
    assert taxonomy["isComprehensive"]
    assert [taxon["id"] for taxon in taxonomy["taxa"]] == [f"AP{n}" for n in range(1, 7)]
    assert [taxon["name"] for taxon in taxonomy["taxa"]] == [one.name for one in ANTIPATTERNS]


def test_brackets_make_no_links_and_braces_no_placeholders() -> None:
    finding = unit_finding(here("x", 0, 1), "[a](7) {0}")
    (result,) = results(log(report(finding)))
    assert result["message"]["text"] == r"Unit '\[a\](7) {0}' does not fit."
    assert result["message"]["arguments"] == [r"\[a\](7) {0}"]


@pytest.mark.parametrize("template", ["", "Another {?value} template", "Free [text] {x}"])
def test_a_message_that_is_not_its_template_filled_in_is_an_argument(template: str) -> None:
    finding = unit_finding(here("x", 0, 1), message="Free [text] {x}", template=template)
    made = report(finding)
    (result,) = results(log(made))
    assert result["message"]["arguments"] == [r"Free \[text\] {x}", finding.iri]
    strings = rules(log(made))[0]["messageStrings"]
    assert strings[result["message"]["id"]]["text"] == "'{0}' Entity: '{1}'."


def test_a_template_without_placeholders_is_about_its_entity() -> None:
    rule = replace(UNIT, messages=("It has {no} unit",))
    finding = unit_finding(
        here("x", 0, 1), rule=rule, message=rule.messages[0], template=rule.messages[0]
    )
    made = Report(findings=(finding,))
    (result,) = results(log(made))
    strings = rules(log(made))[0]["messageStrings"]
    assert list(strings.values()) == [{"text": "It has {{no}} unit. Entity: '{0}'."}]
    assert result["message"]["text"] == "It has {no} unit."
    assert result["message"]["arguments"] == [finding.iri]


def test_only_ten_related_locations_are_linked() -> None:
    related = tuple(Related(at(SKELETON, "rob:link1"), "") for _ in range(12))
    (result,) = results(log(report(unit_finding(here("x", 0, 1), related=related))))
    assert len(result["relatedLocations"]) == 10
    assert result["message"]["text"].count("](") == 10


def test_a_blank_node_has_no_logical_location() -> None:
    (result,) = results(log(report(unit_finding(here("x", 0, 1), iri="_:b0"))))
    assert "logicalLocations" not in result["locations"][0]


def test_suppressions_are_on_all_results_or_on_none() -> None:
    known = replace(INERTIA_FINDING, suppressed="known")
    configured = unit_finding(at(DYNAMICS, '"M"'), suppressed="ignored by kinlint.toml: a.jsonld")
    still_open = unit_finding(here("x", 0, 1, name="z.jsonld"))
    assert [one["suppressions"] for one in results(log(report(known, configured, still_open)))] == [
        [{"kind": "inSource", "justification": "known"}],
        [{"kind": "external", "justification": "ignored by kinlint.toml: a.jsonld"}],
        [],
    ]
    assert all("suppressions" not in one for one in results(log(BOTH)))


def test_a_file_that_cannot_be_read_is_a_notification() -> None:
    errors = (SourceError("a b.jsonld", "no [JSON]", 3, 4), SourceError("c.jsonld", "gone"))
    (invocation,) = run(Report(errors=errors, root="/work"))["invocations"]
    assert invocation["executionSuccessful"] is False
    first, second = invocation["toolExecutionNotifications"]
    assert first["message"]["text"] == r"no \[JSON\]"
    place = first["locations"][0]["physicalLocation"]
    assert place["artifactLocation"]["uri"] == "a%20b.jsonld"
    assert place["region"] == {"startLine": 3, "startColumn": 4}
    assert "region" not in second["locations"][0]["physicalLocation"]
    assert run(report())["invocations"] == [{"executionSuccessful": True}]


def test_files_outside_the_root_have_a_base_of_their_own(tmp_path: Path) -> None:
    root = tmp_path / "robots" / "arm"
    root.mkdir(parents=True)
    names = ["../x.jsonld", str(tmp_path / "y.jsonld"), str(root / "in" / "z.jsonld")]
    made = replace(report(*(unit_finding(here("x", 0, 1, name=n)) for n in names)), root=str(root))
    only = run(made)
    locations = {
        result["locations"][0]["physicalLocation"]["artifactLocation"]["uri"]: result["locations"][
            0
        ]["physicalLocation"]["artifactLocation"]["uriBaseId"]
        for result in only["results"]
    }
    assert locations == {"x.jsonld": "PARENT1", "y.jsonld": "PARENT2", "in/z.jsonld": "SRCROOT"}
    assert list(only["originalUriBaseIds"]) == ["PARENT1", "PARENT2", "SRCROOT"]


def test_a_context_does_not_begin_inside_a_line_end() -> None:
    text = "x\r\n" + "a" * 199 + '"M"'
    (result,) = results(log(report(unit_finding(here(text, 202, 205)))))
    context = result["locations"][0]["physicalLocation"]["contextRegion"]
    assert (context["startLine"], context["startColumn"]) == (2, 1)
    assert context["snippet"]["text"] == text[3:]


def test_a_linked_file_is_named_where_it_is(tmp_path: Path) -> None:
    (tmp_path / "real.jsonld").write_text("{}")
    (tmp_path / "link.jsonld").symlink_to("real.jsonld")
    made = replace(report(unit_finding(here("{}", 0, 1, name="link.jsonld"))), root=str(tmp_path))
    place = run(made)["results"][0]["locations"][0]["physicalLocation"]
    assert place["artifactLocation"]["uri"] == "real.jsonld"


def test_the_call_and_the_texts_are_told_on_request() -> None:
    """They have times, a path and an identifier; without the request there are none of these."""
    call = Invocation(("--select", "a b"), 0.0, 1.5, 1)
    told = run(replace(BOTH, invocation=call, embedded=True, root="/cell 1"))
    assert told["invocations"] == [
        {
            "executionSuccessful": True,
            "commandLine": "kinlint --select 'a b'",
            "arguments": ["--select", "a b"],
            "startTimeUtc": "1970-01-01T00:00:00.000000Z",
            "endTimeUtc": "1970-01-01T00:00:01.500000Z",
            "exitCode": 1,
            "workingDirectory": {"uri": "file:///cell%201/"},
        }
    ]
    assert UUID(told["automationDetails"]["guid"])
    texts = {one["location"]["uri"]: one["contents"]["text"] for one in told["artifacts"]}
    assert texts["models/dynamics.jsonld"] == DYNAMICS.text
    assert {"artifacts", "automationDetails"}.isdisjoint(run(BOTH))
