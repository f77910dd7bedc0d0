"""The linter of ament runs kinlint, and its CMake macro adds the test that does."""

import importlib.util
import os
import shutil
import subprocess
import sys
import tomllib
from configparser import ConfigParser
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest

ROOT = Path(__file__).parents[2]
FOLDER = ROOT / "linter" / "ament_kinlint"
WRONG = """<robot name="arm"><link name="base"/><link name="tip"/>
<joint name="j" type="revolute"><parent link="base"/><child link="tip"/>
<axis xyz="0 0 1"/><limit lower="1" upper="0" effort="1" velocity="1"/></joint></robot>"""
STUBS = """
set(AMENT_TEST_RESULTS_DIR "/results")
set(PROJECT_NAME "arm_description")
function(ament_add_test)
  message(STATUS "TEST ${ARGN}")
endfunction()
function(set_tests_properties)
endfunction()
"""


def run(directory, *words):
    """Run `ament_kinlint` in *directory*."""
    path = os.pathsep.join([str(FOLDER), str(ROOT / "linter")])
    environment = {**os.environ, "PYTHONPATH": path, "PATH": os.defpath}
    return subprocess.run(
        [sys.executable, str(FOLDER / "bin" / "ament_kinlint"), *words],
        cwd=directory, env=environment, capture_output=True, text=True, check=False,
    )  # fmt: skip


@pytest.mark.slow
def test_findings_fail_and_are_written_as_xunit(tmp_path):
    """The exit code is 1 for findings at or above the severity, as ament expects."""
    (tmp_path / "arm.urdf").write_text(WRONG)
    done = run(tmp_path, "--xunit-file", "result.xml")
    assert done.returncode == 1
    assert "arm.urdf:3:34: error:" in done.stdout
    suites = ET.parse(tmp_path / "result.xml").getroot()  # noqa: S314
    assert int(suites.get("failures")) >= 1
    assert "LIM001" in (tmp_path / "result.xml").read_text("utf-8")
    assert run(tmp_path, "--fail-on", "none", "arm.urdf").returncode == 0


def cmake(tmp_path, *lines):
    """Run a script of CMake with what the macro needs; what it prints."""
    script = tmp_path / "script.cmake"
    script.write_text(STUBS + "\n".join(lines))
    path = f"{FOLDER / 'bin'}{os.pathsep}{os.environ['PATH']}"
    done = subprocess.run(
        ["cmake", "-P", script],
        cwd=tmp_path, env={**os.environ, "PATH": path}, capture_output=True, text=True, check=True,
    )  # fmt: skip
    return done.stdout


needs_cmake = pytest.mark.skipif(shutil.which("cmake") is None, reason="cmake is not installed")


@needs_cmake
def test_the_macro_adds_a_test(tmp_path):
    """With the result file that ament collects, and the options given."""
    include = f'include("{FOLDER / "cmake" / "ament_kinlint.cmake"}")'
    told = cmake(tmp_path, include, "ament_kinlint(MAX_SEVERITY error urdf)")
    result = "/results/arm_description/kinlint.xunit.xml"
    program = FOLDER / "bin" / "ament_kinlint"
    assert f"COMMAND;{program};--xunit-file;{result};--fail-on;error;urdf;" in told
    assert f"RESULT_FILE;{result};" in told
    assert "TEST robots;" in cmake(tmp_path, include, "ament_kinlint(TESTNAME robots)")


@needs_cmake
def test_the_hook_adds_it_where_there_is_a_robot(tmp_path):
    """As `ament_lint_auto` runs it."""
    lines = [f'include("{FOLDER / "cmake" / name}")' for name in
             ("ament_kinlint.cmake", "ament_kinlint_lint_hook.cmake")]  # fmt: skip
    assert "TEST" not in cmake(tmp_path, *lines)
    (tmp_path / "urdf").mkdir()
    (tmp_path / "urdf" / "arm.urdf.xacro").write_text(WRONG)
    assert "TEST kinlint;" in cmake(tmp_path, *lines)


def test_the_package_says_what_it_is():
    """Its name, and the version of kinlint; the plug-in for pytest is there."""
    manifest = ET.parse(FOLDER / "package.xml").getroot()  # noqa: S314
    assert manifest.findtext("name") == FOLDER.name
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))
    version = (ROOT / project["tool"]["hatch"]["version"]["path"]).read_text("utf-8")
    assert f'"{manifest.findtext("version")}"' in version
    config = ConfigParser()
    config.read(FOLDER / "setup.cfg")
    module = config["options.entry_points"]["pytest11"].split("=")[1].strip()
    assert (FOLDER / f"{module.replace('.', '/')}.py").is_file()


def test_the_marker_is_declared():
    """So that `--strict-markers` knows it."""
    spec = importlib.util.spec_from_file_location("m", FOLDER / FOLDER.name / "pytest_marker.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    told = []

    class Config:
        def addinivalue_line(self, name, line):
            told.append((name, line.partition(":")[0]))

    module.pytest_configure(Config())
    assert told == [("markers", "linter"), ("markers", "kinlint")]
