"""Puts tests/ on the import path, so that tests find what they share (data.py).

The catalogue is compiled once for all processes of a run, as a wheel brings it: each test that
loads it, or starts a process that does, would else spend most of its time on that.
"""

import gc
import os
import shutil
import sys
import tempfile
from contextlib import suppress
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

from kinlint.catalogue import rulebook

# How long an example takes says nothing on a machine with other work. CI draws the same examples
# each time; `--hypothesis-profile thorough` draws many more, for a change that is risky.
settings.register_profile(
    "default", deadline=None, max_examples=20, suppress_health_check=[HealthCheck.too_slow]
)
settings.register_profile("ci", settings.get_profile("default"), derandomize=True)
settings.register_profile("thorough", settings.get_profile("default"), max_examples=1_000)
settings.load_profile("ci" if os.environ.get("CI") else "default")

# What tests share stays: modules, catalogues, and what they compile of queries.
gc.set_threshold(50_000)

# Tests start hundreds of processes: what one of them compiles of Python, the others load.
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
sys.dont_write_bytecode = False


def pytest_configure(config):
    """Keep the compiled catalogue from run to run, for all processes of a run."""
    if rulebook.SHIPPED.is_dir():
        return
    if hasattr(config, "cache"):
        here = config.cache.mkdir("kinlint-catalogue")
    else:
        here = Path(tempfile.mkdtemp(prefix="kinlint-catalogue-"))
        config.add_cleanup(lambda: shutil.rmtree(here, ignore_errors=True))
    if not hasattr(config, "workerinput") or not hasattr(config, "cache"):
        rulebook.load(cache=here)
    rulebook.SHIPPED = here


def pytest_make_parametrize_id(val):
    """Shorten names of tests after long texts: they go from process to process, and to logs."""
    return f"{val[:40]!a}-{len(val)}" if isinstance(val, str | bytes) and len(val) > 400 else None


def pytest_terminal_summary(terminalreporter, config):
    """Tell how to run what the tiers left out, where that is all there is."""
    if config.option.collectonly:
        return
    if terminalreporter.stats.keys() - {""} == {"deselected"}:
        terminalreporter.write_line("All of these tests are of the slower tiers: add -m ''.")


@pytest.fixture
def rules_cache(tmp_path_factory, monkeypatch):
    """The cache of compiled rules for processes and runs of the command: it has the catalogue.

    What is compiled of other rules is kept there too, and may push the catalogue out.
    """
    cache = tmp_path_factory.getbasetemp() / "cache"
    cache.mkdir(exist_ok=True)
    # No directory can be made there: reports are not kept, so that each run is a run.
    (cache / "reports").touch()
    for file in rulebook.SHIPPED.glob("catalogue-*.jsonl"):
        with suppress(FileExistsError):
            (cache / file.name).hardlink_to(file)
    monkeypatch.setenv("KINLINT_CACHE_DIR", str(cache))
    return cache
