"""What a project's own configuration may bring to a run, and what a run says of it."""

from __future__ import annotations

import pytest

from kinlint.server.client_settings import ClientSettings

RULE = """
@prefix geom: <https://comp-rob2b.github.io/metamodels/geometry/structural-entities#> .
@prefix sh: <http://www.w3.org/ns/shacl#> .
<https://example.org/S> a sh:NodeShape ; sh:targetClass geom:RigidBody ; sh:nodeKind sh:Literal .
"""
XMLNS = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
XACRO = f'<robot name="a" {XMLNS}><link name="$(optenv TOKEN x)"/></robot>'


@pytest.fixture
def project(write, monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    monkeypatch.setenv("TOKEN", "hunter2")
    write("arm.xacro", XACRO)
    write("own.ttl", RULE)
    write("kinlint.toml", 'shapes = ["own.ttl"]\nxacro-env = ["TOKEN"]\n')


def test_shapes_and_variables_are_left_out(project, kinlint):
    code, out, err = kinlint("arm.xacro", "--output-format", "json")
    assert "kinlint.toml: shapes and xacro-env left out" in err
    assert "hunter2" not in out + err
    assert "SHACL" not in out
    assert '"SRC022"' in out
    assert code == 0


@pytest.mark.slow
def test_with_trust_they_count(project, kinlint):
    code, out, err = kinlint("arm.xacro", "--output-format", "json", "--trust")
    assert "left out" not in err
    assert "hunter2" in out
    assert "SHACL" in out
    assert code == 1


@pytest.mark.slow
def test_a_named_configuration_counts(project, kinlint):
    code, out, err = kinlint("arm.xacro", "--output-format", "json", "--config", "kinlint.toml")
    assert "left out" not in err
    assert "SHACL" in out
    assert code == 1


def test_a_silent_run_says_nothing_of_it(project, kinlint):
    assert kinlint("arm.xacro", "--silent")[2] == ""


@pytest.mark.parametrize("trust", [True, False])
def test_an_editor_says_whether_projects_are_trusted(project, here, trust):
    config = ClientSettings.from_json({"trust": trust}).configs(here).nearest(here)
    assert config.untrusted == (() if trust else ("shapes", "xacro_env"))
