"""The robots, parts and files that an XML text names, found by its tags without parsing it.

Files are grouped and paired before they are read; a text with faults is scanned like any other.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cached_property
from urllib.parse import unquote

from kinlint.formats.recognition import with_format
from kinlint.light_dataclasses import dataclass
from kinlint.text import XML_COMMENT, SourceText

_VALUE = r"""\s*=\s*(?:"([^"]*)"|'([^']*)')"""
_ROBOT = re.compile(rf"<robot\b[^<>]*?\sname{_VALUE}")
_MODEL = re.compile(rf"<(?:robot|model|mujoco)\b[^<>]*?\s(?:name|model){_VALUE}")
_PART = re.compile(rf"<(?:link|joint|passive_joint)\b[^<>]*?\sname{_VALUE}")
_REFERENCE = re.compile(
    rf"\s(?:base_link|tip_link|parent_link|child_link|link1|link2|joint_name){_VALUE}"
)
_FILENAME = re.compile(rf"<(?:[\w-]+:)?include\b[^<>]*?\sfilename{_VALUE}")
_INCLUDE = re.compile(r"<include\b[^<>]*>(.*?)(?:</include>|\Z)", re.DOTALL)
_URI = re.compile(r"<uri\b[^<>]*>([^<]*)<")
_ARGUMENT = "<xacro:arg"
_DEFINITION = re.compile(r"<xacro:macro\b.*?</xacro:macro\s*>", re.DOTALL)
_CALL = re.compile(
    r"<xacro:(?!(?:arg|attribute|element|if|include|insert_block|macro|property|unless)\b)\w"
)


@dataclass(frozen=True)
class Mentions:
    """The names in one text, outside of its comments."""

    source: SourceText
    """The text."""

    @cached_property
    def _text(self) -> str:
        return XML_COMMENT.sub("", self.source.text)

    @cached_property
    def robot(self) -> str:
        """The name of the robot of a URDF or SRDF, empty if it has none."""
        return next(iter(_values(_ROBOT.findall(self._text))), "")

    @cached_property
    def robots(self) -> frozenset[str]:
        """The names of all robots and models."""
        return frozenset(_values(_MODEL.findall(self._text)))

    @cached_property
    def parts(self) -> frozenset[str]:
        """The names of the links and joints that it describes."""
        return frozenset(_values(_PART.findall(self._text)))

    @cached_property
    def references(self) -> frozenset[str]:
        """The names of links and joints in the attributes by which an SRDF refers to them."""
        return frozenset(_values(_REFERENCE.findall(self._text)))

    @cached_property
    def included(self) -> tuple[str, ...]:
        """The last steps of the paths and URIs of what it includes; see `is_pattern`."""
        uris = (uri for nested in _INCLUDE.findall(self._text) for uri in _URI.findall(nested))
        paths = (*_values(_FILENAME.findall(self._text)), *uris)
        return tuple(unquote(path.strip().rstrip("/")).rpartition("/")[2] for path in paths)

    @cached_property
    def calls_macros(self) -> bool:
        """Tell whether macros make parts of it, and not only of what others make of it."""
        return _CALL.search(_DEFINITION.sub("", self._text)) is not None

    @property
    def has_arguments(self) -> bool:
        """Tell whether arguments without known values affect its expansion."""
        return _ARGUMENT in self._text


def is_pattern(name: str) -> bool:
    """Tell whether the *name* of a file contains an expression and may stand for any file."""
    return not {"$", "}", ")", "*", "?"}.isdisjoint(name)


def includes_nothing(source: SourceText) -> bool:
    """Tell whether *source* certainly depends on no other file."""
    form = with_format(source).format
    plain = form is not None and form.describes_robots and not form.expands_to
    return plain and "include" not in source.text


def _values(found: Iterable[tuple[str, str]]) -> Iterable[str]:
    """Return the values of attributes, which stand between either kind of quotes."""
    return (one or other for one, other in found)
