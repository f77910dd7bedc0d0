"""Constraint components that judge one value node at a time: SHACL 4.1, 4.3, 4.4, 4.6, 4.8."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TypeAlias

from kinlint.engine.compiler.frame import Frame, Violation, component, shown
from kinlint.engine.compiler.literals import comparison, constant, has_datatype
from kinlint.engine.compiler.names import SUBCLASS, TYPE, sh
from kinlint.engine.compiler.probe import try_regex
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


def condition_violations(frame: Frame, name: str) -> Iterator[Violation]:
    """The violations of component *name*, one for each value of its parameter."""
    for condition, message in CONDITIONS[name](frame):
        yield Violation(
            component(name),
            frame.each,
            condition,
            at_value=True,
            messages=(f"Value '{{?value}}' {message}.",),
        )


def _class(frame: Frame) -> Conditions:
    for kind in frame.shape.values("class"):
        own = frame.fresh()
        chain = f"{{ {frame.value} {TYPE} {own} }} LATERAL {{ {own} {SUBCLASS}* {kind} }}"
        yield f"NOT EXISTS {{ {chain} }}", f"is not a '{shown(frame.shape, kind)}'"


def _datatype(frame: Frame) -> Conditions:
    for datatype in frame.shape.values("datatype"):
        message = f"is not a literal of datatype '{shown(frame.shape, datatype)}'"
        yield f"!{has_datatype(frame.value, datatype)}", message


def _node_kind(frame: Frame) -> Conditions:
    for kind in frame.shape.values("nodeKind"):
        if kind not in _KINDS:
            raise frame.shape.graph.invalid(frame.shape.node, f"{kind} is no node kind")
        message = f"is not of node kind '{shown(frame.shape, kind)}'"
        yield f"!{_KINDS[kind].format(frame.value)}", message


def _range(name: str) -> Callable[[Frame], Conditions]:
    operator, words = _RANGES[name]

    def conditions(frame: Frame) -> Conditions:
        for limit in frame.shape.values(name[0].lower() + name[1:]):
            bound = literal_value(limit)
            yield f"!{comparison(frame.value, operator, limit)}", f"is not {words} '{bound}'"

    return conditions


def _length(name: str, operator: str, words: str) -> Callable[[Frame], Conditions]:
    def conditions(frame: Frame) -> Conditions:
        for limit in frame.shape.values(name):
            measured = f"STRLEN(STR({frame.value})) {operator} {limit}"
            text = f"has not {words} {literal_value(limit)} characters"
            yield f"!COALESCE({measured}, false)", text

    return conditions


def _pattern(frame: Frame) -> Conditions:
    flags = literal(literal_value(frame.shape.one("flags") or '""'))
    for pattern in frame.shape.values("pattern"):
        try_regex(pattern, flags)
        matched = f"REGEX(STR({frame.value}), {pattern}, {flags})"
        text = f"does not match the pattern '{literal_value(pattern)}'"
        yield f"!COALESCE({matched}, false)", text


def _language_in(frame: Frame) -> Conditions:
    for head in frame.shape.values("languageIn"):
        tags = frame.shape.graph.list(head)
        matched = " || ".join(f"LANGMATCHES(LANG({frame.value}), {tag})" for tag in tags)
        names = ", ".join(f"'{literal_value(tag)}'" for tag in tags)
        yield f"!COALESCE({matched or 'false'}, false)", f"is not tagged with one of {names}"


def _in(frame: Frame) -> Conditions:
    for head in frame.shape.values("in"):
        terms = [constant(term) for term in frame.shape.graph.list(head)]
        names = ", ".join(f"'{_plain(frame, term)}'" for term in terms)
        yield f"!({one_of(frame.value, terms)})", f"is not one of {names}"


def _disjoint(frame: Frame) -> Conditions:
    for other in frame.shape.values("disjoint"):
        held = f"EXISTS {{ {frame.focus} {other} {frame.value} }}"
        yield held, f"is a value of '{shown(frame.shape, other)}' too"


def _node(frame: Frame) -> Conditions:
    for shape in frame.shape.values("node"):
        name = shown(frame.shape, shape)
        yield f"!{frame.conforms(shape, frame.value)}", f"does not conform to '{name}'"


def _not(frame: Frame) -> Conditions:
    for shape in frame.shape.values("not"):
        name = shown(frame.shape, shape)
        yield frame.conforms(shape, frame.value), f"conforms to '{name}', which it must not"


def _list(name: str, glue: str, words: str) -> Callable[[Frame], Conditions]:
    def conditions(frame: Frame) -> Conditions:
        for head in frame.shape.values(name):
            held = [frame.conforms(shape, frame.value) for shape in frame.shape.graph.list(head)]
            if name == "xone":
                total = " + ".join(f"IF({condition}, 1, 0)" for condition in held) or "0"
                yield f"({total}) != 1", f"conforms to not {words} of {len(held)} shapes"
            else:
                empty = "true" if name == "and" else "false"
                text = f"conforms to not {words} of {len(held)} shapes"
                yield f"!({glue.join(held) or empty})", text

    return conditions


def _plain(frame: Frame, term: Term) -> str:
    return literal_value(term) if term[0] == '"' else shown(frame.shape, term)


CONDITIONS: dict[str, Callable[[Frame], Conditions]] = {
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
