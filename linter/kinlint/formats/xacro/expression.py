"""Evaluates the Python expressions of xacro files, of which only what is harmless is known.

xacro hands expressions to Python's `eval`. Here they are walked instead: literals, operators,
names, calls of known functions and methods, comprehensions and lambdas. Nothing else exists for
them, every step is counted, and what would become huge is refused before it is made.
"""

from __future__ import annotations

import ast
import operator
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any, TypeVar

from kinlint.formats.xacro.expansion_limits import ENTRIES, Limits, Refused

_Made = TypeVar("_Made")

BINARY: Mapping[type[ast.operator], Callable[[Any, Any], Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.FloorDiv: operator.floordiv,
    ast.Mod: operator.mod,
    ast.Pow: operator.pow,
    ast.LShift: operator.lshift,
    ast.RShift: operator.rshift,
    ast.BitAnd: operator.and_,
    ast.BitOr: operator.or_,
    ast.BitXor: operator.xor,
}
UNARY: Mapping[type[ast.unaryop], Callable[[Any], Any]] = {
    ast.UAdd: operator.pos,
    ast.USub: operator.neg,
    ast.Not: operator.not_,
    ast.Invert: operator.invert,
}
COMPARING: Mapping[type[ast.cmpop], Callable[[Any, Any], bool]] = {
    ast.Eq: operator.eq,
    ast.NotEq: operator.ne,
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
    ast.Is: operator.is_,
    ast.IsNot: operator.is_not,
    ast.In: lambda item, items: item in items,
    ast.NotIn: lambda item, items: item not in items,
}
TEXTUAL = (
    "capitalize count endswith find index isalnum isalpha isdigit islower isnumeric isspace isupper"
    " join lower lstrip partition replace rfind rpartition rsplit rstrip split splitlines"
    " startswith strip swapcase title upper"
)
METHODS: Mapping[type, frozenset[str]] = {
    str: frozenset(TEXTUAL.split()),
    list: frozenset({"count", "index", "copy"}),
    tuple: frozenset({"count", "index"}),
    dict: frozenset({"get", "items", "keys", "values", "copy"}),
    set: frozenset({"union", "intersection", "difference", "issubset", "issuperset"}),
    frozenset: frozenset({"union", "intersection", "difference", "issubset", "issuperset"}),
    float: frozenset({"is_integer"}),
}
"""Methods that an expression may call on a value. None of them changes a value or formats one."""
LENGTH = 4000
"""Maximum length of an expression, in characters."""


class Members:
    """A value whose members expressions may name with a dot."""

    def member(self, name: str) -> Any:
        """Return the member *name*; raises NameError if there is none."""
        raise NotImplementedError


class Entries(dict[Any, Any]):
    """A table of YAML, whose entries may be named with a dot."""

    def entry(self, name: str) -> Any:
        """Return the value of the key *name*."""
        if name not in self:
            raise AttributeError(f"the YAML table has no key '{name}'")
        return self[name]


class Scope(dict[str, Any]):
    """Names bound by a comprehension or lambda, on top of others."""

    def __init__(self, below: Mapping[str, Any]) -> None:
        super().__init__()
        self._below = below

    def __missing__(self, name: str) -> Any:
        return self._below[name]


def evaluate(expression: str, names: Mapping[str, Any], bounds: Limits) -> Any:
    """Return the value of *expression*, in which *names* are known.

    Raises what Python would, and Refused for what no robot description needs.
    """
    text = expression.strip()
    if len(text) > LENGTH:
        raise Refused(f"an expression of more than {LENGTH} characters")
    return _Evaluation(bounds).value(ast.parse(text, "<expression>", "eval").body, names)


class _Evaluation:
    def __init__(self, bounds: Limits) -> None:
        self._bounds = bounds

    def value(self, node: ast.expr, names: Mapping[str, Any]) -> Any:
        self._bounds.step()
        method = getattr(self, f"_{type(node).__name__.lower()}", None)
        if method is None:
            raise Refused(f"{_what(node)} in an expression")
        return method(node, names)

    def _constant(self, node: ast.Constant, _: Mapping[str, Any]) -> Any:
        return node.value

    def _name(self, node: ast.Name, names: Mapping[str, Any]) -> Any:
        if node.id.startswith("__"):
            raise Refused(f"the name '{node.id}'")
        try:
            return names[node.id]
        except KeyError:
            raise NameError(f"name '{node.id}' is not defined") from None

    def _binop(self, node: ast.BinOp, names: Mapping[str, Any]) -> Any:
        left, right = self.value(node.left, names), self.value(node.right, names)
        self._bounds.check_operation(node.op, left, right)
        return self._bounds.result(BINARY[type(node.op)](left, right))

    def _unaryop(self, node: ast.UnaryOp, names: Mapping[str, Any]) -> Any:
        return UNARY[type(node.op)](self.value(node.operand, names))

    def _boolop(self, node: ast.BoolOp, names: Mapping[str, Any]) -> Any:
        stops = isinstance(node.op, ast.Or)
        result: Any = None
        for each in node.values:
            result = self.value(each, names)
            if bool(result) is stops:
                break
        return result

    def _compare(self, node: ast.Compare, names: Mapping[str, Any]) -> Any:
        left, result = self.value(node.left, names), True
        for kind, operand in zip(node.ops, node.comparators, strict=True):
            right = self.value(operand, names)
            self._bounds.check_comparison(left, right)
            result = COMPARING[type(kind)](left, right)
            if not result:
                break
            left = right
        return result

    def _ifexp(self, node: ast.IfExp, names: Mapping[str, Any]) -> Any:
        return self.value(node.body if self.value(node.test, names) else node.orelse, names)

    def _list(self, node: ast.List, names: Mapping[str, Any]) -> list[Any]:
        return self._made(list(self._elements(node.elts, names)))

    def _tuple(self, node: ast.Tuple, names: Mapping[str, Any]) -> tuple[Any, ...]:
        return self._made(tuple(self._elements(node.elts, names)))

    def _set(self, node: ast.Set, names: Mapping[str, Any]) -> set[Any]:
        return self._made(set(self._bounds.listed(self._elements(node.elts, names), ENTRIES)))

    def _made(self, value: _Made) -> _Made:
        self._bounds.result(value)
        return value

    def _elements(self, nodes: Iterable[ast.expr], names: Mapping[str, Any]) -> Iterator[Any]:
        for each in nodes:
            if isinstance(each, ast.Starred):
                yield from self._bounds.items(self.value(each.value, names))
            else:
                yield self.value(each, names)

    def _dict(self, node: ast.Dict, names: Mapping[str, Any]) -> dict[Any, Any]:
        result: dict[Any, Any] = {}
        for key, value in zip(node.keys, node.values, strict=True):
            if key is None:
                result.update(self.value(value, names))
            else:
                result[self.value(key, names)] = self.value(value, names)
        return self._made(result)

    def _subscript(self, node: ast.Subscript, names: Mapping[str, Any]) -> Any:
        return self.value(node.value, names)[self.value(node.slice, names)]

    def _slice(self, node: ast.Slice, names: Mapping[str, Any]) -> slice:
        parts = (node.lower, node.upper, node.step)
        return slice(*(None if part is None else self.value(part, names) for part in parts))

    def _attribute(self, node: ast.Attribute, names: Mapping[str, Any]) -> Any:
        owner = self.value(node.value, names)
        if node.attr.startswith("_"):
            raise Refused(f"the attribute '{node.attr}'")
        if isinstance(owner, Members):
            return owner.member(node.attr)
        for kind, methods in METHODS.items():
            if isinstance(owner, kind) and node.attr in methods:
                return self._bounds.method(owner, node.attr)
        if isinstance(owner, Entries):
            return owner.entry(node.attr)
        raise AttributeError(f"'{type(owner).__name__}' has no attribute '{node.attr}' here")

    def _call(self, node: ast.Call, names: Mapping[str, Any]) -> Any:
        function = self.value(node.func, names)
        if not callable(function):
            raise TypeError(f"'{type(function).__name__}' is not a function")
        positional = list(self._elements(node.args, names))
        keywords = {each.arg: self.value(each.value, names) for each in node.keywords if each.arg}
        if len(keywords) != len(node.keywords):
            raise Refused("'**' in an expression")
        return self._bounds.call(function, positional, keywords)

    def _lambda(self, node: ast.Lambda, names: Mapping[str, Any]) -> Callable[..., Any]:
        given = node.args
        if given.vararg or given.kwarg or given.kwonlyargs or given.defaults:
            raise Refused("a lambda with more than plain parameters")
        parameters = [each.arg for each in (*given.posonlyargs, *given.args)]

        def call(*values: Any) -> Any:
            scope = Scope(names)
            scope.update(zip(parameters, values, strict=True))
            return self.value(node.body, scope)

        return call

    def _listcomp(self, node: ast.ListComp, names: Mapping[str, Any]) -> list[Any]:
        scopes = self._scopes(node.generators, names)
        return self._made([self.value(node.elt, each) for each in scopes])

    def _setcomp(self, node: ast.SetComp, names: Mapping[str, Any]) -> set[Any]:
        scopes = self._scopes(node.generators, names)
        values = (self.value(node.elt, each) for each in scopes)
        return self._made({*self._bounds.listed(values, ENTRIES)})

    def _generatorexp(self, node: ast.GeneratorExp, names: Mapping[str, Any]) -> Iterator[Any]:
        scopes = self._scopes(node.generators, names)
        return iter(self._made([self.value(node.elt, each) for each in scopes]))

    def _dictcomp(self, node: ast.DictComp, names: Mapping[str, Any]) -> dict[Any, Any]:
        scopes = self._scopes(node.generators, names)
        pairs = ((self.value(node.key, each), self.value(node.value, each)) for each in scopes)
        return self._made(dict(self._bounds.listed(pairs, ENTRIES)))

    def _scopes(
        self, generators: list[ast.comprehension], names: Mapping[str, Any]
    ) -> Iterator[Mapping[str, Any]]:
        if not generators:
            yield names
            return
        first, *rest = generators
        for item in self._bounds.items(self.value(first.iter, names)):
            scope = Scope(names)
            self._bind(first.target, item, scope)
            if all(self.value(test, scope) for test in first.ifs):
                yield from self._scopes(rest, scope)

    def _bind(self, target: ast.expr, value: Any, scope: Scope) -> None:
        if isinstance(target, ast.Name):
            scope[target.id] = value
        elif isinstance(target, ast.Tuple | ast.List):
            for each, part in zip(target.elts, value, strict=True):
                self._bind(each, part, scope)
        else:
            raise Refused(f"{_what(target)} as a target")

    def _joinedstr(self, node: ast.JoinedStr, names: Mapping[str, Any]) -> str:
        parts = []
        for each in node.values:
            value = each
            if isinstance(each, ast.FormattedValue):
                if each.format_spec is not None:
                    raise Refused("a format in an expression")
                value = each.value
            parts.append(self._bounds.text(str(self._bounds.result(self.value(value, names)))))
        return self._bounds.text("".join(parts))


def _what(node: ast.expr) -> str:
    return f"'{type(node).__name__}'"
