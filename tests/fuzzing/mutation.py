"""Random changes to a text: of bytes, tokens, numbers and structure."""

from __future__ import annotations

import re
from collections.abc import Callable
from random import Random

TOKEN = re.compile(rb"[A-Za-z_][\w.:-]*|-?\d[\w.+-]*|\"[^\"]*\"|<[^<>]*>|\s+|.", re.DOTALL)
NUMBER = re.compile(rb"-?\d+(?:\.\d*)?(?:[eE][+-]?\d+)?")
BRACKETS = re.compile(rb"[\[\]{}()<>]")
NUMBERS = (
    *(b"0", b"-0", b"-1", b"1e400", b"-1e400", b"1e-400", b"NaN", b"inf", b"-Infinity", b"nan"),
    *(b"1e16", b"0.1", b"9" * 400, b"1_000", b"0x10", b"1,5", b"", b"null", b"true", b"1e", b"--1"),
)
PIECES = (
    *(
        b"\0",
        b"\xff\xfe",
        b"\xed\xa0\x80",
        b"\xef\xbb\xbf",
        b"\xe2\x80\xae",
        b"\x1b[2J",
        b"\r",
        b"\r\n",
    ),
    *(b"null", b"[]", b"{}", b'""', b'"@id"', b'"@type"', b'"@list"', b'"@context"', b'"@graph"'),
    *(
        b"<a/>",
        b"<!--",
        b"-->",
        b"<![CDATA[",
        b"&amp;",
        b"&#0;",
        b"&x;",
        b"<?xml?>",
        b"<!DOCTYPE r>",
    ),
    *(
        b"${",
        b"}",
        b"$(arg x)",
        b"${1/0}",
        b"${[",
        b"xacro:",
        b"__model__",
        b"::",
        b"model://",
        b"../",
    ),
    *(b"\xf0\x9f\xa6\xbe", b" " * 300, b"\t", b"'", b"\\", b"#", b"%", b"a" * 3000),
)

Mutation = Callable[[bytes, bytes, Random], bytes]


def flip(text: bytes, _: bytes, random: Random) -> bytes:
    """Change one byte."""
    at = random.randrange(len(text))
    return text[:at] + bytes([random.randrange(256)]) + text[at + 1 :]


def cut(text: bytes, _: bytes, random: Random) -> bytes:
    """Leave out what stands between two places, or all after one."""
    start = random.randrange(len(text))
    end = random.choice([len(text), min(len(text), start + random.randrange(1, 200))])
    return text[:start] + text[end:]


def insert(text: bytes, _: bytes, random: Random) -> bytes:
    """Put a piece that is special to some format anywhere."""
    at = random.randrange(len(text) + 1)
    return text[:at] + random.choice(PIECES) + text[at:]


def number(text: bytes, _: bytes, random: Random) -> bytes:
    """Replace a number by an unusual one."""
    return _replaced(text, NUMBER, random, lambda _: random.choice(NUMBERS))


def bracket(text: bytes, _: bytes, random: Random) -> bytes:
    """Remove, repeat or replace a bracket."""
    choices = (b"", b"[", b"]", b"{", b"}", b"<", b">", b"/>")
    return _replaced(text, BRACKETS, random, lambda old: random.choice([old * 2, *choices]))


def token(text: bytes, other: bytes, random: Random) -> bytes:
    """Replace a token by one of another file."""
    given = TOKEN.findall(other)
    return _replaced(text, TOKEN, random, lambda _: random.choice(given))


def move(text: bytes, _: bytes, random: Random) -> bytes:
    """Copy a part of the text to another place in it."""
    start = random.randrange(len(text))
    part = text[start : start + random.randrange(1, 400)]
    at = random.randrange(len(text))
    return text[:at] + part + text[at:]


def splice(text: bytes, other: bytes, random: Random) -> bytes:
    """Go on with another file from a place in the text."""
    return text[: random.randrange(len(text))] + other[random.randrange(len(other)) :]


def nest(text: bytes, _: bytes, random: Random) -> bytes:
    """Repeat an opening, so that the text nests deeply."""
    opening = random.choice([b"[", b"{", b'{"a":', b"<a>", b"(", b"${", b"<link>", b'[{"@graph":'])
    at = random.randrange(len(text))
    return text[:at] + opening * random.choice([3, 300, 5000]) + text[at:]


def encode(text: bytes, _: bytes, random: Random) -> bytes:
    """Write the text in another encoding, or with other ends of lines."""
    way = random.choice(["utf-16", "utf-32", "latin-1", "cr", "crlf"])
    if way in ("cr", "crlf"):
        return text.replace(b"\n", b"\r\n" if way == "crlf" else b"\r")
    return text.decode("utf-8", "replace").encode(way, "replace")


def _replaced(
    text: bytes, pattern: re.Pattern[bytes], random: Random, by: Callable[[bytes], bytes]
) -> bytes:
    places = [match.span() for match in pattern.finditer(text)]
    if not places:
        return text
    start, end = random.choice(places)
    return text[:start] + by(text[start:end]) + text[end:]


MUTATIONS: tuple[Mutation, ...] = (
    *(flip, cut, insert, number, bracket, token, move, splice),
    *(number, bracket, token, nest, encode),
)
LARGEST = 100_000


def mutated(text: bytes, other: bytes, random: Random) -> bytes:
    """Return *text* with one to six changes; *other* is a text that some of them take from."""
    for _ in range(random.choice([1, 1, 1, 2, 3, 6])):
        text = random.choice(MUTATIONS)(text or b" ", other, random)
    return text[:LARGEST]
