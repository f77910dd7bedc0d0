"""A run loads what it needs: the costs of a start are imports."""

import json
import subprocess
import sys

import pytest

LISTED = """
import json, sys
from kinlint.cli.main import main
code = main(sys.argv[1:])
json.dump([code, sorted(sys.modules)], sys.stderr)
"""
URDF = """<robot name="arm">
  <link name="base"/>
  <link name="tip"/>
  <joint name="wrist" type="fixed"><parent link="base"/><child link="tip"/></joint>
</robot>
"""
NEVER = {
    "asyncio", "dataclasses", "email", "http", "importlib.metadata", "inspect", "logging",
    "lsprotocol", "multiprocessing", "owlrl", "pickle", "pxr", "pygls", "pyld", "pyshacl", "rdflib",
    "rich", "sqlite3", "tomllib", "unittest", "xacro", "yaml",
}  # fmt: skip
"""Modules that no run on a URDF loads."""
KINLINT = {
    "baseline", "cli.early_output", "cli.xacro_arguments", "conversion",
    "engine.compiler.shapes_compiler",
    "engine.provenance", "engine.reference", "files.gitignore", "findings.finding_builder",
    "findings.locator", "fixes", "formats.collada.reader",
    "formats.jsonld.reader", "formats.mjcf.reader", "formats.sdf.reader", "formats.turtle.reader",
    "formats.usd.reader", "formats.xacro.reader", "ignoring", "navigation",
    "parallel.processes", "reporters.html", "reporters.picture", "reporters.sarif",
    "rule_formatting", "rule_testing", "server", "targets",
}  # fmt: skip
"""Packages and modules of kinlint that a run on a URDF without findings does not load."""
LIGHT = {
    "pyoxigraph", "tempfile", "threading",
    *(f"kinlint.{name}" for name in ("engine.store", "facts", "findings.locator", "pipeline")),
}  # fmt: skip
"""Modules that a run which recalls its report does not load."""
MOST, MOST_RECALLED = 270, 140
"""So many modules of kinlint may be loaded, two of each format: its package and its record."""


@pytest.fixture
def loaded(tmp_path, monkeypatch, rules_cache):
    """The modules that a process with these arguments loads."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "arm.urdf").write_text(URDF)

    def run(*arguments):
        command = [sys.executable, "-c", LISTED, "arm.urdf", *arguments]
        done = subprocess.run(command, capture_output=True, text=True, check=True)
        code, modules = json.loads(done.stderr)
        assert code == 0, done.stdout
        return set(modules)

    return run


def below(names, modules):
    """Return those of *modules* that are, or are in, one of *names*."""
    return {
        each
        for each in modules
        if any(each == name or each.startswith(f"{name}.") for name in names)
    }


def own(modules):
    return {each for each in modules if each.startswith("kinlint.")}


@pytest.mark.slow
def test_a_run_without_findings_loads_no_more_than_it_needs(loaded):
    modules = loaded("--isolated")
    assert below(NEVER, modules) == set()
    assert below({f"kinlint.{name}" for name in KINLINT}, modules) == set()
    assert len(own(modules)) <= MOST


@pytest.mark.slow
def test_a_recalled_report_needs_no_engine(loaded, tmp_path, rules_cache):
    cache = tmp_path / "cache"
    cache.mkdir()
    for file in rules_cache.glob("catalogue-*"):
        (cache / file.name).hardlink_to(file)
    first = loaded("--isolated", "--cache-dir", str(cache))
    recalled = loaded("--isolated", "--cache-dir", str(cache))
    assert below(LIGHT, first)
    assert below(LIGHT | NEVER, recalled) == set()
    assert len(own(recalled)) <= MOST_RECALLED
