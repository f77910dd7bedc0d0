"""Finds the real models and test suites, which are no part of this project."""

from __future__ import annotations

import os
from pathlib import Path

import pytest


def locate_data(*parts: str) -> Path:
    """The path of *parts* in the data; the calling test is skipped where they are absent.

    Data lie where the environment's KINLINT_DATA says, or in shared/data beside the checkout.
    """
    beside = Path(__file__).resolve().parents[2] / "shared" / "data"
    path = Path(os.environ.get("KINLINT_DATA", beside)).joinpath(*parts)
    if not path.exists():
        pytest.skip(f"no data at {path}; set KINLINT_DATA to where they are")
    return path
