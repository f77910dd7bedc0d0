"""The representations of rotations that converted models can have."""

from __future__ import annotations

ROTATIONS = ("direction-cosines", "euler-angles", "quaternion")
"""Each by the update of `shapes/conversion/rotations` that makes it, the default first."""
