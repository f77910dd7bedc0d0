"""Strategies for small graphs and for the EXISTS bodies that a rule may ask of them."""

from __future__ import annotations

from functools import partial

from hypothesis import strategies as st

NODES = [f"<urn:{name}>" for name in "abc"] + ["_:d", "_:e"]
RDF_TYPE = "<http://www.w3.org/1999/02/22-rdf-syntax-ns#type>"
SUBCLASS = "<http://www.w3.org/2000/01/rdf-schema#subClassOf>"
PREDICATES = [*(f"<urn:{name}>" for name in "pqr"), RDF_TYPE, SUBCLASS]
LITERALS = ['"1"^^<http://www.w3.org/2001/XMLSchema#integer>', '"one"', '"one"@en']

triples = st.lists(
    st.tuples(
        st.sampled_from(NODES), st.sampled_from(PREDICATES), st.sampled_from(NODES + LITERALS)
    ),
    max_size=12,
    unique=True,
).map(tuple)

_names = st.sampled_from(["?this", "?x", "?y", "?z", "<urn:a>"])
_paths = st.sampled_from(
    [
        "<urn:p>",
        "<urn:q>",
        "?link",
        "<urn:p>/<urn:q>",
        "^<urn:p>",
        "<urn:p>*",
        "(<urn:p>/^<urn:q>)*",
        "<urn:q>+",
        "(<urn:p>|<urn:r>)/<urn:q>?",
    ]
)
_patterns = st.tuples(_names, _paths, _names).map(" ".join)
_simple = st.sampled_from(
    [
        "FILTER (?x != ?y)",
        "FILTER (isIRI(?x))",
        "FILTER (!BOUND(?z))",
        "FILTER (BOUND(?this) && ?this != ?y)",
        "FILTER (?w = ?x)",
    ]
)


def _group(parts: st.SearchStrategy[list[str]]) -> st.SearchStrategy[str]:
    return parts.map(lambda found: "{ " + " . ".join(found) + " }")


_flat = _group(st.lists(_patterns | _simple, min_size=1, max_size=4))


def _larger(inner: st.SearchStrategy[str], *, simple: bool = False) -> st.SearchStrategy[str]:
    nested = st.one_of(
        inner.map(lambda group: f"FILTER NOT EXISTS {group}"),
        inner.map(lambda group: f"FILTER (EXISTS {group} || ?x = <urn:b>)"),
        inner.map(lambda group: f"OPTIONAL {group}"),
    )
    if not simple:
        nested |= _scoped(inner)
    return _group(
        st.tuples(
            st.lists(_patterns, min_size=1, max_size=2),
            st.lists(nested | _simple, min_size=1, max_size=2),
        ).map(lambda pair: [*pair[0], *pair[1]])
    )


def _scoped(inner: st.SearchStrategy[str]) -> st.SearchStrategy[str]:
    return st.one_of(
        st.tuples(inner, inner).map(" UNION ".join),
        inner.map(lambda group: f"{{ SELECT ?this ?x WHERE {group} }}"),
        inner.map(
            lambda group: f"{{ SELECT ?this (COUNT(?y) AS ?n) WHERE {group} GROUP BY ?this }}"
        ),
        st.just("BIND (?this AS ?v)"),
    )


groups = st.recursive(_flat, _larger, max_leaves=4)
"""Group graph patterns about `?this` and others."""

simple_groups = st.recursive(_flat, partial(_larger, simple=True), max_leaves=3)
"""Those without sub-selects and UNION."""

_shape_paths = st.sampled_from(
    [
        "<urn:p>",
        "<urn:q>",
        "[ sh:inversePath <urn:p> ]",
        "( <urn:p> <urn:q> )",
        "[ sh:alternativePath ( <urn:p> <urn:q> ) ]",
        "[ sh:zeroOrMorePath <urn:p> ]",
        "[ sh:oneOrMorePath [ sh:inversePath <urn:q> ] ]",
        "( [ sh:zeroOrOnePath <urn:p> ] <urn:r> )",
    ]
)
_anywhere = st.sampled_from(
    [
        "sh:class <urn:c>",
        "sh:datatype xsd:integer",
        "sh:datatype xsd:string",
        "sh:nodeKind sh:IRI",
        "sh:nodeKind sh:BlankNodeOrLiteral",
        "sh:minInclusive 1",
        "sh:maxExclusive 1",
        "sh:minLength 3",
        "sh:maxLength 2",
        'sh:pattern "^O" ; sh:flags "i"',
        'sh:languageIn ( "en" "de" )',
        'sh:in ( <urn:a> 1 "one" )',
        "sh:hasValue <urn:b>",
        "sh:equals <urn:q>",
        "sh:disjoint <urn:q>",
        "sh:closed true ; sh:ignoredProperties ( <urn:p> )",
    ]
)
_of_properties = st.sampled_from(
    [
        "sh:minCount 1",
        "sh:minCount 2",
        "sh:maxCount 0",
        "sh:maxCount 1",
        "sh:uniqueLang true",
    ]
)


def _nested(inner: st.SearchStrategy[str]) -> st.SearchStrategy[str]:
    each = inner.map(lambda constraint: f"[ {constraint} ]")
    pairs = st.tuples(each, each).map(" ".join)
    return st.one_of(
        each.map(lambda shape: f"sh:node {shape}"),
        each.map(lambda shape: f"sh:not {shape}"),
        pairs.map(lambda both: f"sh:and ( {both} )"),
        pairs.map(lambda both: f"sh:or ( {both} )"),
        pairs.map(lambda both: f"sh:xone ( {both} )"),
        st.tuples(_shape_paths, inner | _of_properties).map(
            lambda pair: f"sh:property [ sh:path {pair[0]} ; {pair[1]} ]"
        ),
        st.tuples(_shape_paths, each).map(
            lambda pair: (
                f"sh:property [ sh:path {pair[0]} ; sh:qualifiedValueShape {pair[1]} ; "
                "sh:qualifiedMinCount 1 ; sh:qualifiedMaxCount 1 ]"
            )
        ),
    )


_targets = st.sampled_from(
    [
        "sh:targetSubjectsOf <urn:p>",
        "sh:targetObjectsOf <urn:q>",
        "sh:targetClass <urn:c>",
        "sh:targetNode <urn:a>, 1",
        "sh:targetSubjectsOf <urn:q> ; sh:targetObjectsOf <urn:p>",
    ]
)
shapes = st.tuples(
    _targets,
    st.lists(
        st.recursive(_anywhere, _nested, max_leaves=4),
        min_size=1,
        max_size=2,
        unique_by=lambda constraint: constraint.split(" ")[0],
    ),
).map(lambda pair: f"<urn:s> a sh:NodeShape ; {pair[0]} ; {' ; '.join(pair[1])} .")
"""Shapes in SHACL Core with targets, in Turtle."""
