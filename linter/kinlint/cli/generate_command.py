"""`kinlint generate`: writes programs from models, once these lint clean."""

from __future__ import annotations

import json
import sys
from argparse import Namespace
from collections.abc import Collection, Iterable, Mapping, Sequence
from contextlib import ExitStack
from difflib import unified_diff
from importlib.util import find_spec
from pathlib import Path

from kinlint.cli import check_options as linting
from kinlint.cli.argument_parser import Parser, non_empty, one_of
from kinlint.cli.model_inputs import add_input_options, find_inputs, read_inputs
from kinlint.cli.output_files import replacing
from kinlint.cli.progress import ProgressBar
from kinlint.cli.xacro_arguments import take_arguments
from kinlint.configuration.settings import Choice, FileSettings, Settings
from kinlint.errors import UsageError
from kinlint.finding import Finding
from kinlint.light_dataclasses import replace
from kinlint.report import Report
from kinlint.reporters.reporter_registry import write, write_summary
from kinlint.reporters.terminal_style import detect_style
from kinlint.rule import PROGRAMS, Severity
from kinlint.terms import Triple

LIBRARIES = ("kdl", "numpy", "pinocchio")
REWRITE, FRAME = STAGES = ("rewrite", "frame")
CLEAN, FOUND = 0, 1

DESCRIPTION = """\
Generate a program for a library of robot kinematics: from a schedule of operators if the models
have one, else from a tree of joints, in any format, with forward kinematics of positions and
velocities and, where all inertias are known, inverse dynamics. The models are linted first, also
for what the library can do; nothing is written unless they lint clean."""

EPILOG = """\
Example: kinlint generate --for numpy arm.urdf -o arm/ && python arm/robot.py
Exit code: 0 written; 1 findings in the models, or with --check or --diff, files that would change;
2 if something cannot be read or written."""


def parser() -> Parser:
    """The parser of `kinlint generate`."""
    made = Parser(
        prog="kinlint generate",
        description=DESCRIPTION,
        epilog=EPILOG,
        usage="kinlint generate --for LIBRARY MODEL... -o DIR [options]",
    )
    made.add_positionals("paths", "MODEL", "robot descriptions; several files are one model")
    add = made.add_argument
    add(
        "--for",
        dest="library",
        type=one_of(LIBRARIES),
        metavar="|".join(LIBRARIES),
        help="the library that the program uses",
    )
    add("-o", "--output-directory", type=non_empty, metavar="DIR", help="where to write its files")
    add("--templates", type=non_empty, metavar="DIR", help="use the templates in DIR before others")
    add(
        "--stage",
        type=one_of(STAGES),
        metavar="|".join(STAGES),
        help="print the rewritten graph, or the tree that templates are given; write nothing",
    )
    add("--check", **linting.FLAG, help="list the files that would change; write nothing")
    add("--diff", **linting.FLAG, help="show what would change; write nothing")
    add(
        "--select",
        metavar="R",
        **linting.LISTS,
        help="lint by these rules, and those that programs depend on",
    )
    add("--extend-select", metavar="R", **linting.LISTS, help="lint by these rules too")
    add(
        "--ignore",
        metavar="R",
        **linting.LISTS,
        help="lint without these rules, unless programs depend on them",
    )
    add(
        "--fail-on",
        type=one_of(("warning", "error")),
        metavar="warning|error",
        default="warning",
        help="least severity that keeps a program from being written (default: warning)",
    )
    add_input_options(add, "add the rule files in DIR")
    add(
        "--color",
        type=one_of(("auto", "always", "never")),
        metavar="auto|always|never",
        default="auto",
        help="colour findings (default: on a terminal)",
    )
    add("-q", "--quiet", **linting.FLAG, help="do not list what is written")
    return made


def run(arguments: Sequence[str]) -> int:
    """Generate what *arguments* ask for; the exit code."""
    options = parser().read(arguments)
    take_arguments(options)
    if not options.paths and not options.stdin_filename:
        raise UsageError("name the models, or - for standard input")
    if options.library is None or not (options.output_directory or options.stage):
        raise UsageError(f"say for which library, --for {'|'.join(LIBRARIES)}, and where, -o DIR")
    if find_spec("jinja2") is None:
        raise UsageError("programs are rendered by Jinja: pip install 'kinlint[generate]'")
    templates = None if options.templates is None else Path(options.templates)
    if templates is not None and not templates.is_dir():
        raise UsageError(f"--templates: no directory at '{templates}'")
    statements = _rewritten(options)
    if statements is None:
        return FOUND
    if options.stage == REWRITE:
        sys.stdout.writelines(f"{' '.join(each)} .\n" for each in statements)
        return CLEAN
    return _give(options, statements, templates)


def _give(options: Namespace, statements: Sequence[Triple], templates: Path | None) -> int:
    """Write, or show, what the program of *statements* consists of; the exit code."""
    from kinlint.generation.program import framed  # noqa: PLC0415  slow

    tree = framed(statements)
    if options.stage == FRAME:
        sys.stdout.write(f"{json.dumps(tree, indent=2)}\n")
        return CLEAN
    from kinlint.generation.rendering import render  # noqa: PLC0415  slow

    files = render(tree, options.library, templates)
    home = Path(options.output_directory)
    _refuse(home, files)
    changed = {name: text for name, text in files.items() if _read(home / name) != text}
    if options.diff:
        for name, text in changed.items():
            path = str(home / name)
            old = (_read(home / name) or "").splitlines(keepends=True)
            sys.stdout.writelines(unified_diff(old, text.splitlines(keepends=True), path, path))
    elif options.check:
        sys.stdout.writelines(f"would write {home / name}\n" for name in changed)
    else:
        _write(home, changed)
        if not options.quiet:
            sys.stderr.writelines(f"kinlint: wrote {home / name}\n" for name in changed)
    return FOUND if changed and (options.check or options.diff) else CLEAN


