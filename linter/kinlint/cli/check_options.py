"""The options of `kinlint check`."""

from __future__ import annotations

from argparse import BooleanOptionalAction
from collections.abc import Callable
from typing import Any

from kinlint.cli.argument_parser import (
    Parser,
    add_store,
    comma_list,
    count,
    dask_address,
    non_empty,
    one_of,
    seconds,
)
from kinlint.cli.report_destinations import add_output_options
from kinlint.configuration.keys import (
    ENGINES,
    SEVERITIES,
    TARGETS,
)
from kinlint.contexts.context_library import RELEASES
from kinlint.formats.records import BY_NAME

LISTS: dict[str, Any] = {"type": comma_list, "action": "extend"}
TEXTS: dict[str, Any] = {"action": "append", "type": non_empty}
FLAG: dict[str, Any] = {"action": "store_true"}
STDOUT = "-"
"""The name of standard output, and of standard input."""

DESCRIPTION = """\
Lint robot descriptions. PATH is a file, a directory, a quoted glob, a URL such
as s3://bucket/robots, or - for standard input; the default is the current
directory. The word check may be left out."""

EPILOG = """\
R selects rules: a code (UNI002), a name (unit-quantity-mismatch), a family
(units, or UNI), the beginning of codes (UNI0), an anti-pattern (AP3) or ALL;
commas separate several. The more specific R wins.
Configuration: .kinlint.toml, kinlint.toml or pyproject.toml [tool.kinlint],
the nearest to a file.
Exit code: 0 clean, 1 findings at or above --fail-on, 2 anything else."""


def parser() -> Parser:
    """The parser of `kinlint check`."""
    made = Parser(
        prog="kinlint",
        description=DESCRIPTION,
        epilog=EPILOG,
        usage="kinlint check [PATH...] [options]",
    )
    made.add_positionals("paths", "PATH", "files and directories to lint")
    made.helping.add_argument("-V", "--version", action="store_true", help="show the version")
    _rules(made)
    _fixes(made)
    _known(made)
    _files(made)
    _reading(made)
    _store(made)
    add_output_options(made)
    return made


def _rules(made: Parser) -> None:
    add = made.add_argument_group("Rules").add_argument
    add("--select", metavar="R", **LISTS, help="check only these rules")
    add("--extend-select", metavar="R", **LISTS, help="check these rules too")
    add(
        "--preview",
        action=BooleanOptionalAction,
        help="check preview rules too, which may still change",
    )
    add("--ignore", metavar="R", **LISTS, help="do not check these rules")
    for word in SEVERITIES:
        add(f"--{word}", metavar="R", **LISTS, help=f"report findings of these rules as {word}")
    entry = "GLOB:R"
    add("--per-file-ignores", metavar=entry, **LISTS, help="do not check R in these files")
    add(
        "--extend-per-file-ignores",
        metavar=entry,
        **LISTS,
        help="the same, in addition to the configuration",
    )
    add(
        "--target", metavar="NAME", **LISTS, help=f"also check for a consumer: {', '.join(TARGETS)}"
    )
    add("--ignore-suppressions", **FLAG, help="treat suppressed findings as ordinary ones")
    add("--show-suppressed", **FLAG, help="report suppressed findings too, marked as such")
    add("--show-consequences", **FLAG, help="report findings that follow from other findings too")
    made.require_equals("--add-ignore")
    add(
        "--add-ignore",
        metavar="[=REASON]",
        help="suppress all findings by comments or triples in the files",
    )
    add("--rules", metavar="DIR", **TEXTS, help="add the rule files in DIR")
    add("--shapes", metavar="FILE", **TEXTS, help="add the SHACL shapes in FILE")
    add("--trust", **FLAG, help="allow the project's configuration to add rules and shapes")
    add("--engine", type=one_of(ENGINES), metavar="|".join(ENGINES), help="SHACL engine")
    add("--no-cache", "-n", **FLAG, help="do not read or write cached reports")
    add("--cache-dir", type=non_empty, metavar="DIR", help="cache directory")


def _fixes(made: Parser) -> None:
    add = made.add_argument_group("Fixes").add_argument
    add("--fix", **FLAG, help="apply the safe fixes and report the remaining findings")
    add("--fix-only", **FLAG, help="apply the safe fixes without reporting the remaining findings")
    add("--unsafe-fixes", action=BooleanOptionalAction, help="apply unsafe fixes too")
    add("--show-fixes", **FLAG, help="list the applied fixes")
    add("--diff", **FLAG, help="print the fixes as a patch; change no files")
    add("--fixable", metavar="R", **LISTS, help="fix only findings of these rules")
    add("--unfixable", metavar="R", **LISTS, help="do not fix findings of these rules")
    add("--exit-non-zero-on-fix", **FLAG, help="exit with 1 if anything was fixed")


