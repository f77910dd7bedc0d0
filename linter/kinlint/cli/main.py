"""The command `kinlint`: picks the subcommand and turns every failure into a line and a code.

This module is imported on every run, so it imports next to nothing.
"""

from __future__ import annotations

import errno
import gc
import os
import sys
from collections.abc import Sequence

from kinlint import __version__

ABNORMAL = 2
INTERRUPTED = 130
BROKEN_PIPE = 141
UNWRITABLE = frozenset({errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EIO, errno.EROFS})
"""Errors of the system that are no fault of kinlint: a full disk, a quota, a broken device."""
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
    if sys.stdout is None or sys.stderr is None:
        # The shell closed them (`>&-`); what is written there is lost.
        sys.stdout, sys.stderr = (
            stream or open(os.devnull, "w", encoding="utf-8")  # noqa: PTH123, SIM115
            for stream in (sys.stdout, sys.stderr)
        )
    for stream in (sys.stdout, sys.stderr):
        if reconfigure := getattr(stream, "reconfigure", None):
            reconfigure(errors="backslashreplace")
    if argv is None:
        # Nearly all that a run allocates stays in use, so looking for garbage often is in vain.
        gc.set_threshold(GARBAGE)
    try:
        code = _run(arguments)
        code = code if _flushed() else ABNORMAL
        if argv is None:
            # The process ends here; the interpreter would search all it holds for garbage first.
            gc.freeze()
    except KeyboardInterrupt:
        return INTERRUPTED
    except BrokenPipeError:
        _discard_output()
        return BROKEN_PIPE
    return code


def _flushed() -> bool:
    """Write the rest of standard output; say why it cannot be written, and return False."""
    try:
        sys.stdout.flush()
    except BrokenPipeError:
        raise
    except OSError as error:
        _discard_output()
        _say(f"cannot write to standard output: {error.strerror or error}")
        return False
    return True


def _discard_output() -> None:
    """Have standard output, which the interpreter flushes at its end, go nowhere."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


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
        if isinstance(error, OSError) and error.errno in UNWRITABLE:
            _discard_output()
            where = f"{error.filename}: " if error.filename else ""
            _say(f"cannot write: {where}{error.strerror}")
            return ABNORMAL
        text = " ".join(f"{type(error).__name__}: {error}".split())
        _say(f"{text} (an error in kinlint itself: please report it with the command you ran)")
    return ABNORMAL


def _say(message: str) -> None:
    sys.stderr.write(f"kinlint: error: {message}\n")
