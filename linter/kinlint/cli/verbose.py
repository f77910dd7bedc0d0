"""The lines of `-v`: configuration before a run, and its results."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator

from kinlint import __version__
from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.settings import Settings
from kinlint.contexts.context_library import RELEASE_DATES
from kinlint.formats.launch.format import LAUNCH
from kinlint.report import Report
from kinlint.reporters.summary import plural
from kinlint.rule import PLACEHOLDER
from kinlint.text import SourceText

ENGINES = {"oxigraph": ("pyoxigraph",), "pyshacl": ("pyshacl", "rdflib", "owlrl")}


def lines_before(settings: Settings, book: Rulebook, origins: Iterable[str]) -> Iterator[str]:
    """Lines that say by what a run goes; *origins* are the configurations it found."""
    files = [origin for origin in dict.fromkeys(origins) if origin != "defaults"]
    python = ".".join(map(str, sys.version_info[:3]))
    release = settings.contexts or ""
    yield f"kinlint {__version__}, Python {python} on {sys.platform}"
    yield f"configuration: {', '.join(files) or 'none (defaults)'}"
    yield f"contexts: release {release} ({RELEASE_DATES.get(release, 'of unknown date')})"
    yield f"engine: {', '.join(map(_version, ENGINES[settings.engine]))}"
    cache = "recalled" if book.recalled else "compiled"
    counts = (
        plural(len(book.rules), "rule"),
        plural(len(book.constraints), "constraint"),
    )
    yield f"catalogue: {counts[0]} with {counts[1]}, {cache}"
    if settings.engine == "oxigraph":
        for each in book.constraints:
            if each.deferred is not None:
                yield f"deferred to pySHACL: a constraint of {each.owner}, {each.deferred}"


def lines_of_files(
    read: Iterable[SourceText], paired: Iterable[SourceText], settings: Settings
) -> Iterator[str]:
    """Lines that say which packages and robots the files of a run depend on, and how it reads."""
    sources = list(read)
    yield from package_lines(sources, settings)
    yield from pairing_lines(paired)
    yield from expansion_lines(sources, settings)


def expansion_lines(sources: Iterable[SourceText], settings: Settings) -> Iterator[str]:
    """Lines that say what of JSON-LD files among *sources* PyLD expands, and why."""
    from kinlint.formats.jsonld.format import JSONLD  # noqa: PLC0415
    from kinlint.formats.recognition import with_format  # noqa: PLC0415

    models = [each for each in sources if with_format(each).format == JSONLD]
    if not models:
        return
    from kinlint.formats.jsonld.reader import expanded_by_pyld  # noqa: PLC0415  loads PyLD
    from kinlint.formats.options import ReadOptions  # noqa: PLC0415  loads the contexts

    options = ReadOptions.from_settings(settings)
    for each in models:
        found = expanded_by_pyld(each, options)
        if found:
            why = ", ".join(f"{reason} ({count:,})" for reason, count in sorted(found.items()))
            parts = plural(sum(found.values()), "part")
            yield f"expanded by PyLD: {parts} of {each.name}, because of {why}"


def package_lines(sources: Iterable[SourceText], settings: Settings) -> Iterator[str]:
    """Lines that say where each package that *sources* name was found."""
    from kinlint.formats.dependencies.named_packages import named_packages  # noqa: PLC0415
    from kinlint.formats.options import ReadOptions  # noqa: PLC0415  loads the contexts

    packages_of = ReadOptions.from_settings(settings).packages_of
    for name, found in sorted(named_packages(sources, packages_of), key=str):
        if found is not None:
            yield f"package {name}: {found.directory}, found {found.origin}"


def pairing_lines(paired: Iterable[SourceText]) -> Iterator[str]:
    """Lines that say by which URDF each file among *paired* is judged, and why.

    Launch files name theirs, each with its arguments.
    """
    for each in paired:
        pairing = each.pairing
        if each.format == LAUNCH:
            continue
        if pairing is None or not pairing.partner:
            yield f"robot of {each.name}: not found"
        elif pairing.certain:
            yield f"robot of {each.name}: {pairing.partner}, because {pairing.reason}"
        else:
            names = ", ".join((pairing.partner, *pairing.others))
            yield f"robot of {each.name}: one of {names}, so only names that none of them has count"


def lines_after(report: Report, settings: Settings, book: Rulebook) -> Iterator[str]:
    """Lines that say what was read, applied and spent."""
    asked = {rule.code for rule in report.rules}
    silent = [rule.code for rule in book.rules if rule.code not in asked]
    read = plural(len(report.files), "file"), plural(report.triples, "triple")
    unread = f"; {plural(len(report.errors), 'file')} could not be read" if report.errors else ""
    yield f"read: {read[0]} with {read[1]}{unread}"
    if report.recalled is not None:
        yield f"recalled: {report.recalled:,} of these, from {settings.cache}"
    off = f"; not {', '.join(silent)}" if silent else ""
    yield f"applied: {report.applied:,} of {plural(len(book.rules), 'rule')}{off}"
    for finding, repair, why in report.unfixed:
        source, start = finding.location.source, finding.location.start
        place = f"{source.name}:{start.line}:{start.column}"
        title = PLACEHOLDER.sub("...", repair.title).replace("'...'", "...")
        yield f"{finding.rule.code} at {place} has no fix '{title}': {why}"
    if report.seconds is not None:
        yield f"time: {report.seconds:.3f} s"


def _version(distribution: str) -> str:
    from importlib.metadata import PackageNotFoundError, version  # noqa: PLC0415  slow, rare

    try:
        return f"{distribution} {version(distribution)}"
    except PackageNotFoundError:
        return distribution
