"""The command `ament_kinlint`, with the options that all linters of ament have."""

from __future__ import annotations

import argparse
import shutil
import subprocess
import sys
from collections.abc import Sequence


def command(paths: Sequence[str], *more: str) -> list[str]:
    """Return the words that run kinlint on *paths*, with *more* options."""
    program = shutil.which("kinlint")
    first = [sys.executable, "-m", "kinlint"] if program is None else [program]
    return [*first, "check", "--output-format", "concise", *more, "--", *paths]


def main(argv: Sequence[str] | None = None) -> int:
    """Check the paths that *argv* names; return 0 if there are no findings, as ament expects."""
    parser = argparse.ArgumentParser(
        prog="ament_kinlint", description="Check robot descriptions with kinlint."
    )
    parser.add_argument("paths", nargs="*", default=["."], help="files and directories")
    parser.add_argument("--xunit-file", metavar="FILE", help="write a test result there")
    parser.add_argument("--fail-on", metavar="SEVERITY", help="error, warning, info or none")
    parser.add_argument("--config", metavar="FILE", help="configuration file of kinlint")
    said = parser.parse_args(argv)
    more = [] if said.xunit_file is None else [f"--junit-output={said.xunit_file}"]
    more += [] if said.fail_on is None else [f"--fail-on={said.fail_on}"]
    more += [] if said.config is None else [f"--config={said.config}"]
    words = command(said.paths, *more)
    return subprocess.run(words, check=False).returncode  # noqa: S603  options end before paths
