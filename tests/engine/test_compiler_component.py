"""Constraint components that a shapes graph declares: SHACL 6."""

from __future__ import annotations

import pytest
from turtle_document import PREFIXES, document, ex

from kinlint.engine.compiler.shapes_compiler import compile_shapes
from kinlint.engine.constraint import Constraint
from kinlint.engine.evaluate import check
from kinlint.engine.result import Result
from kinlint.engine.store import Store
from kinlint.errors import RuleInvalid

PARAMETERS = "sh:parameter [ sh:path :least ], [ sh:path :most ; sh:optional true ]"
ASK = 'sh:validator [ sh:ask "ASK { FILTER ($value >= $least && $value <= COALESCE($most, 9)) }" ]'
SELECT = """sh:propertyValidator [ sh:message "'{?value}' is below {$least}." ; sh:select '''
    SELECT $this ?value WHERE { $this $PATH ?value FILTER (?value < $least) }''' ]"""
ROOT = """sh:nodeValidator [ sh:select
    'SELECT $this WHERE { FILTER NOT EXISTS { $this <https://example.org/p> $least } }' ]"""


def compiled(component: str, shapes: str) -> tuple[Constraint, ...]:
    text = f"{PREFIXES} :Own a sh:ConstraintComponent ; {component} . {shapes}"
    return compile_shapes([("shapes.ttl", text)])


def results(component: str, shapes: str, data: str) -> list[Result]:
    store = Store()
    store.load([document(data)])
    constraints = compiled(component, shapes)
    assert all(each.deferred is None for each in constraints)
    return list(check(store, constraints))


@pytest.mark.parametrize(("bounds", "expected"), [(":least 2", "1"), (":least 1 ; :most 2", "3")])
def test_ask_validator_holds_for_each_value(bounds: str, expected: str) -> None:
    """An optional parameter that the shape lacks is unbound."""
    shapes = f":s sh:targetSubjectsOf :p ; sh:property [ sh:path :p ; {bounds} ] ."
    more = "" if "most" in bounds else ", 9"
    (found,) = results(f"{PARAMETERS} ; {ASK}", shapes, f":a :p 1, 2, 3{more} .")
    assert (found.focus, found.path) == (ex("a"), ex("p"))
    assert (found.value or "").startswith(f'"{expected}"')
    assert found.constraint.component == "https://example.org/Own"


def test_select_validator_of_property_shapes_has_path_and_parameters() -> None:
    """They may be named in messages."""
    shapes = ":s sh:targetSubjectsOf :p ; sh:property [ sh:path :p ; :least 2 ] ."
    (found,) = results(f"{PARAMETERS} ; {SELECT}", shapes, ":a :p 1, 2 .")
    assert found.bindings["least"].startswith('"2"')
    assert found.constraint.messages == ("'{?value}' is below {$least}.",)


def test_validator_is_chosen_by_kind_of_shape() -> None:
    """And one constraint is made for each value of the only parameter."""
    shapes = ":s a sh:NodeShape ; sh:targetSubjectsOf :p ; :least 1, 2 ."
    found = results(f"sh:parameter [ sh:path :least ] ; {ROOT} ; {SELECT}", shapes, ":a :p 1 .")
    assert [(each.focus, each.value) for each in found] == [(ex("a"), ex("a"))]
    assert not compiled(f"sh:parameter [ sh:path :least ] ; {SELECT}", shapes)


@pytest.mark.parametrize(("validator", "conforming"), [(ASK, "c"), (ROOT, "b")])
def test_component_counts_where_only_conformance_is_asked(validator: str, conforming: str) -> None:
    """In shapes that others refer to."""
    shapes = ":s a sh:NodeShape ; sh:targetSubjectsOf :p ; sh:not [ :least :b ] ."
    least = validator.replace(
        "$value >= $least && $value <= COALESCE($most, 9)", "$value != $least"
    )
    found = results(f"sh:parameter [ sh:path :least ] ; {least}", shapes, ":b :p :b . :c :p :c .")
    assert [(each.focus, each.value) for each in found] == [(ex(conforming), ex(conforming))]


def test_parameters_of_nested_shapes_are_kept_apart() -> None:
    """A shape, a shape it refers to and a qualified one give the component different values."""
    shapes = """:s a sh:NodeShape ; sh:targetSubjectsOf :p ; :least 5 ; sh:property [ sh:path :p ;
        :least 4 ; sh:node [ :least 2 ] ; sh:qualifiedValueShape [ :least 3 ] ;
        sh:qualifiedMinCount 1 ] ."""
    ask = "sh:validator [ sh:ask 'ASK { FILTER ($value >= $least) }' ]"
    found = results(f"sh:parameter [ sh:path :least ] ; {ask}", shapes, ":a :p 1, 2, 3 .")
    told = {(each.constraint.component, (each.value or "").split("^^")[0]) for each in found}
    own, node = "https://example.org/Own", "http://www.w3.org/ns/shacl#NodeConstraintComponent"
    assert told == {(own, ex("a")), (own, '"1"'), (own, '"2"'), (own, '"3"'), (node, '"1"')}


def test_shape_without_a_required_parameter_is_none_of_its_business() -> None:
    """An optional one alone does nothing."""
    shapes = ":s a sh:NodeShape ; sh:targetSubjectsOf :p ; :most 1 ."
    assert not compiled(f"{PARAMETERS} ; {ASK}", shapes)


@pytest.mark.parametrize(
    ("component", "cause"),
    [
        ("sh:parameter [ sh:path :value ] ; " + ASK, "can name a variable"),
        ("sh:parameter [ sh:path :a-b ] ; " + ASK, "can name a variable"),
        ("sh:parameter [ sh:path :least ; sh:optional true ] ; " + ASK, "not optional"),
        ("sh:parameter [ sh:path :least ] ; sh:validator []", "sh:select is missing"),
        (
            "sh:parameter [ sh:path :least ] ; sh:validator [ sh:ask 'ASK {BIND(1 AS ?least)}' ]",
            "BIND gives a value to ?least",
        ),
    ],
)
def test_ill_formed_component_is_refused(component: str, cause: str) -> None:
    """Once a shape uses it."""
    with pytest.raises(RuleInvalid) as error:
        compiled(component, ":s a sh:NodeShape ; sh:targetSubjectsOf :p ; :least 1 .")
    assert cause in str(error.value)


@pytest.mark.parametrize(
    ("validator", "value"),
    [
        (ASK, "[]"),
        ("sh:validator [ sh:ask 'ASK {} LIMIT 1' ]", "1"),
        ("sh:nodeValidator [ sh:select 'SELECT $this WHERE {} GROUP BY $this' ]", "1"),
    ],
)
def test_what_is_not_covered_is_deferred(validator: str, value: str) -> None:
    """Blank parameters, and grouping that would hide the parameters."""
    shapes = f":s a sh:NodeShape ; sh:targetSubjectsOf :p ; :least {value} ."
    (found,) = compiled(f"sh:parameter [ sh:path :least ] ; {validator}", shapes)
    assert found.deferred
