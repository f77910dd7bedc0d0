"""As much of a GitHub runner as the steps of our action need."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import yaml

ROOT = Path(__file__).resolve().parents[2]
ACTION = yaml.safe_load((ROOT / "action.yml").read_text("utf-8"))
EXPRESSION = re.compile(r"\$\{\{\s*([\w.-]+)\s*\}\}")
KINLINT = f"""#!/bin/sh
exec '{sys.executable}' -m kinlint "$@"
"""


class Runner:
    """Runs the steps of the action that are scripts, in bash, as the runner would."""

    def __init__(self, directory, cache):
        self.workspace = directory / "work space"
        self.temporary = directory / "temporary files"
        self.summary = directory / "summary.md"
        self.bin = directory / "bin"
        for each in (self.workspace, self.temporary, self.bin):
            each.mkdir()
        self.install("kinlint", KINLINT)
        self.environment = {
            "PATH": f"{self.bin}:{os.environ['PATH']}",
            "PYTHONPATH": os.pathsep.join(sys.path),
            "KINLINT_CACHE_DIR": str(cache),
            "GITHUB_ACTIONS": "true",
            "GITHUB_ACTION_PATH": str(ROOT),
            "GITHUB_WORKSPACE": str(self.workspace),
            "GITHUB_STEP_SUMMARY": str(self.summary),
            "RUNNER_TEMP": str(self.temporary),
        }
        self.log = ""

    def install(self, name, text):
        """Put the script *text* on the PATH."""
        (self.bin / name).write_text(text, "utf-8")
        (self.bin / name).chmod(0o755)

    def run(self, **inputs):
        """The exit code and the outputs of the action; what the steps print is in `log`."""
        given = {name: str(one["default"]) for name, one in ACTION["inputs"].items()}
        given |= {name.replace("_", "-"): value for name, value in inputs.items()}
        self.log = ""
        outputs, code = {}, 0
        for step in ACTION["runs"]["steps"]:
            if "run" not in step or code:
                continue
            known = {f"inputs.{name}": value for name, value in given.items()}
            known |= {
                f"steps.{name}.outputs.{key}": value
                for name, said in outputs.items()
                for key, value in said.items()
            }
            code, outputs[step["id"]] = self._step(step, known)
        known = {
            f"steps.{n}.outputs.{k}": v for n, said in outputs.items() for k, v in said.items()
        }
        return code, {name: filled(one["value"], known) for name, one in ACTION["outputs"].items()}

    def _step(self, step, known):
        file = self.temporary.parent / "output"
        file.write_text("", "utf-8")
        script = self.temporary.parent / "script.sh"
        script.write_text(step["run"], "utf-8")
        own = {name: filled(value, known) for name, value in step.get("env", {}).items()}
        done = subprocess.run(
            [shutil.which("bash"), "--noprofile", "--norc", "-eo", "pipefail", str(script)],
            cwd=self.workspace,
            env={**self.environment, **own, "GITHUB_OUTPUT": str(file)},
            capture_output=True,
            text=True,
            check=False,
            timeout=300,
        )
        self.log += done.stdout + done.stderr
        lines = file.read_text("utf-8").splitlines()
        return done.returncode, dict(line.split("=", 1) for line in lines)


def filled(text, known):
    """*text* with its expressions evaluated; what nobody said is empty."""
    return EXPRESSION.sub(lambda found: known.get(found[1], ""), text)
