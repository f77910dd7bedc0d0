"""The abstract syntax tree of SPARQL as JSON, so that a query is parsed once and kept."""

from __future__ import annotations

from typing import Any

from kinlint.sparql.ast import (
    Bind,
    Clause,
    Construct,
    Element,
    Expression,
    Filter,
    Group,
    Query,
    Select,
    Triples,
    Union,
    Update,
    Values,
)

_CLASSES = (Group, Triples, Filter, Bind, Union, Clause, Values, Select, Construct, Update)
_BY_NAME: dict[str, type[Any]] = {each.__name__: each for each in _CLASSES}


def to_json(part: Query | Group | Element | Expression | str) -> Any:
    """Return *part* as JSON: a node as an object of its class and fields, a tuple as an array."""
    if isinstance(part, str):
        return part
    if isinstance(part, tuple):
        return [to_json(each) for each in part]
    return {type(part).__name__: [to_json(each) for each in vars(part).values()]}


def from_json(value: Any) -> Any:
    """Return the part of a tree that `to_json` has made *value* of."""
    if isinstance(value, str):
        return value
    if isinstance(value, list):
        return tuple([each if isinstance(each, str) else from_json(each) for each in value])
    ((name, fields),) = value.items()
    return _BY_NAME[name](*map(from_json, fields))
