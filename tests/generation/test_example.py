"""The example of the README, from a model to a program that runs."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from programs import lines

pytest.importorskip("jinja2")
pytest.importorskip("numpy")
pytestmark = [pytest.mark.slow]

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "linter" / "kinlint" / "generation" / "README.md"


def test_the_example_runs(tmp_path, rules_cache):
    (tmp_path / "samples").symlink_to(ROOT / "samples")
    command = f'exec {sys.executable} -P -m kinlint "$@"\n'
    for name, text in (("kinlint", command), ("python", f'exec {sys.executable} "$@"\n')):
        (tmp_path / name).write_text(f"#!/bin/sh\n{text}")
        (tmp_path / name).chmod(0o755)
    path = os.pathsep.join((str(tmp_path), os.environ["PATH"]))
    environment = {**os.environ, "PATH": path, "PYTHONPATH": os.pathsep.join(sys.path)}
    (block,) = re.findall(r"^```sh\n(.*?)^```", PAGE.read_text("utf-8"), re.MULTILINE | re.DOTALL)
    poses = []
    for command in block.splitlines():
        kdl = "cmake" in command
        if kdl and not (shutil.which("cmake") and Path("/usr/include/kdl/tree.hpp").exists()):
            pytest.skip("builds with CMake and KDL, Debian's liborocos-kdl-dev")
        run = subprocess.run(
            ["sh", "-c", command],
            cwd=tmp_path,
            env=environment,
            capture_output=True,
            text=True,
            check=True,
        )
        poses.append(lines(run.stdout.splitlines()[-1])[0]["poses"])
    assert poses[0].keys() == poses[1].keys()
    for name in poses[0]:
        assert poses[1][name] == pytest.approx(poses[0][name], abs=1e-12)
