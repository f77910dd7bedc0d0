"""`kinlint new`: begins a rule file, for its author to fill in."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path

from kinlint import resources
from kinlint.catalogue.scaffold import EXAMPLES, scaffold
from kinlint.cli.argument_parser import Parser, non_empty, one_of
from kinlint.cli.project_rules import project_config
from kinlint.errors import ConfigError, UsageError
from kinlint.files.pathglob import absolute
from kinlint.files.pathname import shown
from kinlint.formats.records import GRAPHS
from kinlint.suggestion import did_you_mean

NAME = re.compile(r"[a-z][a-z0-9]*(-[a-z0-9]+)*")
CODE = re.compile(r"([A-Z]{1,8})[0-9]{3}")
_WRITTEN = re.compile(r"""\bkl:code\s+["']([A-Z]{1,8}[0-9]{3})["']""")
LAST = 999


def parser() -> Parser:
    """The parser of `kinlint new`."""
    made = Parser(
        prog="kinlint new",
        description="Create a rule file, DIR/FAMILY/NAME.ttl, with TODO where something has to be"
        " filled in. `kinlint test-rules` then tests the rule.",
        usage="kinlint new FAMILY/NAME [options]",
    )
    made.add_positionals(
        "rules", "FAMILY/NAME", "family and name, after the fault: limits/inverted-limit"
    )
    add = made.add_argument
    add("--directory", type=non_empty, metavar="DIR", default="rules", help="default: rules")
    add(
        "--code",
        type=non_empty,
        metavar="CODE",
        help="such as ACME001 (default: the next free one of code-prefix or of the family)",
    )
    add(
        "--format",
        type=one_of(tuple(EXAMPLES)),
        metavar="|".join(EXAMPLES),
        default=GRAPHS[0].name,
        help="what the examples are written in",
    )
    return made


def run(arguments: Sequence[str]) -> int:
    """Write the file that *arguments* name; the exit code."""
    options = parser().read(arguments)
    if len(options.rules) != 1:
        raise UsageError("expected one FAMILY/NAME, such as limits/inverted-limit")
    family, name = _parts(options.rules[0])
    top = absolute(options.directory)
    path = top / family / f"{name}.ttl"
    homes = [resources.data("rules"), top]
    if path.exists():
        raise UsageError(f"{shown(path)} is there already")
    for home in homes:
        if (other := next(home.rglob(f"{name}.ttl"), None)) is not None:
            raise UsageError(f"a rule is called {name} already: {shown(other)}")
    codes = dict(_codes(homes))
    own = top == resources.data("rules").resolve()
    code = options.code or _chosen(family, codes, top, own=own)
    if not CODE.fullmatch(code):
        raise UsageError(f"--code: '{code}' is not one to eight capitals and three digits")
    if code in codes:
        raise UsageError(f"--code: {code} is that of {shown(codes[code])}")
    text = scaffold(name, code, options.format)
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with path.open("x", encoding="utf-8", newline="\n") as stream:
            stream.write(text)
    except OSError as error:
        raise UsageError(f"cannot write {shown(path)}: {error.strerror or error}") from None
    where = shown(path)
    sys.stdout.write(f"{where}: {code}. Replace each TODO, then run: kinlint test-rules {where}\n")
    return 0


def _chosen(family: str, codes: Mapping[str, Path], top: Path, *, own: bool) -> str:
    """Return the next free code for a rule of *family* below *top*.

    Codes of kinlint are given only if the rules are its *own*; *codes* are all that are taken.
    """
    prefix = None if own else project_config(trust=False).code_prefix
    if prefix:
        if not re.fullmatch("[A-Z]{1,8}", prefix):
            raise ConfigError(f"code-prefix: '{prefix}' is not one to eight capitals")
        return _after(prefix, codes)
    code = _next(family, codes)
    taken = {each[:-3] for each, file in codes.items() if not file.is_relative_to(top)}
    if not own and code[:-3] in taken:
        raise UsageError(
            f"codes in {code[:-3]} are kinlint's own: give one of yours, --code ACME001,"
            ' or code-prefix = "ACME" in kinlint.toml'
        )
    return code


def _parts(given: str) -> tuple[str, str]:
    family, mark, name = given.removesuffix(".ttl").partition("/")
    if not mark:
        raise UsageError(f"expected FAMILY/NAME, such as limits/inverted-limit, got '{given}'")
    for part, what in ((family, "family"), (name, "name")):
        if not NAME.fullmatch(part):
            kebab = re.sub(r"[^a-z0-9]+", "-", re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "-", part).lower())
            meant = kebab.strip("-0123456789")
            hint = f", such as '{meant}'" if NAME.fullmatch(meant) else ""
            raise UsageError(f"the {what} '{part}' is not words of lower case with hyphens{hint}")
    return family, name


def _codes(homes: Iterable[Path]) -> Iterator[tuple[str, Path]]:
    """The codes of all rules in *homes*, with their files."""
    for file in (file for home in homes for file in sorted(home.rglob("*.ttl"))):
        for code in _WRITTEN.findall(file.read_text("utf-8", "replace")):
            yield code, file


def _next(family: str, codes: Mapping[str, Path]) -> str:
    """The code after the last one of *family*, or the first one if that is like none there is."""
    own = {code for code, file in codes.items() if file.parent.name == family}
    if not own:
        known = {file.parent.name for file in codes.values()}
        if hint := did_you_mean(family, known):
            raise UsageError(f"no family is called '{family}'{hint}; --code begins one of your own")
        prefix = re.sub(r"[^a-z]", "", family)[:3].upper()
        if any(code[:-3] == prefix for code in codes):
            raise UsageError(
                f"codes in {prefix} are of another family; --code begins one of your own"
            )
        return f"{prefix}001"
    return _after(max(own)[:-3], codes)


def _after(prefix: str, codes: Iterable[str]) -> str:
    """Return the code after the last one that begins with *prefix*, or the first."""
    last = max((int(code[-3:]) for code in codes if code[:-3] == prefix), default=0)
    if last >= LAST:
        raise UsageError(f"no code of {prefix} is left; give one with --code")
    return f"{prefix}{last + 1:03}"
