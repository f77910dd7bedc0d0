"""The image for CI without Python: its instructions are followed in an empty environment."""

import json
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

TOP = Path(__file__).parents[2]
LINES = (TOP / "linter" / "Dockerfile").read_text("utf-8").splitlines()


def arguments(instruction, beginning=""):
    """What follows the only such instruction."""
    (found,) = [
        rest
        for line in LINES
        if (rest := line.removeprefix(f"{instruction} ")) != line and rest.startswith(beginning)
    ]
    return found


@pytest.mark.slow
@pytest.mark.external
def test_what_the_image_installs_runs(tmp_path):
    """Pip installs the checkout below a prefix, which is laid over the prefix of Python."""
    source, prefix, python = (tmp_path / each for each in ("source", "prefix", "python"))
    assert arguments("COPY", ". ") == ". /source"
    left_out = shutil.ignore_patterns(".git", ".venv", "node_modules", "__pycache__", "build")
    shutil.copytree(TOP, source, ignore=left_out)
    subprocess.run([sys.executable, "-m", "venv", python], check=True)
    command = re.sub(r"/kinlint\b", str(prefix), arguments("RUN", "pip "), count=1)
    pip, *words = shlex.split(re.sub(r" /source\b", f" {source}", command))
    installed = subprocess.run(
        [python / "bin" / pip, *words], capture_output=True, text=True, check=False
    )
    if "No matching distribution" in installed.stderr:
        pytest.skip("the packages cannot be had")
    assert installed.returncode == 0, installed.stderr
    assert arguments("COPY", "--from") == "--from=build /kinlint /usr/local"
    shutil.copytree(prefix, python, dirs_exist_ok=True)
    (program,) = json.loads(arguments("ENTRYPOINT"))
    run = subprocess.run(
        [python / "bin" / program, "demo"],
        cwd=tmp_path,
        env={"PATH": str(python / "bin"), "HOME": str(tmp_path)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert "TOP001" in run.stdout
    assert run.stderr == ""
