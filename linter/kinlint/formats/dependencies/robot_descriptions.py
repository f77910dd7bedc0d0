"""Descriptions of a robot: its name and its parts, found in a text without parsing it."""

from __future__ import annotations

import re
from functools import cached_property
from pathlib import Path

from kinlint.file_format import Format
from kinlint.files.pathglob import absolute
from kinlint.formats.dependencies.mentions import Mentions
from kinlint.formats.recognition import with_format
from kinlint.formats.srdf.format import SRDF
from kinlint.formats.urdf.format import URDF
from kinlint.light_dataclasses import dataclass
from kinlint.text import XML_COMMENT, SourceText

ENDING = SRDF.suffixes[0]
_SEMANTIC = re.compile(r"<(?:group|group_state|disable_collisions|end_effector)\s")
_PHYSICAL = re.compile(
    r"<(?:parent|child|visual|collision|inertial|origin|axis|ros2_control)[\s>/]"
)
MOST = 0.5
"""Share of the names in an SRDF that a URDF must define to be taken for its robot."""


@dataclass(frozen=True)
class Description:
    """A text that describes a robot: a URDF, or an SRDF about one."""

    source: SourceText
    """The text."""
    kind: Format
    """Its format."""

    @cached_property
    def mentions(self) -> Mentions:
        """The names in its text."""
        return Mentions(self.source)

    @property
    def robot(self) -> str:
        """The name of the robot."""
        return self.mentions.robot

    @cached_property
    def path(self) -> Path:
        """The absolute path of its file."""
        return absolute(self.source.name)

    @property
    def stem(self) -> str:
        """The name of its file without the ends that tell its format."""
        return self.path.name.partition(".urdf")[0].partition(ENDING)[0].removesuffix(".xacro")

    @cached_property
    def names(self) -> frozenset[str]:
        """The links and joints that it has or, an SRDF, that it speaks of."""
        parts = self.mentions.parts
        return parts | self.mentions.references if self.kind == SRDF else parts

    @property
    def generated(self) -> bool:
        """Tell whether its names are made up when it is expanded."""
        return self.source.format is not None and self.source.format.expands_to is not None

    @property
    def varies(self) -> bool:
        """Tell whether arguments without known values decide its content."""
        return self.generated and self.mentions.has_arguments

    @property
    def unexpanded(self) -> bool:
        """Tell whether it contains names that only an expansion would make up."""
        return not self.generated and any("$" in name for name in (self.robot, *self.names))

    def share_defined(self, names: frozenset[str]) -> float:
        """Return the share of *names* that it defines, from 0 to 1."""
        return len(names & self.names) / len(names) if names else 1.0

    def resembles(self, urdf: Description) -> bool:
        """Tell whether *urdf* defines most of what this SRDF speaks of, as far as is known."""
        return self.generated or urdf.generated or urdf.share_defined(self.names) >= MOST


def describe(source: SourceText) -> Description | None:
    """Return the description of *source*; None if it is neither SRDF nor URDF.

    Files of xacro that only define parts of an SRDF are neither.
    """
    source = with_format(source)
    kind = source.format
    if kind is not None and kind.expands_to == URDF.name:
        kind = SRDF if ENDING in source.name.lower() else URDF
        if kind == URDF and _is_semantic(source):
            return None
    return Description(source, kind) if kind in (SRDF, URDF) else None


def _is_semantic(source: SourceText) -> bool:
    """Tell whether *source* has elements of SRDF, and none that a link or joint of a URDF has."""
    found = _SEMANTIC.search(source.text) is not None
    return found and _PHYSICAL.search(XML_COMMENT.sub("", source.text)) is None


def may_be_srdf(source: SourceText) -> bool:
    """Tell whether *source* is an SRDF, or may expand to one."""
    return with_format(source).format == SRDF or ENDING in source.name
