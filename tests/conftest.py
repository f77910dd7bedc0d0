"""Puts tests/ on the import path, so that tests find what they share (data.py).

The catalogue is compiled once for all processes of a run, as a wheel brings it: each test that
loads it would else spend most of its time on that.
"""

import os
import tempfile
from pathlib import Path

from kinlint import rulebook

COMPILED = "KINLINT_TESTS_CATALOGUE"


def pytest_configure():
    if rulebook.SHIPPED.is_dir():
        return
    if COMPILED not in os.environ:
        os.environ[COMPILED] = tempfile.mkdtemp(prefix="kinlint-catalogue-")
        rulebook.load(cache=Path(os.environ[COMPILED]))
    rulebook.SHIPPED = Path(os.environ[COMPILED])
