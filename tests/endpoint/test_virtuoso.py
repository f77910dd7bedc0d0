"""Virtuoso as a second store: what it finds is what files have, but for what it cannot do."""

import json
import shutil
from pathlib import Path

import pytest
from data import locate_data
from support.triple_store import virtuoso

from kinlint.cli.main import main
from kinlint.endpoint.connection import Endpoint
from kinlint.endpoint.stored_graphs import FILE
from kinlint.terms import literal_value

pytestmark = pytest.mark.external

COUNT = 40
"""Number of samples of a format."""
SUFFIXES = ("urdf", "sdf", "srdf", "xml", "xacro", "dae", "usda", "jsonld")
SAMPLES = Path(__file__).parents[2] / "samples"


@pytest.fixture(scope="module")
def address(tmp_path_factory):
    if shutil.which("virtuoso-t") is None or shutil.which("isql-vt") is None:
        pytest.skip("Virtuoso is not installed; Debian has it as virtuoso-opensource")
    with virtuoso(tmp_path_factory.mktemp("virtuoso")) as url:
        yield url


def _findings(capsys, *arguments):
    capsys.readouterr()
    main(["check", "--isolated", "-n", "--output-format=json-lines", *arguments])
    told = capsys.readouterr()
    assert "refuses" not in told.err
    lines = map(json.loads, told.out.splitlines())
    return sorted(json.dumps({**one, "fix": None, "fixes": []}, sort_keys=True) for one in lines)


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_findings_are_those_of_the_files(suffix, address, capsys, monkeypatch, rules_cache):
    monkeypatch.chdir(SAMPLES)
    every = sorted((SAMPLES / "broken").glob(f"*.{suffix}"))
    paths = [str(each.relative_to(SAMPLES)) for each in every[:COUNT]]
    load = ["load", "--isolated", "--endpoint", address]
    while main([*load, *paths]) != 0:
        told = capsys.readouterr().err  # of broken samples that cannot be read at all
        paths = [each for each in paths if f"error: {each}" not in told]
    names = [f"--graph=urn:kinlint:document:{each}" for each in paths]

    assert _findings(capsys, "--endpoint", address, *names) == _findings(capsys, *paths)


def test_public_robots_have_the_findings_of_the_files(address, capsys, rules_cache):
    """Robots that others made, with names and numbers of all kinds."""
    home = locate_data("robots")
    robots = (*home.rglob("*.urdf"), *home.rglob("*.sdf"))
    paths = list(map(str, sorted(robots, key=lambda one: one.stat().st_size)[: 5 * COUNT : 2]))
    assert main(["load", "--isolated", "--endpoint", address, *paths]) in {0, 2}
    names = [f"--graph=urn:kinlint:document:{each}" for each in _loaded(address, paths)]

    found = [each for each in _findings(capsys, *paths) if json.loads(each)["code"]]
    assert found
    assert _findings(capsys, "--endpoint", address, *names) == found


def _loaded(address, paths):
    rows = Endpoint(address, address).select(f"SELECT ?file {{ GRAPH ?g {{ ?g {FILE} ?file }} }}")
    return {literal_value(row["file"]) for row in rows}.intersection(paths)


def test_a_revision_tells_what_changed(address, capsys, tmp_path, monkeypatch, rules_cache):
    monkeypatch.chdir(tmp_path)
    for name in "ab":
        (tmp_path / f"{name}.urdf").write_text(f'<robot name="{name}"><link/></robot>')
    load = ["load", "--isolated", "--endpoint", address]
    main([*load, "a.urdf", "b.urdf"])
    before = capsys.readouterr().out.split()[-1].rstrip(".")
    main([*load, "b.urdf"])
    found = _findings(capsys, "--endpoint", address, "--since", before)

    assert found
    assert all('"b.urdf"' in each for each in found)
