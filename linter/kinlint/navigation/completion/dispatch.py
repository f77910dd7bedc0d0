"""Completion by the kind of the format."""

from __future__ import annotations

from kinlint.navigation.completion import (
    json_completion,
    turtle_completion,
    usd_completion,
    xml_completion,
    yaml_completion,
)
from kinlint.navigation.completion.candidate import NOTHING, Completions
from kinlint.navigation.completion.situation import Situation

TRIGGERS = ("<", '"', "'", " ", "/", ":", "$", "{", "(", "[", ",", "@")
"""Characters behind which editors ask for candidates."""


def complete(situation: Situation) -> Completions:
    """Return what can be written at the place of *situation*."""
    if situation.format.fence == "xml":
        return xml_completion.complete(situation)
    if situation.format.fence == "json":
        return json_completion.complete(situation)
    if situation.format.fence == "yaml":
        return yaml_completion.complete(situation)
    if situation.format.fence == "usda":
        return usd_completion.complete(situation)
    return turtle_completion.complete(situation) if situation.format.fence == "turtle" else NOTHING
