"""Finds rules/ and shapes/: in the package once installed, beside it in a checkout."""

from __future__ import annotations

from pathlib import Path
from typing import Literal


def data(name: Literal["rules", "shapes"]) -> Path:
    """Return the *name* directory of this installation."""
    package = Path(__file__).parent
    installed = package / name
    return installed if installed.is_dir() else package.parents[1] / name
