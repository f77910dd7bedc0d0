"""Constraint components that judge one value node at a time: SHACL 4.1, 4.3, 4.4, 4.6, 4.8."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TypeAlias

from kinlint.engine.compiler.literal_conditions import comparison, constant, has_datatype
from kinlint.engine.compiler.oxigraph_probe import try_regex
from kinlint.engine.compiler.shacl_terms import SUBCLASS, TYPE, sh
from kinlint.engine.compiler.shape_scope import ShapeScope, Violation, component, shown
from kinlint.engine.compiler.target import one_of
from kinlint.terms import Term, literal, literal_value

Conditions: TypeAlias = Iterator[tuple[str, str]]
"""Conditions under which a value node breaks a constraint, each with a message."""

_KINDS = {
    sh("IRI"): "isIRI({0})",
    sh("BlankNode"): "isBlank({0})",
    sh("Literal"): "isLiteral({0})",
    sh("BlankNodeOrIRI"): "(isBlank({0}) || isIRI({0}))",
    sh("BlankNodeOrLiteral"): "(isBlank({0}) || isLiteral({0}))",
    sh("IRIOrLiteral"): "(isIRI({0}) || isLiteral({0}))",
}
_RANGES = {
    "MinExclusive": (">", "greater than"),
    "MinInclusive": (">=", "at least"),
    "MaxExclusive": ("<", "less than"),
    "MaxInclusive": ("<=", "at most"),
}


def condition_violations(scope: ShapeScope, name: str) -> Iterator[Violation]:
    """Yield the violations of component *name*, one for each value of its parameter."""
    for condition, message in CONDITIONS[name](scope):
        yield Violation(
            component(name),
            scope.value_groups,
            condition,
            at_value=True,
            messages=(f"Value '{{?value}}' {message}.",),
        )


def _class(scope: ShapeScope) -> Conditions:
    for kind in scope.shape.values("class"):
        own = scope.fresh()
        chain = f"{{ {scope.value} {TYPE} {own} }} LATERAL {{ {own} {SUBCLASS}* {kind} }}"
        yield f"NOT EXISTS {{ {chain} }}", f"is not a '{shown(scope.shape, kind)}'"


def _datatype(scope: ShapeScope) -> Conditions:
    for datatype in scope.shape.values("datatype"):
        message = f"is not a literal of datatype '{shown(scope.shape, datatype)}'"
        yield f"!{has_datatype(scope.value, datatype)}", message


def _node_kind(scope: ShapeScope) -> Conditions:
    for kind in scope.shape.values("nodeKind"):
        if kind not in _KINDS:
            raise scope.shape.graph.invalid(scope.shape.node, f"{kind} is not a node kind")
        message = f"is not of node kind '{shown(scope.shape, kind)}'"
        yield f"!{_KINDS[kind].format(scope.value)}", message


def _range(name: str) -> Callable[[ShapeScope], Conditions]:
    operator, words = _RANGES[name]

    def conditions(scope: ShapeScope) -> Conditions:
        for limit in scope.shape.values(name[0].lower() + name[1:]):
            bound = literal_value(limit)
            yield f"!{comparison(scope.value, operator, limit)}", f"is not {words} '{bound}'"

    return conditions


def _length(name: str, operator: str, words: str) -> Callable[[ShapeScope], Conditions]:
    def conditions(scope: ShapeScope) -> Conditions:
        for limit in scope.shape.values(name):
            measured = f"STRLEN(STR({scope.value})) {operator} {limit}"
            text = f"has not {words} {literal_value(limit)} characters"
            yield f"!COALESCE({measured}, false)", text

    return conditions


def _pattern(scope: ShapeScope) -> Conditions:
    flags = literal(literal_value(scope.shape.one("flags") or '""'))
    for pattern in scope.shape.values("pattern"):
        try_regex(pattern, flags)
        matched = f"REGEX(STR({scope.value}), {pattern}, {flags})"
        text = f"does not match the pattern '{literal_value(pattern)}'"
        yield f"!COALESCE({matched}, false)", text


def _language_in(scope: ShapeScope) -> Conditions:
    for head in scope.shape.values("languageIn"):
        tags = scope.shape.graph.list(head)
        matched = " || ".join(f"LANGMATCHES(LANG({scope.value}), {tag})" for tag in tags)
        names = ", ".join(f"'{literal_value(tag)}'" for tag in tags)
        yield f"!COALESCE({matched or 'false'}, false)", f"is not tagged with one of {names}"


def _in(scope: ShapeScope) -> Conditions:
    for head in scope.shape.values("in"):
        terms = [constant(term) for term in scope.shape.graph.list(head)]
        names = ", ".join(f"'{_plain(scope, term)}'" for term in terms)
        yield f"!({one_of(scope.value, terms)})", f"is not one of {names}"


def _disjoint(scope: ShapeScope) -> Conditions:
    for other in scope.shape.values("disjoint"):
        held = f"EXISTS {{ {scope.focus} {other} {scope.value} }}"
        yield held, f"is a value of '{shown(scope.shape, other)}' too"


def _node(scope: ShapeScope) -> Conditions:
    for shape in scope.shape.values("node"):
        name = shown(scope.shape, shape)
        yield f"!{scope.conforms(shape, scope.value)}", f"does not conform to '{name}'"


def _not(scope: ShapeScope) -> Conditions:
    for shape in scope.shape.values("not"):
        name = shown(scope.shape, shape)
        yield scope.conforms(shape, scope.value), f"conforms to '{name}', which it must not"


def _list(name: str, glue: str, words: str) -> Callable[[ShapeScope], Conditions]:
    def conditions(scope: ShapeScope) -> Conditions:
        for head in scope.shape.values(name):
            held = [scope.conforms(shape, scope.value) for shape in scope.shape.graph.list(head)]
            if name == "xone":
                total = " + ".join(f"IF({condition}, 1, 0)" for condition in held) or "0"
                yield f"({total}) != 1", f"conforms to not {words} of {len(held)} shapes"
            else:
                empty = "true" if name == "and" else "false"
                text = f"conforms to not {words} of {len(held)} shapes"
                yield f"!({glue.join(held) or empty})", text

    return conditions


def _plain(scope: ShapeScope, term: Term) -> str:
    return literal_value(term) if term[0] == '"' else shown(scope.shape, term)


CONDITIONS: dict[str, Callable[[ShapeScope], Conditions]] = {
    "Class": _class,
    "Datatype": _datatype,
    "NodeKind": _node_kind,
    **{name: _range(name) for name in _RANGES},
    "MinLength": _length("minLength", ">=", "at least"),
    "MaxLength": _length("maxLength", "<=", "at most"),
    "Pattern": _pattern,
    "LanguageIn": _language_in,
    "In": _in,
    "Disjoint": _disjoint,
    "Node": _node,
    "Not": _not,
    "And": _list("and", " && ", "all"),
    "Or": _list("or", " || ", "one"),
    "Xone": _list("xone", "", "exactly one"),
}
