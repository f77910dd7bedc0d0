"""Every command that a document shows runs, and prints what the document shows below it."""

import re
import shlex
import shutil

import pytest
from fenced import blocks, mentioned

from kinlint.cli.check_options import parser
from kinlint.cli.commands import COMMANDS

pytestmark = pytest.mark.slow

SHELL = blocks(language="sh")
SHOWN = [block for block in blocks(language="text") if block.before in SHELL]
ELSEWHERE = {"python3", "python", "pip", "pytest", "pyshacl", "make"}
"""What `test_installation` and other tests run."""
ADDING = "kinlint contexts add"
"""What changes a project, and may use the network; `tests/cli` runs it."""
STORED = "--endpoint"
"""What asks a triple store; `tests/endpoint` runs it."""
BUCKET = "://bucket/"
"""What reads a bucket; `tests/files/test_url_inputs.py` does."""
LASTING = {"--watch", "-w", "server"}
"""What runs until it is told to stop; `tests/cli` and `tests/server` do."""


def programs(line):
    """The programs that *line* runs."""
    return [shlex.split(part)[0] for part in re.split(r" \|\|? | && | ; ", line)]


def runs(line):
    """Whether *line* is a command that ends, and that no other test has to run."""
    return (
        not line.startswith(ADDING)
        and STORED not in line
        and BUCKET not in line
        and not LASTING & set(shlex.split(line))
        and not ELSEWHERE & set(programs(line))
    )


NAMED = {line for line in mentioned() if line.split()[1:] in [[name] for name in COMMANDS]}
"""What is said of a command by its name alone, which may need more to run."""
LINES = sorted({line for block in SHELL for line in block.commands} | {*mentioned()} - NAMED)


@pytest.mark.parametrize("line", [line for line in LINES if runs(line)])
def test_a_command_runs(line, shell):
    """It ends as one that found something, or nothing, to say."""
    for program in programs(line):
        if program != "kinlint" and shutil.which(program) is None:
            pytest.skip(f"{program} is not installed")

    done = shell(line)

    assert done.returncode in {0, 1}, done.stderr
    assert "error: " not in done.stderr.replace(": error: ", "")
    assert "Traceback" not in done.stderr


@pytest.mark.parametrize("line", sorted(NAMED))
def test_a_command_that_is_named_is_there(line, shell):
    """It tells what it is for."""
    done = shell(f"{line} --help")

    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith(f"usage: {line}")


@pytest.mark.parametrize("line", [line for line in LINES if programs(line)[0] == "kinlint"])
def test_the_options_of_a_command_are_there(line):
    """Of those that do not end, too."""
    words = shlex.split(line.partition(" | ")[0].partition(" < ")[0].partition(" > ")[0])[1:]
    if words == ["--help"] or (words[:1] and words[0] in COMMANDS):
        return
    assert parser().read(words)


@pytest.mark.parametrize("shown", SHOWN, ids=str)
def test_what_is_shown_below_a_command_is_printed(shown, shell):
    """Line by line, but for an ellipsis."""
    done = shell("\n".join(shown.before.commands))

    printed = [line.rstrip() for line in (done.stdout + done.stderr).splitlines()]
    for line in shown.text.splitlines():
        start, ellipsis, _ = line.rstrip().partition("...")
        assert any(each.startswith(start) if ellipsis else each == start for each in printed), line
