"""Findings in installed files, which are counted, and missing packages, which are told once."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from kinlint.files.installed_files import is_installed
from kinlint.files.packages import Packages
from kinlint.files.pathglob import absolute
from kinlint.finding import Finding
from kinlint.formats.dependencies.named_packages import named_packages
from kinlint.light_dataclasses import replace
from kinlint.report import Report
from kinlint.reporters.summary import plural
from kinlint.text import SourceText

MOST = 3
"""Largest number of missing packages that are told one by one."""


def without_installed(report: Report, named: Iterable[str]) -> Report:
    """Return *report* without findings in installed files, but for those *named*; it counts them.

    Nobody who uses such a file can change it.
    """
    given, known = frozenset(named), dict[str, bool]()

    def listed(finding: Finding) -> bool:
        name = finding.location.source.name
        if name not in known:
            known[name] = name in given or not is_installed(absolute(name))
        return known[name]

    kept = tuple(filter(listed, report.findings))
    if len(kept) == len(report.findings):
        return report
    return replace(
        report,
        findings=kept,
        suppressed=tuple(filter(listed, report.suppressed)),
        installed=len(report.findings) - len(kept),
    )


def missing_packages(
    sources: Iterable[SourceText], packages_of: Callable[[str], Packages]
) -> Iterator[str]:
    """Yield a line for each package that *sources* name and that *packages_of* has not.

    Many are one line: who has no workspace at hand misses all of them.
    """
    lost: dict[str, list[str]] = {}
    for (name, found), files in named_packages(sources, packages_of).items():
        if found is None:
            lost.setdefault(name, []).extend(files)
    if len(lost) > MOST:
        some = ", ".join(f"'{name}'" for name in sorted(lost)[:MOST])
        naming = {file for files in lost.values() for file in files}
        verb = "name" if naming - {min(naming)} else "names"
        yield (
            f"{len(lost)} packages were not found, which {plural(len(naming), 'file')} {verb}:"
            f" {some} and {plural(len(lost) - MOST, 'other')}; source their workspace, or add"
            " --package NAME=DIR"
        )
        return
    for name, files in sorted(lost.items()):
        more = f" and {plural(len(files) - 1, 'other file')}" if files[1:] else ""
        yield (
            f"package '{name}' was not found, which {min(files)}{more}"
            f" {'name' if more else 'names'}; source its workspace, or add --package {name}=DIR"
        )
