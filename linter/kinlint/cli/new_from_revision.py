"""`--new-from-rev`, `--new-from-merge-base`: what would have been found at a revision."""

from __future__ import annotations

import os
import sys
from argparse import Namespace
from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path

from kinlint.baseline.entry_identity import Names, entry_of, relative
from kinlint.baseline.ledger import Ledger
from kinlint.catalogue.rulebook import Rulebook
from kinlint.cli.lint_run import LintRun, process_count
from kinlint.configuration.settings import FileSettings, Settings
from kinlint.files.pathglob import absolute
from kinlint.files.pathname import real
from kinlint.files.revision import Repository, Revision
from kinlint.formats.records import SEARCHED
from kinlint.light_dataclasses import dataclass, replace
from kinlint.phases import Phases
from kinlint.project.discovery import Found, Input, may_be_model
from kinlint.project.layers import Layers
from kinlint.project.revision_checkout import checkout, checkout_path


@dataclass(frozen=True)
class FindingsAtRevision:
    """A run, and the revision that it is compared to."""

    revision: Revision
    """The revision."""
    found: Found
    """The files of the run."""
    layers: Layers
    """The configuration of the run."""
    book: Rulebook
    """Its rules."""
    settings_of: Callable[[Found], Settings]
    """Returns the settings of a run over other files."""

    def ledger(self, options: Namespace) -> Ledger:
        """Lint the files as they were, by today's rules and settings."""
        revision, top = self.revision, self.revision.repository.top
        gone = {relative(path, top) for path in revision.deleted}
        renamed = {
            relative(then, top): relative(now, top)
            for now, then in revision.changed.items()
            if then is not None and then != now
        }
        now = Names(top)
        with checkout(revision) as root:
            inputs, homes = [], []
            for one, then, home in self._given():
                path = checkout_path(then, revision, root)
                inputs.append(Input(str(path), path, one.named))
                homes.append(Input(str(path), home, one.named))
                # A link is read, and reported, in place of the file that it leads to.
                renamed[relative(then, top)] = now.relative_path(one.name)
            for then in self._deleted(options.paths or ["."], root):
                path = checkout_path(then, revision, root)
                inputs.append(Input(str(path), path, named=False))
                homes.append(Input(str(path), then, named=False))
            settings = self._moved(
                self.settings_of(Found(homes, directories=self.found.directories)), root
            )
            run = LintRun(settings, Found(inputs), self.book, Phases())
            report = run.linted(process_count(options), fixing=False)
            names = Names(root, renamed)
            if not options.silent:
                self._warn(report.errors, names)
            entries = [entry_of(finding, names) for finding in report.findings]
        return Ledger(entries, now, gone.__contains__)

    def _given(self) -> Iterator[tuple[Input, Path, Path]]:
        """Each input, where it was then, and where it is now; links to files are followed."""
        for one in self.found.inputs:
            if one.path is None and one.name.startswith("<"):
                continue
            now = real(one.path or one.name)
            then = self.revision.changed.get(now, now)
            if then is not None:
                yield one, then, now

    def _deleted(self, given: Iterable[str], root: Path) -> Iterator[Path]:
        """The models that a search of the directories *given* would have found then."""
        tops = [path for each in given if (path := real(absolute(each))).is_dir()]
        for path in sorted(self.revision.deleted):
            if not path.name.lower().endswith(SEARCHED):
                continue
            if not may_be_model(checkout_path(path, self.revision, root)):
                continue
            top = next((top for top in tops if path.is_relative_to(top)), None)
            if top is not None and not self._excluded(path, top):
                yield path

    def _excluded(self, path: Path, top: Path) -> bool:
        way = [path, *(each for each in path.parents if each != top and each.is_relative_to(top))]
        return any(
            glob.matches(each) for each in way for glob in self.layers.exclusions(each.parent)
        )

    def _moved(self, settings: Settings, root: Path) -> Settings:
        """Return *settings* with the paths of the repository as it was, except rules and shapes."""

        def moved(path: Path) -> Path:
            return checkout_path(real(path), self.revision, root)

        def file(one: FileSettings) -> FileSettings:
            return replace(
                one,
                urdf=None if one.urdf is None else moved(one.urdf),
                packages=tuple((name, moved(path)) for name, path in one.packages),
                workspace=None if one.workspace is None else moved(one.workspace),
            )

        files: Mapping[str, FileSettings] = {
            name: file(one) for name, one in settings.files.items()
        }
        return replace(
            settings,
            extra_contexts={iri: moved(path) for iri, path in settings.extra_contexts.items()},
            context_directories=tuple(map(moved, settings.context_directories)),
            linted=tuple(map(moved, settings.linted)),
            default=file(settings.default),
            files=files,
            # Nothing will ever be asked of the snapshot again.
            cache=None,
        )

    def _warn(self, errors: Iterable[Exception], names: Names) -> None:
        for error in errors:
            name, cause = getattr(error, "name", ""), getattr(error, "cause", str(error))
            place = f"{names.relative_path(name)} at {self.revision.commit[:12]}"
            sys.stderr.write(
                f"kinlint: warning: {place}: {cause}; all that is found in it counts as new\n"
            )


def find_revision(options: Namespace, inputs: Iterable[Input]) -> Revision:
    """The revision that *options* name, of the repository that all *inputs* lie in.

    Raises UsageError if there is none.
    """
    folders = {str(real(one.path or one.name).parent) for one in inputs}
    repository = Repository.from_directory(
        Path(os.path.commonpath(folders)) if folders else Path.cwd()
    )
    if options.new_from_rev:
        return repository.revision(options.new_from_rev)
    return repository.merge_base(options.new_from_merge_base)
