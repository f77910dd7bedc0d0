"""The subcommands, and which of them a command line means."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from importlib import import_module

from kinlint.cli.argument_parser import HelpShown
from kinlint.suggestion import did_you_mean

COMMANDS: Mapping[str, tuple[str, str]] = {
    "check": ("kinlint.cli.check_command", "lint robot models (the default)"),
    "clean": ("kinlint.cli.clean_command", "remove what earlier runs kept"),
    "config": ("kinlint.cli.config_command", "tell what may stand in a configuration"),
    "contexts": ("kinlint.cli.contexts_command", "list the known contexts, or add one"),
    "convert": ("kinlint.cli.convert_command", "write a URDF, xacro or SDF as composable JSON-LD"),
    "format-rules": ("kinlint.cli.format_rules_command", "format rule files"),
    "generate-shell-completion": (
        "kinlint.cli.completion.command",
        "have a shell complete what is typed",
    ),
    "graph": (
        "kinlint.cli.graph_command",
        "draw the links and joints of robots, with the findings",
    ),
    "new": ("kinlint.cli.new_command", "begin a rule of your own"),
    "rule": ("kinlint.cli.rule_command", "explain a rule, or all of them"),
    "server": ("kinlint.cli.server_command", "tell editors, by the language server protocol"),
    "test-rules": ("kinlint.cli.test_rules_command", "test rules by the examples in their files"),
    "version": ("kinlint.cli.version_command", "show the version"),
}
"""The module of each subcommand, whose `run` takes the arguments and gives the exit code."""


def run(arguments: list[str]) -> int:
    """Run the subcommand that *arguments* begin with, else `check`; asked for help, it is done."""
    name = arguments[0] if arguments[:1] and arguments[0] in COMMANDS else None
    module = import_module(COMMANDS[name or "check"][0])
    command: Callable[[list[str]], int] = module.run
    try:
        return command(arguments[1:] if name else arguments)
    except HelpShown:
        return 0


def hint(word: str) -> str:
    """Return a hint for *word*, which is no path: it may be a command, or a misspelt one."""
    if word in COMMANDS:
        return f"; the command '{word}' comes first: kinlint {word} ..."
    return did_you_mean(word, COMMANDS) if word.replace("-", "").isalpha() else ""