def _rewritten(options: Namespace) -> Sequence[Triple] | None:
    """Return the statements of the program; None, with findings shown, if it must not be."""
    from kinlint.configuration.selection import Policies  # noqa: PLC0415  engines are slow to import
    from kinlint.facts.part_names import PartNames  # noqa: PLC0415
    from kinlint.findings.locator import Locator  # noqa: PLC0415
    from kinlint.formats.dependencies.companions import pair  # noqa: PLC0415
    from kinlint.generation.program import required_codes, rewritten_for  # noqa: PLC0415
    from kinlint.pipeline.analyzer import Analyzer  # noqa: PLC0415

    found, settings = find_inputs(options)
    if not found.inputs and not found.errors:
        raise UsageError(f"no robot found in '{found.barren[0]}'")
    settings = _extended(settings, options.library)
    with ProgressBar(len(found.inputs), wanted=not options.quiet, color=options.color) as bar:
        sources, book = read_inputs(found, settings, options, bar)
        bar.advance(0)  # the rules may have taken long
        required = required_codes(book.rules)
        settings = _strict(settings, required)
        Policies(settings, book.rules).check_selectors()
        examined = Analyzer(settings, book, repeated=True).examine(pair(sources, settings))
        bar.advance(len(found.inputs))
        for error in examined.report.errors:
            raise error
        least = Severity[options.fail_on.upper()]
        if (refused := _refused(examined.report, least, required)) is None:
            names = PartNames(Locator(examined.documents, examined.store)).names
            return rewritten_for(options.library, examined.store, names)
    style = detect_style(sys.stdout, options.color)
    write(refused, "full", sys.stdout, style, summarise=False)
    write_summary(refused, sys.stdout, style)
    sys.stderr.write(f"kinlint: nothing is written: {_cause(refused)}\n")
    return None


def _extended(settings: Settings, library: str) -> Settings:
    """Return *settings* with the rules of programs for *library*."""
    from kinlint.generation.program import abilities, rule_files  # noqa: PLC0415  slow

    rules, shapes = (*settings.rules, rule_files()), (*settings.shapes, abilities(library))
    return replace(settings, rules=rules, shapes=shapes, drawn=False)


def _strict(settings: Settings, required: Collection[str]) -> Settings:
    """Return *settings* with the rules whose codes are *required*, which no selection turns off."""
    codes = (PROGRAMS, *sorted(required))
    always = Choice(extend_select=codes, severity=((PROGRAMS, Severity.ERROR),))

    def strict(each: FileSettings) -> FileSettings:
        return replace(each, choices=(*each.choices, always))

    files = {name: strict(each) for name, each in settings.files.items()}
    return replace(settings, default=strict(settings.default), files=files)


def _refused(report: Report, least: Severity, required: Collection[str]) -> Report | None:
    """Return what *report* shows if a finding forbids a program; None if none does.

    Nobody can suppress errors of the *required* rules, since the program would do something else.
    """

    def holds(each: Finding) -> bool:
        return each.rule.code in required and each.severity >= Severity.ERROR

    kept = [replace(each, suppressed=None) for each in report.suppressed if holds(each)]
    found = sorted((*report.unsuppressed, *kept), key=lambda each: each.sort_key)
    if not any(each.severity >= least for each in found):
        return None
    rest = tuple(each for each in report.suppressed if not holds(each))
    shown = replace(report, findings=tuple(found), suppressed=rest)
    return shown.shown_from(Severity.WARNING)


def _cause(report: Report) -> str:
    """Say why *report* forbids a program, and what to do where nothing but warnings does."""
    if any(each.severity >= Severity.ERROR for each in report.findings):
        return "the models have errors"
    return "the models have warnings, which --fail-on error accepts"


def _read(path: Path) -> str | None:
    """Return the text of the file at *path*; None if there is none, or no text."""
    try:
        return path.read_bytes().decode("utf-8")
    except (OSError, UnicodeDecodeError):
        return None


def _refuse(home: Path, names: Iterable[str]) -> None:
    """Raise `UsageError` if files of these *names* cannot be in the directory *home*."""
    if home.exists() and not home.is_dir():
        raise UsageError(f"-o/--output-directory: '{home}' is no directory")
    for path in (home / each for each in names):
        if path.is_symlink():
            raise UsageError(f"{path} is a link: nothing is written outside of {home}")
        if path.exists() and not path.is_file():
            raise UsageError(f"cannot write {path}: it is no file")


def _write(home: Path, files: Mapping[str, str]) -> None:
    """Write *files* to the directory *home*."""
    try:
        home.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise UsageError(f"cannot make directory {home}: {error.strerror or error}") from None
    with ExitStack() as complete:  # no file is replaced before all of them are written
        for name, text in files.items():
            stream = complete.enter_context(replacing(home / name))
            stream.write(text)
            stream.flush()
