"""`kinlint contexts`: lists the contexts that models may name, and adds one."""

from __future__ import annotations

import json
import sys
from argparse import Namespace
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from kinlint.cli.argument_parser import Parser
from kinlint.cli.context_download import download, is_address
from kinlint.cli.project_rules import found_config
from kinlint.configuration.context_entry import ContextEntry
from kinlint.contexts.context_library import COMMUNITY, NEWEST, Contexts, Extra, bundled_source
from kinlint.errors import SourceError, UsageError
from kinlint.files.atomic_write import replacement
from kinlint.files.pathname import shown
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import read
from kinlint.terms import RDF_TYPE, iri, literal_value
from kinlint.text import SourceText
from kinlint.vocabulary import KINLINT, SRC

LARGEST = 1 << 22
"""The largest context that is added, in bytes."""
ADD = "add"


def parser() -> Parser:
    """The parser of `kinlint contexts`."""
    made = Parser(
        prog="kinlint contexts",
        description="List the JSON-LD contexts that models may name, or add a copy of one to the"
        " configuration. Only an address given to `add` is fetched from the network; models are"
        " read with the copies.",
        usage="kinlint contexts [add FILE-OR-URL [--for IRI]]",
    )
    made.add_positionals("words", "add FILE-OR-URL", "context to add")
    made.add_argument(
        "--for", dest="answers", metavar="IRI", help="IRI by which models refer to it"
    )
    return made


def run(arguments: Sequence[str]) -> int:
    """List what is known, or add a context, as *arguments* say; the exit code."""
    options = parser().read(arguments)
    if not options.words:
        sys.stdout.writelines(f"{line}\n" for line in _listed())
        return 0
    if options.words[0] != ADD or len(options.words) != 2:  # noqa: PLR2004  the word and its object
        raise UsageError("kinlint contexts lists them; kinlint contexts add FILE-OR-URL adds one")
    return _add(options.words[1], options)


def _listed() -> list[str]:
    config = found_config(trust=False)
    extra: list[Extra] = []
    if config is not None:
        extra += [*(config.context_directories or ()), *(config.extra_contexts or {}).items()]
    known = Contexts.bundled(None if config is None else config.contexts, extra)
    homes = {bundled_source(name)["base"]: name for name in COMMUNITY}
    homes |= {bundled_source(NEWEST)["base"]: f"release {known.release}", KINLINT: "kinlint"}
    width = max(map(len, known.iris))

    def home(name: str) -> str:
        if name in known.extra_documents:
            return "configured"
        return next((home for base, home in homes.items() if name.startswith(base)), "bundled")

    return [f"{name:<{width}}  {home(name)}" for name in known.iris]


def _add(given: str, options: Namespace) -> int:
    answers = options.answers or (given if is_address(given) else None)
    if answers is None:
        raise UsageError(f"say by which IRI models name it: kinlint contexts add {given} --for IRI")
    data = download(given, LARGEST) if is_address(given) else _content(Path(given))
    _check(data, given)
    try:
        entry = ContextEntry.for_iri(answers, Path.cwd())
        entry.path.parent.mkdir(parents=True, exist_ok=True)
        with replacement(entry.path) as stream:
            stream.write(data)
        if entry.text is not None:
            with replacement(entry.config) as stream:
                stream.write(entry.text.encode())
    except OSError as error:
        raise UsageError(f"cannot write {error.filename}: {error.strerror}") from None
    sys.stdout.write(f"Added '{answers}' as {shown(entry.path)}, by {shown(entry.config)}\n")
    return 0


def _content(path: Path) -> bytes:
    try:
        with path.open("rb") as stream:
            data = stream.read(LARGEST + 1)
    except OSError as error:
        raise UsageError(f"{path}: {error.strerror}") from None
    if len(data) > LARGEST:
        raise UsageError(f"{path}: more than {LARGEST >> 20} MiB")
    return data


def _check(data: bytes, given: str) -> None:
    """Raise `UsageError` if *data* is no JSON-LD context."""
    try:
        said: Any = json.loads(data)
    except (ValueError, RecursionError) as error:
        raise UsageError(f"{given}: not JSON: {error}") from None
    if not isinstance(said, dict) or "@context" not in said:
        raise UsageError(f"{given}: not a context document, it has no '@context'")
    model = {"@context": said["@context"], "@id": "urn:example:a", "urn:example:b": 1}
    try:
        document = read(SourceText(given, json.dumps(model)), ReadOptions())
    except SourceError as error:
        raise UsageError(f"{given}: {error.cause}") from None
    broken = {
        s for s, p, o in document.statements if (p, o) == (RDF_TYPE, iri(f"{SRC}InvalidContext"))
    }
    for subject, prop, value in document.statements:
        if subject in broken and prop == iri(f"{SRC}reason"):
            raise UsageError(f"{given}: not a context: {literal_value(value)}")
