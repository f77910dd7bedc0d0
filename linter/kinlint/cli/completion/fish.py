"""The script for fish."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.cli.completion.grammar import Command, Value, Words

HEAD = """\
# Completion of kinlint for fish. Made by: kinlint generate-shell-completion fish

set -g __kinlint_rules {rules}

# Whether the subcommand is $argv[1]; without one it is {first}.
function __kinlint_is
    set -l typed (commandline -opc)
    set -l command {first}
    contains -- "$typed[2]" {names}; and set command $typed[2]
    test $command = $argv[1]
end

function __kinlint_first
    test (count (commandline -opc)) -eq 1
end

complete -c kinlint -e
"""


def script(words: Words) -> str:
    """The script that completes *words*."""
    names = " ".join(command.name for command in words.commands)
    head = HEAD.format(rules=" ".join(words.rules), first=words.commands[0].name, names=names)
    return "".join([head, *(line for command in words.commands for line in _lines(command))])


def _lines(command: Command) -> Iterator[str]:
    yield _line("__kinlint_first", f"-a {command.name} -d {_quoted(command.text)}")
    here = f"__kinlint_is {command.name}"
    for option in command.options:
        names = " ".join(
            f"-l {name[2:]}" if name.startswith("--") else f"-s {name[1:]}" for name in option.names
        )
        taken = "" if option.value is None else f" {_taken(option.value)}"
        yield _line(here, f"{names}{taken} -d {_quoted(option.text)}")
    if command.rest is None:
        yield _line(here, "-f")
    elif command.rest.kind not in ("files", "folders"):
        yield _line(here, _taken(command.rest).replace("-x", "-f", 1))


def _line(condition: str, rest: str) -> str:
    return f"complete -c kinlint -n {_quoted(condition)} {rest}\n"


def _taken(value: Value) -> str:
    if value.kind == "files":
        return "-r -F"
    if value.kind == "folders":
        return "-x -a '(__fish_complete_directories)'"
    if value.kind == "anything":
        return "-x"
    words = "$__kinlint_rules" if value.kind == "rules" else " ".join(value.words)
    return f"-x -a '(__fish_append , {words})'" if value.several else f"-x -a '{words}'"


def _quoted(text: str) -> str:
    escaped = text.replace("\\", "\\\\").replace("'", "\\'")
    return f"'{escaped}'"
