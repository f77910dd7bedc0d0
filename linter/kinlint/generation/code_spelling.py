"""Spelling of names and numbers of models in programs, whatever characters they have."""

from __future__ import annotations

import math
import re
import string
from collections.abc import Iterable, Mapping

from markupsafe import Markup

PLAIN = re.compile(r"[^A-Za-z0-9_]+")
HARMLESS = frozenset((string.ascii_letters + string.digits + " _.,:;/#@+=()-").encode())
"""Bytes that mean themselves in a literal of C++."""
UNSPOKEN = re.compile(r"[^A-Za-z0-9 _.,:;/#@+=()<>{}~-]")


class Code(Markup):
    """Text of a program; templates write no other text that comes from a model."""

    __slots__ = ()


def number(value: float) -> Code:
    """Return a finite number such that C++ and Python read the same one. Raises `ValueError`."""
    if not math.isfinite(value):
        raise ValueError(f"{value} is no number of a program")
    return Code(repr(value))


def python_string(text: str) -> Code:
    """Return *text* as a literal of Python."""
    return Code(ascii(str(text)))


def cpp_string(text: str) -> Code:
    """Return *text* as a literal of C++, byte by byte in UTF-8."""
    code = "".join(
        chr(byte) if byte in HARMLESS else f"\\{byte:03o}"
        for byte in str(text).encode("utf-8", "surrogatepass")
    )
    return Code(f'"{code}"')


def comment(text: str) -> Code:
    """Return *text* for a comment of one line: what might end it is percent-encoded."""

    def encoded(found: re.Match[str]) -> str:
        return "".join(f"%{byte:02X}" for byte in found[0].encode("utf-8", "surrogatepass"))

    return Code(UNSPOKEN.sub(encoded, str(text)))


def identifiers(iris: Iterable[str]) -> Mapping[str, Code]:
    """Return an identifier of C++ and Python for each of *iris*, all different.

    They end in an underscore, as no keyword, macro of a library or name of a template does.
    """
    found: dict[str, Code] = {}
    taken: set[str] = set()
    for iri in sorted(set(iris)):
        local = re.split(r"[#/:]", iri.rstrip("#/:"))[-1]
        plain = re.sub(r"__+", "_", PLAIN.sub("_", local)).strip("_")
        base = plain if plain[:1].isalpha() else f"n{plain}"
        name, count = f"{base}_", 1
        while name in taken:
            count += 1
            name = f"{base}_{count}_"
        taken.add(name)
        found[iri] = Code(name)
    return found
