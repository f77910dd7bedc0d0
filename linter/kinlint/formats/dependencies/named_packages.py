"""Names of the ROS packages that texts refer to, and where these packages are."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable

from kinlint.files.packages import PackageLocation, Packages
from kinlint.files.pathglob import absolute
from kinlint.formats.launch.format import LAUNCH
from kinlint.text import XML_COMMENT, SourceText

_NAMED = re.compile(r"package://([\w.-]+)/|\$\(find(?:-pkg-share)?\s+([\w.-]+)\s*\)")


def named_packages(
    sources: Iterable[SourceText], packages_of: Callable[[str], Packages]
) -> dict[tuple[str, PackageLocation | None], list[str]]:
    """Return the packages that *sources* name, where each is, and the files that name it.

    Those that launch files name need not be there: they are none of the robot.

    A package that is not found is there with None. *packages_of* returns the packages that a file,
    by its name, can name.
    """
    found: dict[tuple[str, PackageLocation | None], list[str]] = {}
    for source in sources:
        if source.format == LAUNCH:
            continue
        text = XML_COMMENT.sub("", source.text)
        names = {one or other for one, other in _NAMED.findall(text)}
        for name in sorted(names):
            place = packages_of(source.name).locate(name, absolute(source.name).parent)
            found.setdefault((name, place), []).append(source.name)
    return found
