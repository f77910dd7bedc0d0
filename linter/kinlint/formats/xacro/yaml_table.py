"""Reads YAML as xacro does, with its units, but nothing that grows when it is unfolded."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import yaml

from kinlint.files.bounded_read import Unreadable
from kinlint.formats.xacro.expansion_limits import LimitExceeded, Limits
from kinlint.formats.xacro.expression_symbols import dotted

MERGED = 10_000
"""Maximum number of entries that one mapping may merge."""
DIGITS = 400
"""Maximum length of a number, in characters: PyYAML's base 60 takes quadratic time."""
PER_CHARACTER = 16
"""Weight of a character of YAML: PyYAML reads some 150 000 of them a second."""
MERGE = "tag:yaml.org,2002:merge"
UNITS = {
    "!radians": 1.0,
    "!degrees": math.pi / 180.0,
    "!meters": 1.0,
    "!millimeters": 0.001,
    "!foot": 0.3048,
    "!inches": 0.0254,
}


def load(data: bytes, name: str, evaluate: Callable[[str], Any], bounds: Limits) -> Any:
    """Load the YAML *data* of the file *name*, tables with entries to be named with a dot.

    A value with a unit is an expression that *evaluate* knows.
    """

    class Loader(yaml.SafeLoader):  # type: ignore[misc]
        """PyYAML's safe loader with units, without long numbers or merging beyond measure."""

        def flatten_mapping(self, node: yaml.MappingNode) -> None:
            given = [value for key, value in node.value if key.tag == MERGE]
            listed = (v.value if isinstance(v, yaml.SequenceNode) else [v] for v in given)
            merged = [v for values in listed for v in values if isinstance(v, yaml.MappingNode)]
            for each in merged:
                self.flatten_mapping(each)
            size = sum(len(each.value) for each in merged)
            if size > MERGED:
                raise LimitExceeded(f"'{name}' merges more than {MERGED} entries")
            bounds.charge(PER_CHARACTER * size)
            super().flatten_mapping(node)

        def construct_scalar(self, node: yaml.ScalarNode) -> Any:
            if node.tag.endswith((":int", ":float")) and len(node.value) > DIGITS:
                raise LimitExceeded(f"'{name}' has a number of more than {DIGITS} characters")
            return super().construct_scalar(node)

    def with_unit(loader: yaml.SafeLoader, tag: str, node: yaml.Node) -> float:
        return float(evaluate(str(loader.construct_scalar(node)))) * UNITS["!" + tag]

    bounds.charge(PER_CHARACTER * len(data))
    Loader.add_multi_constructor("!", with_unit)
    try:
        loader = Loader(data)
        try:
            value = loader.get_single_data()
        finally:
            loader.dispose()
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        at = f":{mark.line + 1}:{mark.column + 1}" if mark else ""
        what = getattr(error, "problem", None) or "no YAML"
        raise Unreadable(f"'{name}{at}' is not valid YAML: {what}") from None
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise Unreadable(f"'{name}' is not YAML that xacro reads: {error}") from None
    bounds.result(value)
    return dotted(value)
