"""Mutated JSON-LD, expanded by the compiled walk and by PyLD: both have to read the same."""

from __future__ import annotations

import json
from collections.abc import Iterator
from functools import cache
from random import Random
from typing import Any

from fuzzing.corpus import corpus
from kinlint.document import Document
from kinlint.errors import SourceError
from kinlint.formats.jsonld.reader import read
from kinlint.formats.options import ReadOptions
from kinlint.text import SourceText

EX = "https://x.example/"
CONTEXT = {
    "ex": EX,
    "Part": {"@id": "ex:Part", "@context": {"of": {"@id": "ex:of-part", "@type": "@id"}}},
    "Kind": {"@id": "ex:Kind", "@context": {"@propagate": True, "size": "ex:kind-size"}},
    "of": {"@id": "ex:of", "@type": "@id"},
    "unit": {"@id": "ex:unit", "@type": "@vocab"},
    "M": "ex:Metre",
    "size": {"@id": "ex:size", "@type": "http://www.w3.org/2001/XMLSchema#double"},
    "parts": {"@id": "ex:parts", "@container": "@list", "@type": "@id"},
    "bag": {"@id": "ex:bag", "@container": "@set"},
    "title": {"@id": "ex:title", "@language": "en"},
    "inner": {"@id": "ex:inner", "@context": {"size": "ex:inner-size", "id": "@id"}},
    "type": "@type",
    "Thing": "ex:Thing",
}
"""A context of each kind of term; what has scoped contexts in the file is left to PyLD."""
START: tuple[Any, ...] = (
    {
        "@context": CONTEXT,
        "@id": "ex:model",
        "@graph": [
            {"@id": "ex:a", "@type": ["Thing", "M"], "of": "ex:b", "size": 1.5, "unit": "M"},
            {"@id": "ex:b", "type": "Thing", "parts": ["ex:a", {"@id": "ex:c", "size": 2}]},
            {"@id": "ex:c", "@type": "M", "of": {"@id": "ex:d", "bag": [1, True, "x"]}},
            {"@id": "ex:d", "bag": {"size": 3, "of": {"@id": "ex:e", "title": "t"}}},
            {"@type": "Thing", "title": {"@value": "u", "@language": "DE"}, "parts": []},
            {"@id": "ex:f", "bag": {"@list": [1, 2.5, {"@value": "3", "@type": "ex:T"}]}},
        ],
    },
    {
        "@context": CONTEXT,
        "@graph": [
            {"@id": "ex:d", "inner": {"size": 3, "inner": {"id": "ex:e", "title": "t"}}},
            {"@id": "ex:e", "@type": ["Part", "Kind"], "inner": 1.5, "of": "ex:a", "size": 2},
        ],
    },
)
STRINGS = (
    *("", "@id", "@none", "@like", "_:b", "_:c", "ex:a", "ex:", ":", "ex:x y", "ex:a#b#c", "//x"),
    *("http://e.org/a", "nope:x", "urn:x:y", "rel", "../rel", "#frag", "Part", "Kind", "M", "size"),
    *("tag:x", "ex://y", "é", "a\\b", "1", "ex:Part", "@json", "en", "x:y:z", "isbn:1", "mailto:a"),
)
SCALARS = (None, True, False, 0, -0.0, 1, 1.0, 1e21, 1e300, -7, 0.1, 12345678901234567890)
KEYS = (
    *("@id", "@type", "@value", "@list", "@set", "@graph", "@reverse", "@included", "@nest"),
    *("@index", "@language", "@context", "@direction", "@json", "@what", "context", "graph"),
)
DEFINITIONS: tuple[Any, ...] = (
    *(None, "ex:new", "@type", "@id", "@value", "rel", "_:p", {"@id": "ex:q", "@type": "@id"}),
    *({"@id": "ex:q", "@container": each} for each in ("@list", "@set", "@index", "@language")),
    *({"@id": "ex:q", "@container": each} for each in ("@id", "@type", "@graph")),
    *({"@id": "ex:q", "@type": each} for each in ("@vocab", "@json", "@none", "ex:T", "rel")),
    *({"@reverse": "ex:q"}, {"@id": "ex:q", "@context": None}, {"@id": "@nest"}),
    {"@id": "ex:q", "@context": {"size": None, "ex": "https://y.example/"}},
    {"@id": "ex:q", "@context": {"type": "ex:type", "kind": "@type"}, "@prefix": True},
    *({"@id": "https://z.example/", "@prefix": True}, "https://z.example/#", {"@id": "ex:q"}),
)
FEW = 5
"""Elements of a `@graph` that are mutated together, at most."""
SETTINGS: tuple[tuple[str, Any], ...] = (
    *(("@vocab", EX), ("@vocab", ""), ("@vocab", None), ("@base", EX), ("@base", "rel/")),
    *(("@base", None), ("@language", "en"), ("@language", None), ("@direction", "rtl")),
    *(("@version", 1.1), ("@propagate", False), ("@protected", True), ("@import", "x.json")),
)


