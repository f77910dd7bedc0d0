"""`kinlint load`: puts models into a triple store."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from kinlint import garbage
from kinlint.addresses import document_of
from kinlint.catalogue import rulebook
from kinlint.catalogue.rulebook import Rulebook
from kinlint.cli.argument_parser import Parser, add_store
from kinlint.cli.model_inputs import add_input_options, find_inputs
from kinlint.cli.progress import ProgressBar
from kinlint.cli.xacro_arguments import take_arguments
from kinlint.configuration.settings import Settings
from kinlint.errors import InternalError, KinlintError, SourceError, UsageError
from kinlint.files.url_mirror import mirrored
from kinlint.phases import Phases
from kinlint.project.discovery import Found
from kinlint.project.layers import cache_directory
from kinlint.terms import Term, Triple
from kinlint.text import SourceText

if TYPE_CHECKING:
    from kinlint.document import Document
    from kinlint.endpoint.source_record import StoredDocument
    from kinlint.formats.options import ReadOptions

DESCRIPTION = """\
Put models into a triple store: each document as one named graph, with the text
and the places of its statements, so that `kinlint check --endpoint` finds what
`kinlint check` finds in the files, at the same places. A document that is
loaded again replaces its graph as a whole. Graphs are named after the files as
they are named here."""
EPILOG = """\
Credentials: KINLINT_ENDPOINT_USER and KINLINT_ENDPOINT_PASSWORD, or
KINLINT_ENDPOINT_TOKEN, or ~/.netrc.
Exit code: 0 loaded; 2 if a file cannot be read or the store refuses it."""


def parser() -> Parser:
    """The parser of `kinlint load`."""
    made = Parser(
        prog="kinlint load",
        description=DESCRIPTION,
        epilog=EPILOG,
        usage="kinlint load FILE... --endpoint URL [options]",
    )
    made.add_positionals("paths", "FILE", "the models: files, directories or globs")
    add_store(made, "Store")
    add_input_options(made.add_argument, "add the vocabulary of the rules in DIR")
    return made


def run(arguments: Sequence[str]) -> int:
    """Load what *arguments* name; the exit code."""
    options = parser().read(arguments)
    take_arguments(options)
    if not options.endpoint or not (options.paths or options.stdin_filename):
        raise UsageError("expected files and --endpoint URL")

    from kinlint.endpoint.connection import Endpoint, EndpointError  # noqa: PLC0415
    from kinlint.endpoint.loading import Loader  # noqa: PLC0415

    found, settings = find_inputs(options)
    cache = cache_directory(os.environ, options.cache_dir)
    book = rulebook.load(settings.rules, settings.shapes, cache)
    loader = Loader(Endpoint.from_options(options, os.environ))
    count, errors = 0, list[SourceError]()
    try:
        bar = ProgressBar(len(found.inputs), wanted=True, title="Loading")
        with bar, garbage.only_new():
            sources = _sources(found, settings, book, bar, errors)
            for more in loader.load(_models(sources, settings, errors, bar), errors.append):
                count += more
    except EndpointError as error:
        raise EndpointError(f"{error} ({_counted(count)} before)") from None
    finally:
        for each in errors:
            sys.stderr.write(f"kinlint: error: {each}\n")
    sys.stdout.write(
        f"{_counted(count).capitalize()}; the store is at revision {loader.newest()}.\n"
    )
    return 2 if errors else 0


def _counted(documents: int) -> str:
    return f"loaded {documents:,} document{'s' * (documents != 1)}"


def _sources(
    found: Found, settings: Settings, book: Rulebook, bar: ProgressBar, errors: list[SourceError]
) -> Sequence[SourceText]:
    """Return the files *found*, unread where no other file has to be found for one of them."""
    from kinlint.cli.lint_run import LintRun  # noqa: PLC0415  help does without
    from kinlint.parallel.shard import Job  # noqa: PLC0415
    from kinlint.parallel.survey import survey_found  # noqa: PLC0415

    job = Job(settings, book, roots=mirrored())
    unread = survey_found(found, job, 1, "", bar.advance, [])
    sources, failed = unread or LintRun(settings, found, book, Phases()).read_sources()
    errors.extend(failed)
    return sources


def _models(
    sources: Sequence[SourceText], settings: Settings, errors: list[SourceError], bar: ProgressBar
) -> Iterator[list[StoredDocument]]:
    """Yield the documents of *sources*, model by model; what cannot be read goes to *errors*."""
    from kinlint.endpoint.source_record import StoredDocument  # noqa: PLC0415
    from kinlint.endpoint.storable import refused  # noqa: PLC0415  loads the engine
    from kinlint.formats.options import ReadOptions  # noqa: PLC0415
    from kinlint.missing_files import references  # noqa: PLC0415
    from kinlint.parallel.partition import partition  # noqa: PLC0415

    options = ReadOptions.from_settings(settings)
    for model in partition(sources, settings):
        documents = [*_documents(model, options, errors)]
        own = [each for each in documents if not each.source.companion]
        looked_up: dict[Term, list[Triple]] = {each.graph: [] for each in documents}
        for triple in references(own, options.packages_of):
            looked_up.get(document_of(triple[0]), looked_up[own[0].graph]).append(triple)
        if documents:
            yield [
                StoredDocument(each, refused(each.statements), looked_up[each.graph])
                for each in documents
            ]
        bar.advance(len(model))


def _documents(
    model: Sequence[SourceText], options: ReadOptions, errors: list[SourceError]
) -> Iterator[Document]:
    """Yield what the files of *model* state."""
    from kinlint.formats.registry import read  # noqa: PLC0415  help does without
    from kinlint.parallel.unread import texts  # noqa: PLC0415

    for source in model:
        try:
            (text,) = texts([source])
            yield read(text, options)
        except SourceError as error:
            if not source.companion:
                errors.append(error)
        except KinlintError:
            raise
        except Exception as error:  # noqa: BLE001  the other files are loaded all the same
            errors.append(InternalError.from_exception(source.name, error))
