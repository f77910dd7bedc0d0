"""The options of `kinlint check`."""

from __future__ import annotations

from argparse import BooleanOptionalAction
from collections.abc import Callable
from typing import Any

from kinlint.cli.argument_parser import Parser, comma_list, count, non_empty, one_of, seconds
from kinlint.cli.commands import COMMANDS
from kinlint.configuration.keys import (
    ENGINES,
    OUTPUT_FORMATS,
    SEVERITIES,
    TARGETS,
    THRESHOLDS,
)
from kinlint.configuration.value_kinds import ALIASES
from kinlint.contexts.context_library import RELEASES

LISTS: dict[str, Any] = {"type": comma_list, "action": "extend"}
TEXTS: dict[str, Any] = {"action": "append", "type": non_empty}
FLAG: dict[str, Any] = {"action": "store_true"}
STDOUT = "-"
"""The name of standard output, and of standard input."""

WIDTH = max(map(len, COMMANDS))
DESCRIPTION = """\
kinlint lints robot models: units, frames, topology, inertia, and what JSON-LD drops in silence.

  kinlint [PATH...]  is  kinlint check [PATH...]; no PATH is the current directory.
  PATH is a file, a directory, a quoted glob, or - for standard input.

Commands (a path of such a name: ./rule):
""" + "\n".join(f"  {name:<{WIDTH}} {what}" for name, (_, what) in COMMANDS.items())

EPILOG = """\
R names rules: a code (UNI002), a name (unit-quantity-mismatch), the beginning of codes (UNI),
an anti-pattern (AP3) or ALL; several with commas. The more specific R wins.
Configuration: .kinlint.toml, kinlint.toml or pyproject.toml [tool.kinlint], the nearest to a file.
Exit code: 0 clean, 1 findings at or above --fail-on, 2 anything else."""


def parser() -> Parser:
    """The parser of `kinlint check`."""
    made = Parser(
        prog="kinlint",
        description=DESCRIPTION,
        epilog=EPILOG,
        usage="kinlint [check] [PATH...] [options]",
    )
    made.add_positionals("paths", "PATH", "what to lint")
    made.helping.add_argument("-V", "--version", action="store_true", help="show the version")
    _rules(made)
    _fixes(made)
    _known(made)
    _files(made)
    _reading(made)
    _output(made)
    return made


def _rules(made: Parser) -> None:
    add = made.add_argument_group("Rules").add_argument
    add("--select", metavar="R", **LISTS, help="only these rules")
    add("--extend-select", metavar="R", **LISTS, help="these rules, too")
    add("--ignore", metavar="R", **LISTS, help="without these rules")
    for word in SEVERITIES:
        add(f"--{word}", metavar="R", **LISTS, help=f"what these rules find counts as {word}")
    entry = "GLOB:R"
    add("--per-file-ignores", metavar=entry, **LISTS, help="without R in these files")
    add("--extend-per-file-ignores", metavar=entry, **LISTS, help="the same, beside configuration")
    add("--target", metavar="NAME", **LISTS, help=f"rules for it, too: {', '.join(TARGETS)}")
    add("--ignore-suppressions", **FLAG, help="report what is suppressed as if it were not")
    add("--show-suppressed", **FLAG, help="report what is suppressed, as suppressed")
    add("--show-consequences", **FLAG, help="list findings that follow from another one, too")
    made.require_equals("--add-ignore")
    add("--add-ignore", metavar="[=REASON]", help="write suppressions of all that is found")
    add("--rules", metavar="DIR", **TEXTS, help="add the rule files in DIR")
    add("--shapes", metavar="FILE", **TEXTS, help="add the SHACL shapes in FILE")
    add("--trust", **FLAG, help="let the project's configuration add rules and shapes")
    add("--engine", type=one_of(ENGINES), metavar="|".join(ENGINES), help="what checks the rules")
    add("--no-cache", "-n", **FLAG, help="keep no reports, and recall none")
    add("--cache-dir", type=non_empty, metavar="DIR", help="where reports and rules are kept")


def _fixes(made: Parser) -> None:
    add = made.add_argument_group("Fixes").add_argument
    add("--fix", **FLAG, help="make the safe fixes, and report what is left")
    add("--fix-only", **FLAG, help="make them, and report nothing that is left")
    add("--unsafe-fixes", action=BooleanOptionalAction, help="make the unsafe ones, too")
    add("--show-fixes", **FLAG, help="list what was fixed")
    add("--diff", **FLAG, help="show what --fix-only would change, and write nothing")
    add("--fixable", metavar="R", **LISTS, help="fix only what these rules find")
    add("--unfixable", metavar="R", **LISTS, help="fix nothing that these rules find")
    add("--exit-non-zero-on-fix", **FLAG, help="exit with 1 if anything was fixed")


