"""Shell completion: each shell is given a line to complete, as a user types it."""

import os
import pty
import re
import select
import shutil
import signal
import subprocess
import time
from pathlib import Path

import pytest

from kinlint.cli.completion.grammar import SHELLS, words
from kinlint.configuration.keys import KEYS, OUTPUT_FORMATS

pytestmark = pytest.mark.external

SOON = 60
STEERING = re.compile(r"\x1b\[[\d;?]*[A-Za-z]|\x1b[=>]|[\x07\r]")
LINES = {
    "kinlint --extend-sel": "--extend-select",
    "kinlint --select UNI00": "UNI001 UNI002",
    "kinlint --select LD001,unit-quan": "LD001,unit-quantity-mismatch",
    "kinlint check --ignore AP": "AP1 AP6",
    "kinlint --output-format json-": "json-lines",
    "kinlint --output-format=sar": "sarif",
    "kinlint graph --output-format mer": "mermaid",
    "kinlint rule inverted-l": "inverted-limit",
    "kinlint rule --output-format mark": "markdown",
    "kinlint conv": "convert",
    "kinlint config severi": "severity",
    "kinlint generate-shell-completion fi": "fish",
    "kinlint ./a rob": "robot",
    "kinlint -o ./a": "robot",
    "kinlint --cache-dir some": "some",
}
"""What is typed, and what at least is proposed."""

BASH = """
source kinlint.bash
complete -p kinlint >/dev/null || exit 1
COMP_LINE=$1
# As readline takes lines apart.
read -ra COMP_WORDS <<< "${COMP_LINE//=/ = }"
COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
_kinlint
printf '%s\\n' "${COMPREPLY[@]}"
"""


@pytest.fixture
def scripts(kinlint, here):
    """The scripts of all shells, beside a robot whose name has a space, and a directory."""
    for shell in SHELLS:
        code, out, err = kinlint("generate-shell-completion", shell)
        assert (code, err) == (0, "")
        (here / f"kinlint.{shell}").write_text(out)
    (here / "a robot.urdf").touch()
    (here / "some").mkdir()
    return here


def _need(shell):
    if shutil.which(shell) is None:
        pytest.skip(f"{shell} is not installed")


@pytest.mark.parametrize("line", LINES)
@pytest.mark.parametrize("shell", ["bash", "fish"])
def test_what_is_typed_is_completed(scripts, shell, line):
    """Options, commands, values, rules by code and by name, several of them, files."""
    _need(shell)
    expected = LINES[line]
    if shell == "bash":
        if "./a rob" in line:
            line = "kinlint ./a"
        command = ["bash", "--norc", "-c", BASH, "bash", line]
    else:
        line = line.replace("./a rob", r"./a\ rob")
        asked = f"source kinlint.fish; complete -C {_quoted(line)}"
        command = ["fish", "--no-config", "-c", asked]
    done = subprocess.run(
        command, capture_output=True, text=True, timeout=SOON, env=_environment(), check=False
    )
    assert done.returncode == 0
    assert done.stderr == ""
    for each in expected.split():
        assert each in done.stdout


def _quoted(text):
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'"


def _environment():
    return {**os.environ, "TERM": "xterm", "HOME": str(Path.cwd()), "LC_ALL": "C.UTF-8"}


STARTS = {
    "bash": (["bash", "--norc", "-i"], "source kinlint.bash; PS1='rea''dy> '"),
    "zsh": (
        ["zsh", "-f", "-i"],
        "PS1='rea''dy> '; autoload -Uz compinit; compinit -u -D; source kinlint.zsh",
    ),
}
TYPED = {
    "kinlint --extend-sel": "--extend-select",
    "kinlint --select LD001,unit-quan": "LD001,unit-quantity-mismatch",
    "kinlint --output-format=json-": "--output-format=json-lines",
    "kinlint graph --output-format mer": "mermaid",
    "kinlint rule inverted-l": "inverted-limit",
    "kinlint conv": "convert",
    "kinlint check a": r"a\ robot.urdf",
}


@pytest.mark.parametrize("typed", TYPED)
@pytest.mark.parametrize("shell", STARTS)
def test_tab_completes_at_a_terminal(scripts, shell, typed):
    """Where the shell itself takes the line apart and quotes what it puts in."""
    _need(shell)
    command, start = STARTS[shell]
    child, terminal = pty.fork()
    if child == 0:
        os.execvpe(command[0], command, _environment())  # noqa: S606
    try:
        os.write(terminal, f"{start}\n".encode())
        _seen(terminal, "ready> ")
        os.write(terminal, f"{typed}\t".encode())
        assert TYPED[typed] in _seen(terminal, TYPED[typed])
    finally:
        os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)
        os.close(terminal)


def _seen(terminal, text):
    """What the terminal shows until *text* is among it, without what steers it."""
    said, end = b"", time.monotonic() + SOON
    shown = ""
    while text not in shown and time.monotonic() < end:
        if select.select([terminal], [], [], 1)[0]:
            said += os.read(terminal, 4096)
        shown = re.sub(
            r"\x1b\[[\d;?]*[A-Za-z]|\x1b[=>]|[\x07\r]", "", said.decode("utf-8", "replace")
        )
        shown = re.sub(r".\x08", "", shown)
    return shown


def test_all_options_of_all_commands_are_known(kinlint):
    """Help and completion tell of the same."""
    for command in words([]).commands:
        helped = kinlint(command.name, "--help")[1]
        for option in command.options:
            assert all(name in helped for name in option.names)


def test_values_are_those_of_the_parser():
    """Formats, keys, and which options take rules."""
    commands = {command.name: command for command in words([]).commands}
    options = {name: each for each in commands["check"].options for name in each.names}
    assert options["--output-format"].value.words == OUTPUT_FORMATS
    assert options["--select"].value.kind == "rules"
    assert options["--fix"].value is None
    assert commands["config"].rest.words == tuple(KEYS)


@pytest.mark.parametrize("arguments", [(), ("tcsh",), ("bash", "zsh"), ("--", "bsh")])
def test_a_shell_is_one_of_three(kinlint, arguments):
    """Told in one line, with what may be meant."""
    code, out, err = kinlint("generate-shell-completion", *arguments)
    assert (code, out) == (2, "")
    assert "bash" in err
    assert err.count("\n") == 1
