"""Pictures of the documents: what the terminal shows of the demo, and the robot of its report.

`python tests/documents/pictures.py` makes them anew, beside the robot that they show.
"""

from __future__ import annotations

import io
import os
import re
import subprocess
import sys
from pathlib import Path

from rich.console import Console
from rich.text import Text

ROOT = Path(__file__).parents[2]
HOME = ROOT / "linter/kinlint/cli/demo"
ROBOT = "arm.urdf"
COLUMNS = 100
FONT = re.compile(r"@font-face \{.*?\}\s*", re.DOTALL)
"""A font that the picture would load from elsewhere."""


def kinlint(*arguments: str) -> str:
    """Return what kinlint prints in the directory of the robot."""
    environment = {
        **os.environ,
        "PYTHONPATH": str(ROOT / "linter"),
        "COLUMNS": str(COLUMNS),
        "PYTHONIOENCODING": "utf-8",
    }
    for name in ("NO_COLOR", "FORCE_COLOR", "CLICOLOR_FORCE"):
        environment.pop(name, None)
    return subprocess.run(
        [sys.executable, "-m", "kinlint", *arguments],
        cwd=HOME,
        env=environment,
        capture_output=True,
        encoding="utf-8",
        check=False,
    ).stdout


def terminal() -> str:
    """Return the picture of a terminal that shows the findings about the robot."""
    shown = kinlint(ROBOT, "--isolated", "--color", "always")
    shown = re.sub(r"\x1b]8;.*?\x1b\\", "", shown)
    console = Console(record=True, width=COLUMNS, file=io.StringIO())
    console.print(Text.from_ansi(f"$ kinlint {ROBOT}\n{shown}"))
    drawn = console.export_svg(title=f"kinlint {ROBOT}", unique_id="kinlint")
    return "\n".join(line.rstrip() for line in FONT.sub("", drawn).splitlines()) + "\n"


def report() -> str:
    """Return the picture of the robot in the HTML report, with the findings on its parts."""
    return kinlint("graph", ROBOT, "--isolated", "--output-format", "svg")


PICTURES = {"terminal.svg": terminal, "report.svg": report}
"""The pictures, by the name of the file beside the robot."""


if __name__ == "__main__":
    for name, draw in PICTURES.items():
        (HOME / name).write_text(draw(), "utf-8", newline="\n")