def _known(made: Parser) -> None:
    add = made.add_argument_group("New findings only").add_argument
    add("--baseline", type=non_empty, metavar="FILE", help="report only what is not known there")
    add("--write-baseline", **FLAG, help="make all that is found known there")
    add("--prune-baseline", **FLAG, help="forget there what is found no more")
    add(
        "--new-from-rev",
        type=non_empty,
        metavar="REV",
        help="report what was not found at REV of git",
    )
    add(
        "--new-from-merge-base",
        type=non_empty,
        metavar="REV",
        help="the same, since the working tree left the branch REV",
    )


def _files(made: Parser) -> None:
    add = made.add_argument_group("Files").add_argument
    add("--exclude", metavar="GLOB", **LISTS, help="pass over these in directories")
    add("--extend-exclude", metavar="GLOB", **LISTS, help="pass over these, too")
    add(
        "--respect-gitignore",
        action=BooleanOptionalAction,
        help="skip what git ignores in directories (the default)",
    )
    add("--force-exclude", **FLAG, help="pass over them even if they are named")
    add("--in-project", **FLAG, help="judge them as parts of all that is below this directory")
    add("--stdin-filename", type=non_empty, metavar="F", help="what standard input is called")
    add("--report-bug", metavar="DIR", help="write what makes kinlint fail to DIR, without names")
    add("--watch", "-w", **FLAG, help="lint again whenever something changes, until Ctrl-C")
    add("--jobs", "-j", type=count, metavar="N", default=1, help="processes; 0: one for each CPU")
    add("--file-timeout", type=seconds, metavar="S", help="report files that take longer; 0: never")
    add("--show-files", **FLAG, help="show what would be linted, and stop")


def _reading(made: Parser) -> None:
    add = made.add_argument_group("Models and configuration").add_argument
    add(
        "--contexts",
        metavar="RELEASE",
        help=f"release of the comp-rob2b contexts: {', '.join(RELEASES)} (the newest, the default)",
    )
    add(
        "--partial",
        action=BooleanOptionalAction,
        help="the files are a part of a model: miss nothing that others may hold",
    )
    add_reading_options(add)
    add("--config", metavar="PATH|KEY=VALUE", **TEXTS, help="this configuration, or this key of it")
    add("--isolated", **FLAG, help="without configuration files")
    add("--show-settings", **FLAG, help="show the settings of each file, and stop")


def _output(made: Parser) -> None:
    formats = "|".join(OUTPUT_FORMATS)
    add = made.add_argument_group("Output").add_argument
    add("--output-format", type=one_of(OUTPUT_FORMATS), metavar="F", help=f"{formats}")
    add(
        "-o",
        "--output-file",
        type=non_empty,
        metavar="FILE",
        help="write there instead of standard output",
    )
    for name in OUTPUT_FORMATS:
        add(f"--{name}-output", type=non_empty, metavar="FILE", help=f"write {name} there, too")
    add(
        "--statistics",
        **FLAG,
        help="count findings by rule instead of showing them; with -v also where time went",
    )
    add(
        "--profile",
        **FLAG,
        help="show which symptoms of the anti-patterns come with the format of each file, and stop",
    )
    add(
        "--show",
        type=one_of(SEVERITIES, ALIASES),
        metavar="|".join(SEVERITIES),
        help="least severity that full, concise and grouped show (default: warning)",
    )
    add(
        "--fail-on",
        type=one_of(THRESHOLDS, ALIASES),
        metavar="|".join(THRESHOLDS),
        help="the least severity that makes the exit code 1 (default: warning)",
    )
    add("-e", "--exit-zero", **FLAG, help="exit with 0 even if there are findings")
    add("-q", "--quiet", **FLAG, help="findings only, no summary")
    add("-s", "--silent", **FLAG, help="nothing but the exit code and errors")
    add(
        "-v",
        "--verbose",
        action="count",
        default=0,
        help="say what was read and how; with --statistics where time went, as -vv by rule",
    )
    add(
        "--color",
        type=one_of(("auto", "always", "never")),
        default="auto",
        metavar="WHEN",
        help="auto|always|never",
    )


def add_reading_options(add: Callable[..., object]) -> None:
    """Add, by *add*, the options that say how models are read."""
    add("--package", metavar="NAME=DIR", **TEXTS, help="where the ROS package NAME lies")
    add("--xacro-arg", metavar="NAME:=VALUE", **TEXTS, help="an argument for xacro files")


def add_output_file(made: Parser, metavar: str = "FILE", way: str = "write there") -> None:
    """Add the option for the file that a command writes, in the *way* that its help tells."""
    made.add_argument(
        "-o",
        "--output-file",
        type=non_empty,
        metavar=metavar,
        default=STDOUT,
        help=f"{way}; -, the default, is standard output",
    )