def _known(made: Parser) -> None:
    add = made.add_argument_group("New findings only").add_argument
    add(
        "--baseline",
        type=non_empty,
        metavar="FILE",
        help="report only findings that are not in this baseline",
    )
    add("--write-baseline", **FLAG, help="write all findings to the baseline")
    add("--prune-baseline", **FLAG, help="drop fixed findings from the baseline")
    add(
        "--new-from-rev",
        type=non_empty,
        metavar="REV",
        help="report only findings that are new since the git revision REV",
    )
    add(
        "--new-from-merge-base",
        type=non_empty,
        metavar="REV",
        help="report only findings that are new since the merge base with REV",
    )


def _files(made: Parser) -> None:
    add = made.add_argument_group("Files").add_argument
    add("--exclude", metavar="GLOB", **LISTS, help="exclude files and directories")
    add(
        "--extend-exclude",
        metavar="GLOB",
        **LISTS,
        help="exclude in addition to the configuration and the defaults",
    )
    add(
        "--respect-gitignore",
        action=BooleanOptionalAction,
        help="skip files in directories that git ignores (default)",
    )
    add("--force-exclude", **FLAG, help="apply exclusions to files named on the command line too")
    add(
        "--in-project",
        **FLAG,
        help="read the whole project for context, report only the named files",
    )
    add("--stdin-filename", type=non_empty, metavar="F", help="file name to use for standard input")
    add("--report-bug", metavar="DIR", help="write anonymised files that make kinlint fail to DIR")
    add("--watch", "-w", **FLAG, help="lint again after every change, until Ctrl-C")
    add(
        "--jobs",
        "-j",
        type=count,
        metavar="N",
        default=1,
        help="number of processes; 0: one per CPU",
    )
    add(
        "--executor",
        type=dask_address,
        metavar="dask://HOST:PORT",
        help="lint on the workers of this Dask cluster; the files must have the same paths there",
    )
    add(
        "--file-timeout",
        type=seconds,
        metavar="S",
        help="report files that take more than S seconds; 0: no limit",
    )
    add(
        "--only-format",
        **LISTS,
        metavar="FORMAT",
        help=f"lint only files of these formats: {', '.join(BY_NAME)}; urdf includes xacro",
    )
    add("--show-files", **FLAG, help="list the files that would be linted and exit")


def _reading(made: Parser) -> None:
    add = made.add_argument_group("Models and configuration").add_argument
    add(
        "--contexts",
        metavar="RELEASE",
        help=f"release of the comp-rob2b contexts: {', '.join(RELEASES)} (default: the last)",
    )
    add(
        "--partial",
        action=BooleanOptionalAction,
        help="treat the files as part of a larger model (no missing-part findings)",
    )
    add_reading_options(add)
    add(
        "--config",
        metavar="PATH|KEY=VALUE",
        **TEXTS,
        help="use this configuration file, or set a key",
    )
    add("--isolated", **FLAG, help="ignore configuration files")
    add("--show-settings", **FLAG, help="print the settings of each file and exit")


def _store(made: Parser) -> None:
    add = add_store(made, "Models in a triple store, in place of PATH")
    add("--graph", metavar="IRI", **TEXTS, help="check only the models of these named graphs")
    add(
        "--since",
        type=non_empty,
        metavar="REVISION|TIME",
        help="check only graphs that changed since this revision (kinlint load prints it) or time",
    )
    add(
        "--scratch-graph",
        type=non_empty,
        metavar="IRI",
        help="let the store infer, into this graph for the time of the run, where rules about "
        "composable models may find anything",
    )


def add_reading_options(add: Callable[..., object]) -> None:
    """Add, by *add*, the options that say how models are read."""
    add("--package", metavar="NAME=DIR", **TEXTS, help="directory of the ROS package NAME")
    add("--xacro-arg", metavar="NAME:=VALUE", **TEXTS, help="an argument for xacro files")


def add_output_file(made: Parser, metavar: str = "FILE", way: str = "write to FILE") -> None:
    """Add the option for the file that a command writes, in the *way* that its help tells."""
    made.add_argument(
        "-o",
        "--output-file",
        type=non_empty,
        metavar=metavar,
        default=STDOUT,
        help=f"{way}; - is standard output (default)",
    )
