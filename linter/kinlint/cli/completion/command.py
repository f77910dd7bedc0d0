"""`kinlint generate-shell-completion`: prints a script that completes the command line."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence

from kinlint.catalogue import rulebook
from kinlint.catalogue.rulebook import Rulebook
from kinlint.cli.argument_parser import Parser
from kinlint.cli.completion import bash, fish, zsh
from kinlint.cli.completion.grammar import SHELLS, Words, words
from kinlint.configuration.value_kinds import unknown_message
from kinlint.errors import UsageError
from kinlint.project.layers import cache_directory

SCRIPTS: Mapping[str, Callable[[Words], str]] = dict(
    zip(SHELLS, (bash.script, zsh.script, fish.script), strict=True)
)

DESCRIPTION = """\
Print the completion script for a shell.

  bash:  kinlint generate-shell-completion bash > ~/.local/share/bash-completion/completions/kinlint
  zsh:   kinlint generate-shell-completion zsh > DIR/_kinlint    (DIR is one of $fpath)
  fish:  kinlint generate-shell-completion fish > ~/.config/fish/completions/kinlint.fish"""


def parser() -> Parser:
    """The parser of `kinlint generate-shell-completion`."""
    made = Parser(
        prog="kinlint generate-shell-completion",
        description=DESCRIPTION,
        usage=f"kinlint generate-shell-completion {'|'.join(SHELLS)}",
    )
    made.add_positionals("shell", "SHELL", "the shell")
    return made


def run(arguments: Sequence[str]) -> int:
    """Print the script for the shell that *arguments* name; the exit code."""
    options = parser().read(arguments)
    if len(options.shell) != 1:
        raise UsageError(f"expected one shell: {', '.join(SHELLS)}")
    if problem := unknown_message(options.shell[0], SHELLS):
        raise UsageError(f"shell: {problem}")
    book = rulebook.load((), (), cache_directory(os.environ))
    sys.stdout.write(SCRIPTS[options.shell[0]](words(_selectors(book))))
    return 0


def _selectors(book: Rulebook) -> Iterator[str]:
    """Yield the selectors of rules, the most general first."""
    yield from ("ALL", *sorted({rule.family for rule in book.rules}))
    yield from sorted({point for rule in book.rules for point in rule.antipatterns})
    yield from (name for rule in book.rules for name in (rule.code, rule.name))
