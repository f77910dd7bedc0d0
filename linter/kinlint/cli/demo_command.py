"""`kinlint demo`: lints a robot with three faults, and explains what it shows."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from contextlib import chdir
from pathlib import Path
from tempfile import TemporaryDirectory

from kinlint.cli import check_command
from kinlint.cli.argument_parser import Parser, add_color
from kinlint.cli.check_options import STDOUT, add_output_file
from kinlint.errors import UsageError

ROBOT = Path(__file__).parent / "demo" / "arm.urdf"
"""The robot, which comes with the package."""
BEFORE = """\
An arm of three links, arm.urdf, has three faults. This is `kinlint arm.urdf`:

"""
AFTER = """
How to read it:

  error[LIM001]      the severity and the code of the rule; `kinlint rule LIM001` explains it
  --> arm.urdf:18:19 file, line and column, which editors and CI systems link to
  [AP3, AP5]         the anti-patterns of robot models that lead to such faults (rules/README.md)
  ^^^^               the value that is wrong, with related places below it
  because:           the arithmetic or the statements that the finding follows from
  help: ... [*!]     a fix, tried on a copy of the file; [*] is safe, [*!] takes a decision

Try it:

  kinlint demo -o arm.urdf               writes the robot
  kinlint arm.urdf --fix --unsafe-fixes  makes the fixes
  kinlint graph arm.urdf                 draws its links and joints
  kinlint --output-format html arm.urdf > arm.html
  kinlint init                           sets up a project
"""


def parser() -> Parser:
    """The parser of `kinlint demo`."""
    made = Parser(
        prog="kinlint demo",
        description="Lint a robot with three faults, and explain what is shown.",
        epilog="Exit code: 0.",
    )
    add_output_file(made, way="write the robot to FILE, and lint nothing")
    add_color(made.add_argument)
    return made


def run(arguments: Sequence[str]) -> int:
    """Show the findings about the robot, or write it; the exit code."""
    options = parser().read(arguments)
    text = ROBOT.read_text("utf-8")
    if options.output_file != STDOUT:
        _write(Path(options.output_file), text)
        return 0

    sys.stdout.write(BEFORE)
    sys.stdout.flush()
    with TemporaryDirectory() as home, chdir(home):
        _write(Path(ROBOT.name), text)
        check_command.run([ROBOT.name, "--isolated", "--no-cache", "--color", options.color])
    sys.stdout.write(AFTER)
    return 0


def _write(path: Path, text: str) -> None:
    """Write *text* to the new file at *path*."""
    try:
        with path.open("x", encoding="utf-8", newline="\n") as stream:
            stream.write(text)
    except FileExistsError:
        raise UsageError(f"-o: {path} is there already") from None
    except OSError as error:
        raise UsageError(f"cannot write {path}: {error.strerror or error}") from None
