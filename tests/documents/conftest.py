"""A directory with all that the documents speak of, by the names they use."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from fenced import ROOT, blocks

NAMED = {
    "arm.jsonld": "samples/six-axis/arm.jsonld",
    "old.jsonld": "samples/six-axis/arm.jsonld",
    "robot.jsonld": "samples/six-axis/arm.jsonld",
    "gripper.jsonld": "samples/gripper/skeleton.jsonld",
    "old.urdf": "samples/urdf/six-axis.urdf",
    "robot.urdf": "samples/urdf/six-axis.urdf",
    "robot.srdf": "samples/urdf/six-axis.srdf",
    "my-shapes.ttl": "samples/shapes/position-reference.ttl",
}
"""What documents call something that a reader has, and what stands for it here."""

XACRO = """\
<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="prefix" default=""/>
  <link name="$(arg prefix)base"/>
</robot>
"""


@pytest.fixture(scope="session")
def project(tmp_path_factory):
    """The project as a reader has it, in a repository, with files by the names in documents."""
    place = tmp_path_factory.mktemp("project")
    for name in ("samples", "rules", "shapes"):
        shutil.copytree(ROOT / name, place / name)
    for name, sample in NAMED.items():
        shutil.copyfile(ROOT / sample, place / name)
    (place / "robot.urdf.xacro").write_text(XACRO, "utf-8")
    (place / "kinlint.toml").write_text('exclude = ["samples", "rules", "shapes"]\n', "utf-8")
    (place / "kinlint-baseline.json").write_text('{"version": 1, "findings": []}\n', "utf-8")
    rules = place / "my-rules"
    rules.mkdir()
    own = blocks("CONTRIBUTING.md", language="turtle")[0]
    (rules / "space-in-identifier.ttl").write_text(own.text, "utf-8")
    if shutil.which("git"):
        identity = ("-c", "user.name=kinlint", "-c", "user.email=kinlint@example.org")
        for words in (
            ("init", "-q", "-b", "main"),
            ("add", "."),
            (*identity, "commit", "-qm", "-"),
        ):
            subprocess.run(["git", *words], cwd=place, check=True)
    return place


@pytest.fixture
def shell(project, tmp_path, rules_cache, monkeypatch):
    """Runs a line in a shell, in a copy of the project: the finished process."""
    copy = tmp_path / "project"
    shutil.copytree(project, copy)
    binaries = Path(sys.executable).parent
    environment = {
        **{name: value for name, value in os.environ.items() if not name.startswith("GIT_")},
        "PATH": f"{binaries}{os.pathsep}{os.environ['PATH']}",
        "KINLINT_CACHE_DIR": str(rules_cache),
        "COLUMNS": "80",
        "HOME": str(copy),
    }

    def run(line):
        return subprocess.run(
            ["bash", "-c", line],
            cwd=copy,
            env=environment,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            timeout=300,
            check=False,
        )

    return run
