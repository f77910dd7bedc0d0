"""`kinlint init`: sets up a project, with a configuration, a pre-commit hook and a workflow."""

from __future__ import annotations

import json
import os
import re
import sys
from collections.abc import Sequence
from importlib.metadata import PackageNotFoundError, distribution
from pathlib import Path

from kinlint import __version__
from kinlint.cli.argument_parser import Parser, non_empty
from kinlint.errors import UsageError
from kinlint.files.atomic_write import replacement
from kinlint.files.pathname import real

PLACEHOLDER = "https://github.com/OWNER/kinlint"
"""The address of the repository where it is not known."""
CONFIGURATION = """\
# Configuration of kinlint. `kinlint config` describes the keys.
fail-on = "error"             # what makes the exit code 1: error, warning, info or none
# select = ["ALL"]            # rules, by code, beginning of codes, name or anti-pattern
# ignore = ["FRM014"]
# rules = ["rules"]           # rule files of your own: kinlint new FAMILY/NAME begins one
# code-prefix = "ACME"        # what their codes begin with
"""
HOOK = """\
-   repo: {repository}
    rev: {revision}
    hooks:
    -   id: kinlint
"""
WORKFLOW = """\
name: kinlint
on:
  push:
    branches: [main]
  pull_request:
permissions:
  contents: read
  security-events: write   # for upload-sarif
jobs:
  kinlint:
    runs-on: ubuntu-latest
    steps:
    - uses: actions/checkout@v6
      with:
        fetch-depth: 0     # the summary then knows which robots changed
    - uses: {action}@{revision}
      with:
        upload-sarif: true
"""
HOOKS = ".pre-commit-config.yaml"
THERE = re.compile(r"^\s*-?\s*id:\s*[\"']?kinlint\b", re.MULTILINE)


def parser() -> Parser:
    """The parser of `kinlint init`."""
    made = Parser(
        prog="kinlint init",
        description="Set up a project: kinlint.toml, an entry of .pre-commit-config.yaml and a"
        " workflow for GitHub. Each is shown, and written if you agree; nothing is overwritten.",
        epilog="Exit code: 0 shown or written; 2 if a file cannot be read or written.",
    )
    made.add_positionals("paths", "DIR", "the project (default: the working directory)")
    made.add_argument("-y", "--yes", action="store_true", help="write without asking")
    made.add_argument(
        "--repository",
        type=non_empty,
        metavar="URL",
        help="git repository of kinlint (default: the one that it was installed from, if any)",
    )
    return made


def run(arguments: Sequence[str]) -> int:
    """Show what a project needs, and write what the user agrees to; the exit code."""
    options = parser().read(arguments)
    if len(options.paths) > 1:
        raise UsageError(f"expected one directory, got '{options.paths[1]}', too")
    home = Path(options.paths[0] if options.paths else ".")
    if not home.is_dir():
        raise UsageError(f"{home} is not a directory")
    repository = options.repository or _origin() or PLACEHOLDER
    said = {
        "repository": repository,
        "revision": f"v{__version__}",
        "action": re.sub(r"^https?://[^/]+/|\.git$", "", repository),
    }
    _offer(home, "kinlint.toml", CONFIGURATION, yes=options.yes)
    _offer_hook(home, HOOK.format(**said), yes=options.yes)
    _offer(home, ".github/workflows/kinlint.yml", WORKFLOW.format(**said), yes=options.yes)
    if repository == PLACEHOLDER:
        _say(
            "OWNER stands for whoever keeps the repository of kinlint: --repository URL says who.\n"
        )
    return 0


def _origin() -> str | None:
    """Return the address of the repository that kinlint was installed from: PEP 610."""
    try:
        text = distribution("kinlint").read_text("direct_url.json")
    except PackageNotFoundError:
        return None
    found = json.loads(text) if text else {}
    url = found.get("url") if "vcs_info" in found else None
    return str(url) if url else None


def _offer(home: Path, name: str, text: str, *, yes: bool) -> None:
    """Show *text*, and write it to the file *name* in *home* if it is new and the user agrees."""
    path = home / name
    if os.path.lexists(path):
        _say(f"{path} is there already, and stays as it is.\n\n")
    elif not real(path.parent).is_relative_to(real(home)):
        _say(f"{path} is not written: links lead out of the project.\n\n")
    else:
        _propose(path, text, text, "new file", yes=yes)


def _offer_hook(home: Path, entry: str, *, yes: bool) -> None:
    """Offer to add *entry* to the hooks of the project in *home*."""
    path = home / HOOKS
    if not os.path.lexists(path):
        text = f"repos:\n{entry}"
        _propose(path, text, text, "new file", yes=yes)
        return
    if not path.is_file() or not real(path).is_relative_to(real(home)):
        _say(f"{path} is not a file of the project, and stays as it is.\n\n")
        return
    try:
        before = path.read_text("utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise UsageError(f"cannot read {path}: {error}") from None
    if THERE.search(before):
        _say(f"{path} has the hook already.\n\n")
    elif (after := with_entry(before, entry)) is None:
        _say(f"{path} is not written as usual. Add to its repos:\n\n{_indented(entry)}\n")
    else:
        _propose(path, entry, after, "an entry of repos", yes=yes)


def with_entry(text: str, entry: str) -> str | None:
    """Return the pre-commit configuration *text* with *entry* as the last of its `repos`.

    All else stays, comments too. None if `repos` is not a block sequence.
    """
    lines = text.splitlines(keepends=True)
    start = next((n for n, line in enumerate(lines) if re.match(r"repos:\s*(#.*)?$", line)), None)
    if start is None:
        return None
    end = last = start + 1
    indent = None
    while end < len(lines):
        line = lines[end]
        if line.strip() and not line.lstrip().startswith("#"):
            item = re.match(r"( *)- ", line)
            if indent is None and item is None:
                return None
            if indent is None and item is not None:
                indent = item[1]
            if not line.startswith((f"{indent}-", f"{indent} ")):
                break
            last = end + 1
        end += 1
    ending = "\r\n" if "\r\n" in text else "\n"
    if last and not lines[last - 1].endswith("\n"):
        lines[last - 1] += ending
    added = [f"{indent or ''}{line}{ending}" for line in entry.splitlines()]
    return "".join([*lines[:last], *added, *lines[last:]])


def _propose(path: Path, shown: str, text: str, what: str, *, yes: bool) -> None:
    """Show what of *text* is new, and write it to *path* if the user agrees."""
    _say(f"{path} ({what}):\n\n{_indented(shown)}\n")
    if not yes and not _agrees(path):
        how = "" if _can_ask() else ": there is no terminal to ask on, and --yes is not given"
        _say(f"{path} is not written{how}.\n\n")
        return
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with replacement(path) as stream:
            stream.write(text.encode())
    except OSError as error:
        raise UsageError(f"cannot write {path}: {error.strerror or error}") from None
    _say(f"{path} is written.\n\n")


def _agrees(path: Path) -> bool:
    """Ask on a terminal whether to write *path*; elsewhere the answer is no."""
    if not _can_ask():
        return False
    _say(f"Write {path}? [y/N] ")
    sys.stdout.flush()
    return sys.stdin.readline().strip().lower() in ("y", "yes")


def _can_ask() -> bool:
    return sys.stdin.isatty() and sys.stdout.isatty()


def _indented(text: str) -> str:
    return "".join(f"    {line}" for line in text.splitlines(keepends=True))


def _say(text: str) -> None:
    sys.stdout.write(text)
