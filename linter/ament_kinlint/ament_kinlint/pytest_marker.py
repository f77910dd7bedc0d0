"""Plug-in of pytest: declares the markers `linter` and `kinlint`, as linters of ament do."""

from __future__ import annotations

from typing import Any


def pytest_configure(config: Any) -> None:
    """Declare the markers."""
    config.addinivalue_line("markers", "linter: marks tests that run a linter")
    config.addinivalue_line("markers", "kinlint: marks tests that check robot descriptions")
