"""Packages and xacro arguments that a run names and that are not there."""

from __future__ import annotations

import sys
from argparse import Namespace
from collections.abc import Sequence

from kinlint.cli.installed_findings import missing_packages
from kinlint.cli.xacro_arguments import check_arguments
from kinlint.configuration.settings import Settings
from kinlint.formats.options import ReadOptions
from kinlint.text import SourceText


def tell_unknown(options: Namespace, sources: Sequence[SourceText], settings: Settings) -> None:
    """Write a warning for each package and each xacro argument that a run names in vain.

    Raises `UsageError` for a slip of an argument that the xacro files among *sources* take.
    """
    quiet = options.quiet or options.silent
    if not quiet:
        packages_of = ReadOptions.from_settings(settings).packages_of
        lines = missing_packages(sources, packages_of)
        sys.stderr.writelines(f"kinlint: warning: {line}\n" for line in lines)
    check_arguments(options, sources, settings, quiet=quiet)
