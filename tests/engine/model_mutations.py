"""Small random changes to JSON-LD models: the slips and the nonsense that occur in files."""

from __future__ import annotations

import copy
import json
from collections.abc import Callable, Iterator, Sequence
from random import Random
from typing import Any

AGAIN = "(again)"
"""Marks a key that stands a second time in its object, until the text is written."""

Holder = dict[str, Any] | list[Any]
Slot = tuple[Holder, Any]

XSD = "http://www.w3.org/2001/XMLSchema#"
NUMBERS: tuple[Any, ...] = (
    *(0, -0.0, 1, -1, 1.0, 0.5, 90, 180.0, -3.1416, 3.15, 1e-12, 1e9, -1e30, 1e308, 10**30),
    *("0.4", "NaN", "1e3", "0,4", "-INF", "one", True, None, [0.1], {}),
    {"@value": "0.40", "@type": f"{XSD}decimal"},
    {"@value": "1", "@type": f"{XSD}integer"},
    {"@value": "NaN", "@type": f"{XSD}double"},
    {"@value": "INF", "@type": f"{XSD}double"},
    {"@value": "many", "@type": f"{XSD}double"},
    {"@value": "1.0", "@type": f"{XSD}float"},
    {"@value": "1.0", "@type": f"{XSD}string"},
)
TEXTS: tuple[Any, ...] = (
    *("", " ", "a b", "it's", 'a "b"', "{?value}", "{$this}", "é", "\n", "\\", "ex:", ":x", "_:b0"),
    *("ex:nothing", "urn:x:y", "http://", "https://example.org/<>", "@type", "@none", 7, False),
    *(None, [], {}, {"@value": "text", "@language": "en"}, {"@id": "_:b1"}, {"@list": []}, [[]]),
)
KEYS = (
    "comment",
    "@index",
    "@reverse",
    "@graph",
    "@value",
    "@list",
    "ex:note",
    "rdfs:label",
    "@id",
)


class Model:
    """A parsed model with the places in it at which something can be changed.

    *pool* has the values that each key has in all models.
    """

    def __init__(self, parsed: Any, pool: dict[str, list[Any]], random: Random) -> None:
        self.parsed, self.pool, self.random = parsed, pool, random

    def slots(self, wanted: Callable[[Any], bool] = lambda _: True) -> list[Slot]:
        """Where the *wanted* values below the contexts are."""
        return [slot for slot in walk(self.parsed) if wanted(slot[0][slot[1]])]

    def nodes(self) -> list[dict[str, Any]]:
        """The objects that say what they are."""
        found = (holder[key] for holder, key in self.slots(lambda each: isinstance(each, dict)))
        return [each for each in found if "@id" in each or "@type" in each]

    def names(self) -> list[str]:
        """The identifiers of nodes."""
        return [each["@id"] for each in self.nodes() if isinstance(each.get("@id"), str)]

    def choice(self, of: Sequence[Any]) -> Any:
        """One *of* them; None if there is none."""
        return copy.deepcopy(self.random.choice(of)) if of else None


def walk(value: Any) -> Iterator[Slot]:
    """Every value below *value* but contexts, outer ones first."""
    if isinstance(value, dict):
        for key in value:
            if key != "@context":
                yield value, key
                yield from walk(value[key])
    elif isinstance(value, list):
        for index, each in enumerate(value):
            yield value, index
            yield from walk(each)


def values(models: Sequence[Any]) -> dict[str, list[Any]]:
    """The different values that each key has in *models*: the pool of `Model`."""
    found: dict[str, dict[str, Any]] = {}
    for model in models:
        for holder, key in walk(model):
            if isinstance(holder, dict) and key != "@graph":
                for each in as_list(holder[key]):
                    found.setdefault(key, {})[json.dumps(each)] = each
    return {key: list(each.values()) for key, each in found.items()}


def as_list(value: Any) -> list[Any]:
    return value if isinstance(value, list) else [value]


def is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _place(model: Model, wanted: Callable[[Any], bool] = lambda _: True) -> Slot | None:
    found = model.slots(wanted)
    return model.random.choice(found) if found else None


def delete(model: Model) -> None:
    """A key or an element of a list is gone."""
    if place := _place(model):
        del place[0][place[1]]


def swap(model: Model) -> None:
    """Two values of one kind have changed places."""
    if place := _place(model, lambda each: not isinstance(each, dict | list)):
        holder, key = place
        other, there = _place(model, lambda each: type(each) is type(holder[key])) or place
        holder[key], other[there] = other[there], holder[key]


def refer(model: Model) -> None:
    """A text is the name of some other node."""
    if (place := _place(model, lambda each: isinstance(each, str))) and model.names():
        place[0][place[1]] = model.choice(model.names())


def anonymous(model: Model) -> None:
    """A node has no name."""
    if named := [each for each in model.nodes() if "@id" in each]:
        del model.random.choice(named)["@id"]


def twice(model: Model) -> None:
    """A node is described again, not quite as before."""
    if place := _place(model, lambda each: isinstance(each, dict) and "@id" in each):
        holder, key = place
        again = copy.deepcopy(holder[key])
        inner = Model({"@graph": [again]}, model.pool, model.random)
        model.random.choice((number, other_value, delete))(inner)
        rest = [holder] if isinstance(holder, list) else [[]]
        rest[0].append(again)
        if isinstance(holder, dict):
            holder[key] = [holder[key], again]


