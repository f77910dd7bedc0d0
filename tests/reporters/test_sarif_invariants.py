"""What SARIF requires and its validator does not see, on reports of any kind."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from typing import Any

import pytest
from hypothesis import given
from reported import here, report, reports, unit_finding
from sarif_reader import (
    LINK,
    by_column,
    by_offset,
    file_name,
    filled,
    objects,
    overlapping,
    places,
    results,
    rules,
)

from kinlint.finding import Finding
from kinlint.report import Report
from kinlint.reporters.sarif.line_hash import LineHashes
from kinlint.reporters.sarif.sarif_log import log, render
from kinlint.reporters.terminal_style import Style
from kinlint.text import SourceText

pytestmark = pytest.mark.slow


def pairs(made: Report) -> list[tuple[Finding, dict[str, Any]]]:
    return list(zip(made.findings, results(log(made)), strict=True))


def sources(made: Report) -> dict[str, SourceText]:
    """The sources of a report by what ends their URIs."""
    locations = [
        location
        for finding in made.findings
        for location in (
            finding.location,
            *(one.location for one in finding.related),
            *(one.location for one in finding.because),
        )
        if location is not None
    ]
    return {place.source.name.removeprefix("../").strip("/"): place.source for place in locations}


@given(reports())
def test_1_each_result_points_at_its_own_rule(made: Report) -> None:
    descriptors = rules(log(made))
    for finding, result in pairs(made):
        assert result["ruleId"] == finding.rule.code
        assert descriptors[result["ruleIndex"]]["id"] == finding.rule.code


@given(reports())
def test_2_offsets_lines_and_columns_name_one_text_in_utf16(made: Report) -> None:
    known = sources(made)
    for place in places(log(made)):
        source = known[file_name(place["artifactLocation"])]
        for kind in ("region", "contextRegion"):
            if kind in place:
                region = place[kind]
                text = region["snippet"]["text"]
                assert by_offset(source, region) == by_column(source, region) == text


@given(reports())
def test_2_the_region_is_the_span_or_the_first_line_of_it(made: Report) -> None:
    for finding, result in pairs(made):
        source, span = finding.location.source, finding.location.span
        region = result["locations"][0]["physicalLocation"]["region"]
        text = region["snippet"]["text"]
        whole = len(source.text) > 1 and span == (0, len(source.text))
        assert source.text.startswith(text, span.start)
        assert len(re.split(r"\r\n|\n|\r", text)) == 1
        assert text == source[span] or whole or re.search("[\r\n]", source[span])


@given(reports())
def test_2_the_context_holds_the_region_and_more_but_not_a_whole_file(made: Report) -> None:
    for finding, result in pairs(made):
        place = result["locations"][0]["physicalLocation"]
        inner, outer = place["region"], place.get("contextRegion")
        if outer is None:
            assert len(finding.location.source.text) <= 1
            continue
        assert outer["charOffset"] <= inner["charOffset"]
        ends = [one["charOffset"] + one["charLength"] for one in (inner, outer)]
        assert ends[0] <= ends[1]
        assert inner["charLength"] < outer["charLength"] <= inner["charLength"] + 800


@given(reports())
def test_3_taxa_and_tool_components_are_where_indices_say(made: Report) -> None:
    (run,) = log(made)["runs"]
    components = run["taxonomies"]
    references = [one for one in objects(run) if "toolComponent" in one]
    assert references or not made.findings
    for reference in references:
        component = components[reference["toolComponent"]["index"]]
        assert component["name"] == reference["toolComponent"]["name"]
        assert component["taxa"][reference["index"]]["id"] == reference["id"]
    for supported in run["tool"]["driver"]["supportedTaxonomies"]:
        assert components[supported["index"]]["name"] == supported["name"]


@given(reports())
def test_4_replacements_do_not_overlap(made: Report) -> None:
    for one in objects(log(made)):
        assert not overlapping(one.get("replacements", []))


@given(reports())
def test_5_uris_are_relative_and_straight(made: Report) -> None:
    (run,) = log(made)["runs"]
    for one in objects(run["results"]):
        if "artifactLocation" in one:
            uri, base = one["artifactLocation"]["uri"], one["artifactLocation"]["uriBaseId"]
            assert re.fullmatch(r"(?:[\w.~/-]|%[0-9A-F]{2})+", uri)
            assert not {"", ".", ".."} & set(uri.split("/"))
            assert "uri" not in run["originalUriBaseIds"][base]


@given(reports())
def test_6_columns_are_announced_as_utf16(made: Report) -> None:
    assert log(made)["runs"][0]["columnKind"] == "utf16CodeUnits"


@given(reports())
def test_7_each_result_has_both_fingerprints(made: Report) -> None:
    identities = []
    for finding, result in pairs(made):
        location, fingerprints = finding.location, dict(result["partialFingerprints"])
        line_hash = LineHashes(location.source).line_hash(location.start.line)
        identities.append(fingerprints.pop("kinlintFinding/v1"))
        assert fingerprints == {"primaryLocationLineHash": line_hash}
        assert identities[-1].partition(":")[0] == finding.fingerprint
    assert len(set(identities)) == len(identities)


def test_7_a_finding_about_a_file_keeps_its_identity_where_the_file_goes() -> None:
    """Also, it is no logical location that the file has a name."""
    made = []
    for name in ("a.jsonld", "b/c.jsonld"):
        place = here('{"a": 1}', 1, 4, name=name)
        finding = replace(unit_finding(place), iri=f"urn:kinlint:document:{name}")
        (result,) = results(log(report(finding)))
        made.append(result["partialFingerprints"]["kinlintFinding/v1"])
        assert "logicalLocations" not in result["locations"][0]
    assert made[0] == made[1]


@given(reports())
def test_8_links_and_related_locations_belong_together(made: Report) -> None:
    for _, result in pairs(made):
        ids = [related["id"] for related in result.get("relatedLocations", [])]
        assert [int(number) for number in LINK.findall(result["message"]["text"])] == ids
        assert len(set(ids)) == len(ids)
    for one in objects(log(made)):
        message = one.get("message", {})
        if "id" not in message:
            assert not LINK.search(message.get("text", ""))


@given(reports())
def test_9_10_11_a_result_is_a_failure_without_baseline_or_rank(made: Report) -> None:
    for finding, result in pairs(made):
        assert result.get("kind", "fail") == "fail"
        assert (
            result["level"]
            == {"error": "error", "warning": "warning", "info": "note"}[finding.severity.label]
        )
        assert not {"baselineState", "rank"} & set(result)


def words(text: str) -> str:
    """*text* without the quotes that SARIF wants around whatever is filled in."""
    return text.replace("'", "").lower()


@given(reports())
def test_a_message_is_its_template_filled_in(made: Report) -> None:
    descriptors = {rule["id"]: rule for rule in rules(log(made))}
    for finding, result in pairs(made):
        message = result["message"]
        template = descriptors[result["ruleId"]]["messageStrings"][message["id"]]["text"]
        said = words(filled(template, message["arguments"]))
        assert said == words(message["text"]) or "Entity:" in template
        numbers = {int(number) for number in re.findall(r"(?<!\{)\{(\d+)\}", template)}
        assert numbers == set(range(len(message["arguments"])))
        stem = finding.message.removesuffix(".")
        assert stem in re.sub(r"\\([\[\]\\])", r"\1", message["text"]) or "\\" in stem


@given(reports())
def test_every_template_pleases_the_validator(made: Report) -> None:
    for rule in rules(log(made)):
        for string in rule.get("messageStrings", {}).values():
            assert string["text"].endswith(".")
            quoted = re.findall(r"'\{\d+\}'", string["text"])
            assert quoted
            assert len(quoted) == len(re.findall(r"(?<!\{)\{\d+\}", string["text"]))


@given(reports())
def test_equal_reports_make_equal_logs(made: Report) -> None:
    once, again = ("".join(render(made, Style())) for _ in range(2))
    assert once == again
    assert "/work" not in once.replace("https://", "")
    assert json.loads(once) == json.loads("".join(render(made, Style(unicode=False))))
