"""The contents of a git repository at a revision, and the changes in the working tree since then.

Submodules are left out: they have a history of their own.
"""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from pathlib import Path
from shutil import copyfile

from kinlint.errors import UsageError
from kinlint.files.git import GitFailed, git
from kinlint.files.pathname import printable, real
from kinlint.light_dataclasses import dataclass
from kinlint.suggestion import did_you_mean

REGULAR, MODULE = b"100", b"160000"
"""First digits of the modes of regular files, and the mode of submodules."""
SHALLOW = "; the clone is shallow: git fetch --unshallow, or fetch-depth: 0 for actions/checkout"


@dataclass(frozen=True)
class Repository:
    """A working tree of git; `top` is the directory that it begins in, links followed."""

    top: Path
    """Top directory of the working tree, links followed."""

    @classmethod
    def from_directory(cls, directory: Path) -> Repository:
        """Return the repository that *directory* lies in.

        Raises UsageError where there is none, or git refuses to look at it.
        """
        while not directory.is_dir() and directory != directory.parent:
            directory = directory.parent
        try:
            top = os.fsdecode(git(directory, ["rev-parse", "--show-toplevel"])).rstrip("\r\n")
        except GitFailed as error:
            where = printable(str(directory))
            raise UsageError(f"no revision is known of {where}: {error}") from None
        return cls(real(top))

    @cached_property
    def store(self) -> Path:
        """The directory that all working trees of the repository share."""
        output = git(self.top, ["rev-parse", "--git-common-dir"])
        return self.top / os.fsdecode(output).rstrip("\r\n")

    def revision(self, name: str) -> Revision:
        """Return the commit that *name* stands for.

        Raises UsageError if there is none.
        """
        return Revision(self, self._commit(name))

    def merge_base(self, name: str) -> Revision:
        """Return the last commit that *name* and the one that is checked out have in common.

        Raises UsageError if there is none.
        """
        theirs, ours = self._commit(name), self._commit("HEAD")
        try:
            found = git(self.top, ["merge-base", ours, theirs]).decode().split()
        except GitFailed:
            found = []
        if not found:
            raise UsageError(
                f"'{printable(name)}' and HEAD have no commit in common{self._shallow()}"
            )
        return Revision(self, found[0])

    def _commit(self, name: str) -> str:
        # No name of a revision begins with a dash, so it cannot be taken for an option.
        if name and not name.startswith("-") and "\0" not in name:
            try:
                output = git(self.top, ["rev-parse", "--verify", "--quiet", f"{name}^{{commit}}"])
            except GitFailed:
                pass
            else:
                return output.decode().strip()
        raise UsageError(
            f"unknown revision '{printable(name)}'{self._shallow() or self._hint(name)}"
        )

    def _shallow(self) -> str:
        output = git(self.top, ["rev-parse", "--is-shallow-repository"])
        return SHALLOW if output.strip() == b"true" else ""

    def _hint(self, name: str) -> str:
        output = git(self.top, ["for-each-ref", "--format=%(refname:short)"])
        return did_you_mean(name, output.decode("utf-8", "replace").split())


