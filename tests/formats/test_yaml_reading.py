"""YAML of joints is read; other YAML and templates are passed over, and broken YAML is an error."""

from __future__ import annotations

import pytest

from kinlint.errors import SourceError
from kinlint.formats.options import ReadOptions
from kinlint.formats.yaml.reader import read
from kinlint.text import SourceText

LISTED = "controller:\n  ros__parameters:\n    joints: [elbow, wrist]\n"


def names(text: str) -> set[str]:
    """The names of joints that *text* is read to give."""
    document = read(SourceText("controllers.yaml", text), ReadOptions())
    return {
        value[1:-1]
        for element, predicate, value in document.statements
        if predicate.endswith("attribute#name>") and "/controller" not in element
    }


def test_several_documents_are_read():
    limits = "joint_limits:\n  hip: {max_velocity: 1.0}\n"
    assert names(f"{LISTED}---\n{limits}") == {"elbow", "wrist", "hip"}


def test_tables_that_name_parts():
    gains = "pid_gains: {knee: {p: 1.0}}\n"
    ends = "kinematics: {plugin_name: kdl, base: pelvis, tip: foot}\n"
    assert names(f"{gains}---\n{ends}") == {"knee", "pelvis", "foot"}
    assert names(ends.replace("plugin_name", "name")) == set()


@pytest.mark.slow
@pytest.mark.parametrize(
    ("text", "cause", "place"),
    [
        (LISTED.replace("]", ""), "not YAML: expected ',' or ']'", (4, 1)),
        ("joints: " + "[" * 50_000, "nested too deeply", (None, None)),
        ("joints: *arm\n", "not YAML: found undefined alias 'arm'", (1, 9)),
    ],
    ids=["open list", "deep", "alias"],
)
def test_what_is_no_yaml_is_an_error(text, cause, place):
    with pytest.raises(SourceError, match=r".") as raised:
        names(text)
    assert raised.value.cause.startswith(cause)
    assert (raised.value.line, raised.value.column) == place


@pytest.mark.parametrize(
    "text",
    [
        "joints: {{ joints }\n  x: [",
        "{% for each in arms %}\njoints: [{{ each }}\n{% endfor %}\n",
        "name: [1\n",
    ],
    ids=["value", "loop", "not about joints"],
)
def test_templates_and_other_files_say_nothing(text):
    assert names(text) == set()
