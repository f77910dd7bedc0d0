"""The command `kinlint`: picks the subcommand and turns every failure into a line and a code.

This module is imported on every run, so it imports next to nothing.
"""

from __future__ import annotations

import gc
import os
import sys
from collections.abc import Sequence

from kinlint import __version__

ABNORMAL = 2
INTERRUPTED = 130
BROKEN_PIPE = 141
GARBAGE = 100_000
"""Number of new objects that triggers the garbage collector."""


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command with *argv* and give its exit code.

    0: clean. 1: findings at or above `--fail-on`. 2: anything else. 130 and 141: interrupted, and
    nobody reads the output, as shells number these.
    """
    arguments = list(sys.argv[1:] if argv is None else argv)
    if arguments in (["--version"], ["-V"], ["version"]):
        sys.stdout.write(f"kinlint {__version__}\n")
        return 0
    for stream in (sys.stdout, sys.stderr):
        if reconfigure := getattr(stream, "reconfigure", None):
            reconfigure(errors="backslashreplace")
    if argv is None:
        # Nearly all that a run allocates stays in use, so looking for garbage often is in vain.
        gc.set_threshold(GARBAGE)
    try:
        code = _run(arguments)
        sys.stdout.flush()
        if argv is None:
            # The process ends here; the interpreter would search all it holds for garbage first.
            gc.freeze()
    except KeyboardInterrupt:
        return INTERRUPTED
    except BrokenPipeError:
        # The interpreter flushes standard output once more at its end; give it somewhere to go.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return BROKEN_PIPE
    return code


def _run(arguments: list[str]) -> int:
    from kinlint.cli.commands import run  # noqa: PLC0415
    from kinlint.errors import KinlintError  # noqa: PLC0415

    try:
        return run(arguments)
    except KinlintError as error:
        _say(str(error))
    except (KeyboardInterrupt, BrokenPipeError):
        raise
    except MemoryError:
        _say("out of memory")
    except Exception as error:
        if os.environ.get("KINLINT_TRACEBACK") == "1":
            raise
        from kinlint.files.pathname import has_working_directory  # noqa: PLC0415  of errors alone

        if isinstance(error, FileNotFoundError) and not has_working_directory():
            _say("the working directory does not exist any more")
            return ABNORMAL
        text = " ".join(f"{type(error).__name__}: {error}".split())
        _say(f"{text} (an error in kinlint itself: please report it with the command you ran)")
    return ABNORMAL


def _say(message: str) -> None:
    sys.stderr.write(f"kinlint: error: {message}\n")
