"""Puts tests/ on the import path, so that tests find what they share (data.py).

The catalogue is compiled once for all processes of a run, as a wheel brings it: each test that
loads it, or starts a process that does, would else spend most of its time on that.
"""

import json
import os
import shutil
import tempfile
from contextlib import suppress
from pathlib import Path

import pytest

from kinlint.catalogue import rulebook
from kinlint.engine.compiler import author

COMPILED = "KINLINT_TESTS_CATALOGUE"

TOGETHER = {
    "tests/ci/test_pre_commit.py": "an environment of pre-commit",
    "tests/facts/test_because.py": "faults",
    "tests/fixes/test_real_fixes.py": "fixes for public robots",
    "tests/lifting/test_pinocchio.py": "Pinocchio",
    "tests/messages/test_messages.py": "messages",
    "tests/test_real_models.py": "published models",
    "tests/test_real_robots.py": "public robots",
    "tests/test_rulebook.py": "rulebook",
    "tests/test_sdf_verdicts.py": "public robots",
    "tests/test_vendor.py": "vendor",
}
"""Files whose tests share what takes long to compute, with what that is."""


def pytest_configure(config):
    if rulebook.SHIPPED.is_dir():
        return
    if COMPILED not in os.environ:
        made = os.environ[COMPILED] = tempfile.mkdtemp(prefix="kinlint-catalogue-")
        config.add_cleanup(lambda: shutil.rmtree(made, ignore_errors=True))
        config.add_cleanup(lambda: os.environ.pop(COMPILED))
    here = Path(os.environ[COMPILED])
    known = _remembered(here / "vouched.json")
    if not hasattr(config, "workerinput"):
        rulebook.load(cache=here)
        if known:
            (here / "vouched.json").write_text(json.dumps(sorted(known)), "utf-8")
    rulebook.SHIPPED = here


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config, log):
    """Tests that share something long run in one process, and first; the others wherever."""
    from xdist.scheduler import LoadScopeScheduling  # noqa: PLC0415

    class Shared(LoadScopeScheduling):
        def _split_scope(self, nodeid):
            return TOGETHER.get(nodeid.partition("::")[0], nodeid)

    return Shared(config, log)


def _remembered(file):
    """The queries of the catalogue that rdflib takes for SPARQL, said once for all processes.

    Returned are those that it is asked about from now on, and that *file* does not have.
    """
    said = set(json.loads(file.read_text("utf-8"))) if file.exists() else set()
    new, ask = set(), author._problem

    def problem(known, text):
        if known + text in said:
            return ""
        answer = ask(known, text)
        if not answer:
            new.add(known + text)
        return answer

    author._problem = problem
    return new


@pytest.fixture
def rules_cache(tmp_path_factory, monkeypatch):
    """The cache of compiled rules for processes and runs of the command: it has the catalogue.

    What is compiled of other rules is kept there too, and may push the catalogue out.
    """
    cache = Path(os.environ.get(COMPILED, tmp_path_factory.getbasetemp()), "cache")
    cache.mkdir(exist_ok=True)
    # No directory can be made there: reports are not kept, so that each run is a run.
    (cache / "reports").touch()
    if COMPILED in os.environ:
        for file in rulebook.SHIPPED.glob("catalogue-*.json"):
            with suppress(FileExistsError):
                (cache / file.name).hardlink_to(file)
            os.utime(file)
    monkeypatch.setenv("KINLINT_CACHE_DIR", str(cache))
    return cache
