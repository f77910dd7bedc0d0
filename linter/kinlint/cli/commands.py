"""The subcommands, and which of them a command line means."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Mapping
from importlib import import_module

from kinlint.cli.argument_parser import HelpShown
from kinlint.suggestion import did_you_mean

COMMANDS: Mapping[str, tuple[str, str]] = {
    "check": ("kinlint.cli.check_command", "lint files (the default)"),
    "demo": ("kinlint.cli.demo_command", "lint a faulty robot and explain the findings"),
    "init": ("kinlint.cli.init_command", "set up a project: configuration, pre-commit, CI"),
    "rules": ("kinlint.cli.rules_command", "list the rules, one a line"),
    "rule": ("kinlint.cli.rule_command", "explain a rule or a family of rules"),
    "targets": ("kinlint.cli.targets_command", "show how consumers treat robot descriptions"),
    "config": ("kinlint.cli.config_command", "describe the configuration keys"),
    "server": ("kinlint.cli.server_command", "start the language server for editors"),
    "graph": ("kinlint.cli.graph_command", "draw links and joints with the findings"),
    "query": ("kinlint.cli.query_command", "query the graph that rules see with SPARQL"),
    "diff": ("kinlint.cli.diff_command", "compare two descriptions of a robot"),
    "convert": ("kinlint.cli.convert_command", "convert URDF, SDF, MJCF, USD, ... to JSON-LD"),
    "load": ("kinlint.cli.load_command", "put models into a triple store"),
    "generate": ("kinlint.cli.generate_command", "generate a program for KDL, Pinocchio or numpy"),
    "contexts": ("kinlint.cli.contexts_command", "list or add JSON-LD contexts"),
    "new": ("kinlint.cli.new_command", "create a rule file"),
    "test-rules": ("kinlint.cli.test_rules_command", "test rules against their examples"),
    "format-rules": ("kinlint.cli.format_rules_command", "format rule files"),
    "generate-shell-completion": (
        "kinlint.cli.completion.command",
        "print the completion script for a shell",
    ),
    "clean": ("kinlint.cli.clean_command", "delete the cache"),
    "version": ("kinlint.cli.version_command", "print the version"),
}
"""The subcommands in the order of use, each with its module and its description.

`run` of a module takes the arguments and returns the exit code.
"""

ALIASES: Mapping[str, tuple[str, ...]] = {
    "explain": ("rule",),
    "fix": ("check", "--fix"),
    "lint": ("check",),
    "list": ("rules",),
    "lsp": ("server",),
}
"""Names that other tools have for commands; a path of such a name comes first."""


def run(arguments: list[str]) -> int:
    """Run the subcommand that *arguments* begin with, else `check`; asked for help, it is done."""
    arguments = _without_aliases(arguments)
    name = arguments[0] if arguments[:1] and arguments[0] in COMMANDS else None
    if name is None and _asks_for_help(arguments):
        from kinlint.cli.overview import page  # noqa: PLC0415  most runs do not ask for help

        sys.stdout.write(page(COMMANDS))
        return 0
    module = import_module(COMMANDS[name or "check"][0])
    command: Callable[[list[str]], int] = module.run
    try:
        return command(arguments[1:] if name else arguments)
    except HelpShown:
        return 0


def _without_aliases(arguments: list[str]) -> list[str]:
    """Return *arguments* with the command that an alias stands for, `help X` as `X --help`."""
    first, *rest = arguments or [""]
    if first == "--help-all":
        return ["check", "--help"]
    if os.path.lexists(first):
        return arguments
    if first == "help":
        return [*rest[:1], "--help"]
    return [*ALIASES[first], *rest] if first in ALIASES else arguments


def _asks_for_help(arguments: list[str]) -> bool:
    end = arguments.index("--") if "--" in arguments else len(arguments)
    return not {"-h", "--help"}.isdisjoint(arguments[:end])


def hint(word: str) -> str:
    """Return a hint for *word*, which is no path: it may be a command, or a misspelt one."""
    if word in COMMANDS:
        return f"; the command '{word}' comes first: kinlint {word} ..."
    return did_you_mean(word, (*COMMANDS, *ALIASES)) if word.replace("-", "").isalpha() else ""