@cache
def _starts() -> tuple[str, ...]:
    found = []
    for _, data in corpus("jsonld"):
        try:
            found.append(json.dumps(json.loads(data)))
        except (ValueError, RecursionError):
            continue
    return (*(json.dumps(each) for each in START * 40), *found)


def made(seed: int) -> str:
    """Return the text with the number *seed*."""
    random = Random(f"expansion {seed}")  # noqa: S311  nothing is secret
    value, other = (_excerpt(random, json.loads(random.choice(_starts()))) for _ in range(2))
    for _ in range(random.choice([1, 1, 2, 3, 5, 8])):
        places = list(_places(value))
        if places:
            _change(random, *random.choice(places), value, list(_places(other)))
    text = json.dumps(value, indent=random.choice([None, 1]), ensure_ascii=random.random() < 0.5)
    if random.random() < 0.03:
        text = text.replace('"@type"', '"@id": "ex:twice", "@type"', 1)
    return text


def _excerpt(random: Random, value: Any) -> Any:
    """Return *value*, a model, with a few neighbours of its outermost `@graph`: small, and fast."""
    graph = value.get("@graph") if isinstance(value, dict) else None
    if isinstance(graph, list) and len(graph) > FEW:
        start = random.randrange(len(graph) - FEW + 1)
        value["@graph"] = graph[start : start + FEW]
    return value


def _places(value: Any) -> Iterator[tuple[Any, Any]]:
    """Yield the containers in *value*, each with a key or number in it."""
    for key in value if isinstance(value, dict) else range(len(value)):
        yield value, key
        if isinstance(value[key], (dict, list)):
            yield from _places(value[key])


def _change(random: Random, at: Any, key: Any, root: Any, others: list[tuple[Any, Any]]) -> None:
    """Change what stands under *key*, the members around it, or the context of *root*."""
    way = random.randrange(3)
    if way == 0 and isinstance(root, dict):
        _redefine(random, root)
    elif way == 1 and isinstance(at, dict):
        _rename(random, at, key)
    else:
        holder, name = random.choice(others) if others else (at, key)
        old = at.pop(key)
        values = [
            *([random.choice(STRINGS), random.choice(SCALARS)] * 2),
            *([old], [old, old], [], {}, [[old]], {random.choice([*KEYS, *CONTEXT]): old}),
            json.loads(json.dumps(holder[name])) if holder is not at else None,
        ]
        if random.random() < 0.9:
            new = random.choice(values)
            at.update({key: new}) if isinstance(at, dict) else at.insert(key, new)


def _rename(random: Random, at: dict[str, Any], key: str) -> None:
    """Give another name to a member, or add one."""
    new = random.choice([*KEYS, *CONTEXT, *STRINGS, "new"])
    if random.random() < 0.5:
        at[new] = random.choice([*STRINGS, *SCALARS])
        return
    members = [(new if name == key else name, value) for name, value in at.items()]
    at.clear()
    at.update(members)


def _redefine(random: Random, root: dict[str, Any]) -> None:
    """Change the outermost context."""
    context = root.get("@context")
    entry: Any = {random.choice([*CONTEXT, "new"]): random.choice(DEFINITIONS)}
    if random.random() < 0.4:
        entry = dict([random.choice(SETTINGS)])
    if isinstance(context, dict):
        context.update(entry)
    else:
        root["@context"] = [*(context if isinstance(context, list) else [context]), entry]


def difference(text: str, options: ReadOptions | None = None) -> str | None:
    """Return how the compiled reading of *text* differs from PyLD's; None if it does not.

    Texts that are read with the same *options* share what bundled contexts mean, as in a run.
    """
    source, options = SourceText("fuzzed.jsonld", text), options or ReadOptions()
    ours, theirs = (_told(source, options, compiled=compiled) for compiled in (True, False))
    found = next((name for name in theirs if ours.get(name) != theirs[name]), None)
    return None if found is None else f"{found}: {ours.get(found)} instead of {theirs[found]}"


def _told(source: SourceText, options: ReadOptions, *, compiled: bool) -> dict[str, Any]:
    try:
        document: Document = read(source, options, compiled=compiled)
    except SourceError as error:
        return {"error": str(error)}
    return {
        "statements": document.statements,
        "places": list(document.map.triples.items()),
        "nodes": list(document.map.nodes.items()),
        "prefixes": dict(document.prefixes),
        "error": None,
    }
