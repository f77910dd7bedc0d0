"""Inputs that once failed."""

from __future__ import annotations

import pytest

from fuzzing.trial import Input, fault

POSE = '<sdf version="1.9"><model name="m"><link name="l"><pose>{}</pose></link></model></sdf>'
KEPT = {
    "an array cut off": ("jsonld", b'{"@context": {"x": "https://x.example/"}, "@graph": [null, ['),
    "null in lists": (
        "jsonld",
        (
            b'{"@context": {"x": {"@id": "https://x.example/", "@container": "@list"}},'
            b'"@graph": [{"x": [null, [null], {"@list": [null]}]}, null, [null]]}'
        ),
    ),
    "a type of 30 000 letters": (
        "jsonld",
        b'{"@context": "https://w3id.org/kinlint/composable.json", "@id": "https://x.example/a",'
        b'"@type": "Joint' + b"t" * 30_000 + b'"}',
    ),
    "a namespace of 60 000 letters": (
        "jsonld",
        b'{"@context": ["https://w3id.org/kinlint/composable.json", {"x": "https://x.example/'
        + b"link" * 15_000
        + b'/"}], "@graph": [{"@id": "x:a", "@type": "Frame", "origin": "x:b"},'
        b'{"@id": "x:c", "@type": "Frame", "origin": "x:d"}]}',
    ),
    "an infinite angle": ("sdf", POSE.format("0 0 0 inf 0 0").encode()),
    "a malformed address to include": (
        "sdf",
        b'<sdf version="1.9"><world name="w"><include><uri>http://[x</uri></include></world></sdf>',
    ),
    "a malformed relative address": ("turtle", b"@base <http://x.example/> . <//[x> a <//[y> ."),
    "a query that is no literal": (
        "turtle",
        b"@prefix sh: <http://www.w3.org/ns/shacl#> . <urn:x> sh:select <urn:y> , sh:Shape .",
    ),
    "a huge angle": ("sdf", POSE.format("0 0 0 1e308 -1e308 1e400").encode()),
    "a name that no query can hold": (
        "jsonld",
        (
            b'{"@context": ["https://comp-rob2b.github.io/metamodels/newtonian-rigid-body-dynamics/'
            b'operators.json", {"@base": "https://x.example/"}], "@graph": ['
            b'{"@id": "transform-[[a", "@type": "TransformWrenchToProximal", "pose": "pose-a",'
            b'"from": "wrench-a", "to": "wrench-b"}, {"@id": "add", "@type": "AddWrench",'
            b'"in1": "wrench-b", "in2": "wrench-c", "out": "wrench-d"}]}'
        ),
    ),
    "an angle that is no number": ("sdf", POSE.format("nan 0 0 nan 0 0").encode()),
}

JOINT = (
    b'{"@context": {"x": "https://x.example/", "y": "https://y.example/"},'
    b'"@id": "x:a", "x:b": [{"@id": "y:c"}, {"@id": "x:nobody"}]}'
)
CUT_OFF = (
    b'{"@context": {"x": "https://x.example/a>b/", "y": "https://y.example/<"},'
    b'"@graph": [{"@id": "x:a"}, {"@id": "y:\\b"}, {"@id": "https://z.example/<a"}'
)
TOGETHER = {
    "names that no store holds, in a file cut off": (("jsonld", CUT_OFF), ("jsonld", JOINT)),
}


@pytest.mark.parametrize("name", TOGETHER)
def test_they_are_answered_as_one_model(name):
    """With findings about one of them, which what is wrong with another may lead to."""
    given = [Input(form, 0, f"kept.{form}", content) for form, content in TOGETHER[name]]
    assert fault(*given) is None


@pytest.mark.parametrize("name", KEPT)
def test_it_is_answered(name):
    form, content = KEPT[name]
    assert fault(Input(form, 0, f"kept.{form}", content)) is None