@dataclass(frozen=True)
class Revision:
    """A commit of a repository."""

    repository: Repository
    """The repository."""
    commit: str
    """Its full name, in hexadecimal digits."""

    @cached_property
    def files(self) -> Mapping[Path, str]:
        """The regular files that were there, and what git calls their contents."""
        return {path: blob for path, mode, blob in self._tree if mode.startswith(REGULAR)}

    @cached_property
    def submodules(self) -> Sequence[Path]:
        """Return the paths of submodules."""
        return [path for path, mode, _ in self._tree if mode == MODULE]

    @cached_property
    def ignored(self) -> Sequence[Path]:
        """Return the files and directories in the working tree that git ignores."""
        words = ["ls-files", "-z", "--others", "--ignored", "--exclude-standard", "--directory"]
        output = git(self._top, words).split(b"\0")
        return [self._path(name) for name in output if name]

    @cached_property
    def _tree(self) -> Sequence[tuple[Path, bytes, str]]:
        """Path, mode and content of each file."""
        output = git(self._top, ["ls-tree", "-r", "-z", "--full-tree", self.commit])
        found = []
        for line in output.split(b"\0")[:-1]:
            about, _, name = line.partition(b"\t")
            mode, _, blob = about.split()
            found.append((self._path(name), mode, blob.decode()))
        return found

    @cached_property
    def changed(self) -> Mapping[Path, Path | None]:
        """The files of the working tree that differ, each with what it was called then.

        None for those that are new; files that git ignores are none of them.
        """
        return {path: before for path, before, _ in self._changes if path is not None}

    @cached_property
    def deleted(self) -> frozenset[Path]:
        """Return the files that were deleted since, renamed ones excluded."""
        return frozenset(before for path, before, _ in self._changes if path is None and before)

    def read(self, paths: Iterable[Path]) -> Mapping[Path, bytes]:
        """Return the contents of the files at *paths*; those that did not exist are left out."""
        wanted = [path for path in dict.fromkeys(paths) if path in self.files]
        return dict(zip(wanted, self._contents(self.files[path] for path in wanted)))  # noqa: B905

    def _contents(self, blobs: Iterable[str]) -> Iterator[bytes]:
        asked = "".join(f"{blob}\n" for blob in blobs).encode()
        if not asked:
            return
        try:
            output = git(self._top, ["cat-file", "--batch"], asked)
        except GitFailed as error:
            raise UsageError(f"revision {self.commit[:12]} cannot be read: {error}") from None
        at = 0
        while at < len(output):
            end = output.index(b"\n", at)
            _, kind, size = [*output[at:end].split(), b"", b""][:3]
            if kind != b"blob":
                raise UsageError(
                    f"revision {self.commit[:12]} is not all here: a partial clone has to fetch it"
                )
            at = end + 1 + int(size)
            yield output[end + 1 : at]
            at += 1

    @cached_property
    def _changes(self) -> list[tuple[Path | None, Path | None, bytes]]:
        """Pairs of a path now and a path then, either of them None, and what git calls it."""
        others = git(self._top, ["ls-files", "-z", "--others", "--exclude-standard"])
        new = [name for name in others.split(b"\0") if name]
        found = list(self._compared({}))
        if new and any(now is None for now, _, _ in found):
            # A file that was renamed without telling git is one that is gone and one that is new.
            found = self._told_of(others)
        else:
            found += [(self._path(name), None, b"A") for name in new]
        return found

    def _told_of(self, names: bytes) -> list[tuple[Path | None, Path | None, bytes]]:
        """Return the changes that git would see if the files called *names* were added."""
        own = self._of_git("index")
        with tempfile.TemporaryDirectory(prefix="kinlint") as scratch:
            copy = Path(scratch) / "index"
            if own.is_file():
                copyfile(own, copy)
            # Even an empty file that git is output of is written to where objects are kept.
            kept = str(self._of_git("objects")).replace("\\", "\\\\").replace('"', '\\"')
            other = {
                "GIT_INDEX_FILE": str(copy),
                "GIT_OBJECT_DIRECTORY": scratch,
                "GIT_ALTERNATE_OBJECT_DIRECTORIES": f'"{kept}"',
            }
            intent = ["add", "--intent-to-add", "--pathspec-from-file=-", "--pathspec-file-nul"]
            try:
                git(self._top, intent, names, other)
            except GitFailed:
                other = {}
            return list(self._compared(other))

    def _compared(
        self, more: Mapping[str, str]
    ) -> Iterator[tuple[Path | None, Path | None, bytes]]:
        words = ["diff", "--raw", "-z", "-M", "--no-ext-diff", "--no-textconv", "--no-relative"]
        words += ["--no-color", "--ignore-submodules=all", self.commit, "--"]
        parts = iter(git(self._top, words, more=more).split(b"\0"))
        for about in parts:
            if not about:
                return
            status = about.split()[-1][:1]
            first = self._path(next(parts))
            if status in (b"R", b"C"):
                yield self._path(next(parts)), first if status == b"R" else None, status
            elif status == b"D":
                yield None, first, status
            else:
                yield first, None if status == b"A" else first, status

    def _of_git(self, name: str) -> Path:
        """Return the file or directory *name* of those that git keeps for the working tree."""
        output = git(self._top, ["rev-parse", "--git-path", name])
        return self._top / os.fsdecode(output).rstrip("\r\n")

    @property
    def _top(self) -> Path:
        return self.repository.top

    def _path(self, name: bytes) -> Path:
        return self._top / os.fsdecode(name)
