"""Paths of prims in a stage: `/arm/base`, and of properties: `/arm/base.physics:mass`."""

from __future__ import annotations

import re
from functools import lru_cache

from kinlint.addresses import child_address
from kinlint.terms import Term, iri


def absolute_path(written: str, around: str) -> str:
    """Return the absolute form of a path *written* in the prim at *around*.

    Empty if it leads out of the stage, or is none.
    """
    prim, dot, property_ = _divided(written)
    steps = [] if prim.startswith("/") else [each for each in around.split("/") if each]
    for step in prim.split("/"):
        if step == "..":
            if not steps:
                return ""
            steps.pop()
        elif step not in ("", "."):
            steps.append(step)
    return f"/{'/'.join(steps)}{dot}{property_}"


def is_path(written: str) -> bool:
    """Tell whether OpenUSD reads *written* as a path; of one with brackets, nothing is known."""
    prim, _, property_ = _divided(written)
    if not prim or not _BRACKETS.isdisjoint(prim):
        return not _SPACES.search(written)
    steps = prim.removeprefix("/").split("/") if prim != "/" else []
    is_plain = all(each in ("..", ".") or each.isidentifier() for each in steps)
    return is_plain and not _SPACES.search(property_)


def _divided(written: str) -> tuple[str, str, str]:
    """Return the path of the prim, and the property behind a dot, if there is one."""
    at = written.find(".", written.rfind("/") + 1)
    if at >= 0 and written[at : at + 2] == "..":
        at = -1
    if at < 0 or written == ".":
        return written, "", ""
    return written[:at], ".", written[at + 1 :]


_BRACKETS = frozenset("{}[]")
_SPACES = re.compile(r"\s")


@lru_cache(maxsize=100_000)
def prim_address(document: Term, path: str) -> Term:
    """Return the node of the prim at the absolute *path* in the stage of *document*."""
    address = f"{document[1:-1]}#"
    for step in path.split("/")[1:]:
        if step:
            address = child_address(address, "prim", step)
    return iri(address)


def parent(path: str) -> str:
    """Return the path of the prim around the one at *path*; "/" for one at the top."""
    return path.rpartition("/")[0] or "/"


def joined(path: str, name: str) -> str:
    """Return the path of the prim *name* in the one at *path*."""
    return f"{path.rstrip('/')}/{name}"


def is_within(path: str, outer: str) -> bool:
    """Tell whether *path* is *outer* or below it."""
    return outer in (path, "/") or path.startswith(f"{outer}/")


def ancestors(path: str) -> list[str]:
    """Return the paths of the prims around the one at *path*, the nearest first, not the root."""
    found = []
    while (path := parent(path)) != "/":
        found.append(path)
    return found
