"""YAML text as nodes with their places."""

from __future__ import annotations

import re

import yaml

from kinlint.errors import SourceError
from kinlint.formats.yaml.ros_keys import LARGEST, NAMING

TEMPLATE = re.compile(r"\{[{%#]|<%|^[ \t]*@\[", re.MULTILINE)
"""Marks of Jinja, ERB and EmPy, whose templates need not be YAML."""
OPENCV = "%YAML:1.0"
"""Beginning of the files of OpenCV, which only resemble YAML."""


def compose(name: str, text: str) -> list[yaml.Node]:
    """Return the documents of *text*, of the file called *name*; none if it names no robot's parts.

    Raises `SourceError` for what is neither YAML nor a template of YAML.
    """
    if len(text) > LARGEST or not NAMING.search(text.encode("utf-8", "replace")):
        return []
    if text.startswith(OPENCV):
        return []
    try:
        found = list(yaml.compose_all(text, Loader=yaml.SafeLoader))
    except (yaml.YAMLError, RecursionError, ValueError) as error:
        if TEMPLATE.search(text):
            return []
        raise _source_error(name, error) from error
    return [each for each in found if each is not None]


def _source_error(name: str, error: Exception) -> SourceError:
    if isinstance(error, RecursionError):
        return SourceError(name, "nested too deeply")
    if isinstance(error, yaml.MarkedYAMLError) and error.problem_mark is not None:
        mark = error.problem_mark
        return SourceError(name, f"not YAML: {error.problem}", mark.line + 1, mark.column + 1)
    return SourceError(name, f"not YAML: {' '.join(str(error).split())}")