def number(model: Model) -> None:
    """A number is another, or none."""
    if place := _place(model, is_number):
        holder, key = place
        scaled = [holder[key] * factor for factor in (-1, 1000, 1.001, 57.29578)]
        holder[key] = model.choice((*NUMBERS, *scaled))


def other_value(model: Model) -> None:
    """A key has a value that it has elsewhere: another unit, kind, type."""
    found = [(holder, key) for holder, key in model.slots() if isinstance(holder, dict)]
    found = [(holder, key) for holder, key in found if model.pool.get(key) and key != "@graph"]
    if found:
        holder, key = model.random.choice(found)
        new = model.choice(model.pool[key])
        if isinstance(holder[key], list) and holder[key] and model.random.random() < 0.7:
            holder[key][model.random.randrange(len(holder[key]))] = new
        else:
            holder[key] = new


def more(model: Model) -> None:
    """A key has a second value."""
    found = [(holder, key) for holder, key in model.slots() if isinstance(holder, dict)]
    if found:
        holder, key = model.random.choice(found)
        choices = [*model.pool.get(key, ()), *model.names(), *as_list(holder[key])]
        holder[key] = [*as_list(holder[key]), model.choice(choices)]


def new_key(model: Model) -> None:
    """A node has a key that nodes elsewhere have."""
    if nodes := model.nodes():
        key = model.random.choice((*sorted(model.pool), *KEYS))
        choices = (*model.pool.get(key, TEXTS), *model.names())
        model.random.choice(nodes)[key] = model.choice(choices)


def repeat_key(model: Model) -> None:
    """A key stands twice in one object."""
    if nodes := model.nodes():
        node = model.random.choice(nodes)
        key = model.random.choice(list(node))
        node[f"{key}{AGAIN}"] = model.choice([*model.pool.get(key, ()), node[key]])


def nest(model: Model) -> None:
    """A node is described where it is referred to."""
    nodes = {each["@id"]: each for each in model.nodes() if isinstance(each.get("@id"), str)}
    references = [
        (holder, key)
        for holder, key in model.slots(lambda each: isinstance(each, str) and each in nodes)
        if key != "@id"
    ]
    if references:
        holder, key = model.random.choice(references)
        holder[key] = copy.deepcopy(nodes[holder[key]])


def merge(model: Model) -> None:
    """Two nodes have one name."""
    if len(names := model.names()) > 1:
        named = [each for each in model.nodes() if "@id" in each]
        model.random.choice(named)["@id"] = model.choice(names)


def retype(model: Model) -> None:
    """A node has one type more, or less, or another."""
    if typed := [each for each in model.nodes() if "@type" in each]:
        node = model.random.choice(typed)
        types = as_list(node["@type"])
        other = model.choice(model.pool["@type"])
        kept = [each for each in types if model.random.random() < 0.8]
        node["@type"] = model.random.choice([[*types, other], kept, [other], types + types[:1]])


def wrap(model: Model) -> None:
    """A value stands in a list, a set or an object."""
    if place := _place(model):
        holder, key = place
        value = holder[key]
        holder[key] = model.random.choice(
            (
                [value],
                {"@list": as_list(value)},
                {"@set": [value]},
                {"@id": value},
                [[value], value],
            )
        )


def odd_text(model: Model) -> None:
    """A text is empty, or has signs that mean something to somebody."""
    if place := _place(model, lambda each: isinstance(each, str)):
        place[0][place[1]] = model.choice(TEXTS)


def shuffle(model: Model) -> None:
    """A list is in another order."""
    if place := _place(model, lambda each: isinstance(each, list) and len(each) > 1):
        model.random.shuffle(place[0][place[1]])


def context(model: Model) -> None:
    """A context is gone, or another is added."""
    if not isinstance(model.parsed, dict):
        return
    given = as_list(model.parsed.get("@context", []))
    added = model.random.choice(
        (
            {"unit": "ex:unit"},
            {"x": None},
            {"ex": "https://example.org/other#"},
            "https://example.org/unknown.json",
            {"of": {"@id": "ex:of", "@type": "@id", "@container": "@list"}},
            {"@base": "https://example.org/base/"},
            {"@vocab": "https://example.org/vocabulary#"},
        )
    )
    kept = [each for each in given if model.random.random() < 0.8]
    model.parsed["@context"] = model.random.choice(([*given, added], [added, *given], kept))


MUTATIONS = (
    *(delete, swap, refer, anonymous, twice, number, other_value, more, new_key, repeat_key),
    *(nest, merge, retype, wrap, odd_text, shuffle, context),
)


def mutant(text: str, pool: dict[str, list[Any]], seed: str) -> tuple[str, tuple[str, ...]]:
    """*text* after one to three mutations, most often one, and the names of these."""
    random = Random(seed)  # noqa: S311
    count = random.choice((1, 1, 1, 2, 3))
    model = Model(json.loads(text), pool, random)
    chosen = random.choices(MUTATIONS, k=count)
    for mutation in chosen:
        mutation(model)
    written = json.dumps(model.parsed, indent=2, ensure_ascii=random.random() < 0.5)
    return written.replace(f'{AGAIN}"', '"'), tuple(each.__name__ for each in chosen)
