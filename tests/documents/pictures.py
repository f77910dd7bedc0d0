"""Pictures of the documents: what the terminal and the HTML report show of the demo.

`python tests/documents/pictures.py` makes them anew, beside the robot that they show. That of the
report needs Chromium, and bears the digest of what it was made from.
"""

from __future__ import annotations

import hashlib
import io
import os
import re
import shutil
import struct
import subprocess
import sys
import zlib
from pathlib import Path
from tempfile import TemporaryDirectory

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
    """Return the HTML report about the robot."""
    return kinlint(ROBOT, "--isolated", "--output-format", "html")


def report_digest(page: str) -> str:
    """Return the digest of what a picture of the top of *page* shows: style, script and robots."""
    shown = re.sub(r'content="kinlint [^"]*"', "", page.partition('<section id="counts"')[0])
    script = page.rpartition("<script>")[2].partition("</script>")[0]
    return hashlib.sha256(f"{shown}{script}".encode()).hexdigest()


def photograph(page: str, browser: str) -> bytes:
    """Return the top of *page* as *browser* shows it, as PNG with the digest in it."""
    with TemporaryDirectory() as home:
        file, shot = Path(home, "report.html"), Path(home, "report.png")
        file.write_text(page, "utf-8")
        subprocess.run(
            [
                *(browser, "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars"),
                *(f"--user-data-dir={home}/profile", "--virtual-time-budget=3000"),
                *("--force-device-scale-factor=1.5", f"--window-size={WINDOW}"),
                *(f"--screenshot={shot}", file.as_uri()),
            ],
            capture_output=True,
            check=True,
        )
        return with_digest(shot.read_bytes(), report_digest(page))


def with_digest(png: bytes, digest: str) -> bytes:
    """Return *png* with *digest* as a text chunk behind its header."""
    chunk = b"tEXt" + KEYWORD + b"\0" + digest.encode("ascii")
    size, check = struct.pack(">I", len(chunk) - 4), struct.pack(">I", zlib.crc32(chunk))
    return png[:HEADER] + size + chunk + check + png[HEADER:]


def digest_of(png: bytes) -> str:
    """Return the digest that `with_digest` put into *png*; empty if there is none."""
    found = re.match(rb"....tEXt" + KEYWORD + rb"\0([0-9a-f]{64})", png[HEADER:], re.DOTALL)
    return found[1].decode("ascii") if found else ""


KEYWORD = b"Digest of report"
HEADER = 33
"""Number of bytes of the signature and the first chunk of a PNG."""
WINDOW = "1180,870"
"""Width and height in pixels of the browser."""
BROWSERS = ("chromium", "chromium-browser", "google-chrome")
TERMINAL, REPORT = HOME / "terminal.svg", HOME / "report.png"
"""The pictures, beside the robot."""


if __name__ == "__main__":
    TERMINAL.write_text(terminal(), "utf-8", newline="\n")
    chromium = next(filter(None, map(shutil.which, BROWSERS)), None)
    if chromium is None:
        sys.exit(f"{REPORT.name} needs one of these on the path: {', '.join(BROWSERS)}")
    REPORT.write_bytes(photograph(report(), chromium))
