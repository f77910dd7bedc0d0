"""The text at every triple's place says the triple's value."""

from __future__ import annotations

import json
import re
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pyld import jsonld
from reading import document, domain, says

from kinlint.contexts.context_library import Contexts
from kinlint.document import Document
from kinlint.terms import RDF, is_iri
from kinlint.vocabulary import SRC

CONTEXT = {
    "ex": "https://example.org/#",
    "xsd": "http://www.w3.org/2001/XMLSchema#",
    "p": "ex:p",
    "to": {"@id": "ex:to", "@type": "@id"},
    "kind": {"@id": "ex:kind", "@type": "@vocab"},
    "real": {"@id": "ex:real", "@type": "xsd:double"},
    "list": {"@id": "ex:list", "@container": "@list"},
    "path": {"@id": "ex:path", "@type": "@id", "@container": "@list"},
    "json": {"@id": "ex:json", "@type": "@json"},
    "part": {"@reverse": "ex:part", "@type": "@id"},
    "named": {"@id": "ex:named", "@container": "@id"},
    "Scoped": {"@id": "ex:Scoped", "@context": {"x": "ex:x", "q": {"@id": "ex:q"}}},
    "inside": {"@id": "ex:inside", "@context": {"y": "ex:y"}},
    "id": "@id",
    "type": "@type",
}
DESCRIBED_IN = f"<{SRC}describedIn>"
NAMES = st.sampled_from([f"ex:n{i}" for i in range(6)] + ["https://example.org/#n7", "_:b"])
WORDS = st.text(st.characters(exclude_categories=["Cs", "Cc"]), max_size=6)
NUMBERS = st.integers(-(10**15), 10**15) | st.floats(-1e9, 1e9).map(lambda x: round(x, 4))
PLAIN = WORDS | NUMBERS | st.booleans() | st.none()
VALUES = PLAIN | st.fixed_dictionaries({"@value": WORDS | NUMBERS | st.booleans()})


def nodes(inner: st.SearchStrategy[Any]) -> st.SearchStrategy[dict[str, Any]]:
    node = st.fixed_dictionaries(
        {},
        optional={
            "id": NAMES,
            "type": st.sampled_from(["Scoped", "ex:T", ["ex:T", "Scoped"], []]),
            "p": VALUES | st.lists(VALUES, max_size=3) | inner,
            "ex:raw": VALUES | inner,
            "to": NAMES | st.lists(NAMES, max_size=3) | inner,
            "kind": st.sampled_from(["p", "Scoped", "ex:K"]),
            "real": NUMBERS | st.lists(NUMBERS, max_size=3),
            "list": VALUES | st.lists(VALUES | inner | st.lists(PLAIN, max_size=2), max_size=3),
            "path": st.lists(NAMES, max_size=3) | NAMES,
            "json": st.lists(PLAIN) | PLAIN | st.dictionaries(WORDS, PLAIN, max_size=2),
            "part": NAMES | st.lists(NAMES, max_size=2),
            "named": st.dictionaries(st.sampled_from(["ex:m1", "ex:m2"]), inner, max_size=2),
            "inside": st.fixed_dictionaries({"y": VALUES}),
            "x": VALUES,
            "lost": inner,
            "@reverse": st.fixed_dictionaries({"ex:r": inner}),
            "@included": st.lists(st.fixed_dictionaries({"id": NAMES, "p": WORDS}), max_size=2),
        },
    )
    return node | st.fixed_dictionaries({"id": NAMES})


NODES = st.recursive(st.fixed_dictionaries({"id": NAMES, "p": VALUES}), nodes, max_leaves=6)
TEXTS = st.builds(
    lambda graph, named, indent, ascii_only, newline: json.dumps(
        {"@context": CONTEXT, **({"id": "ex:g"} if named else {}), "@graph": graph},
        indent=indent,
        ensure_ascii=ascii_only,
    ).replace("\n", newline),
    st.lists(nodes(NODES), max_size=3),
    st.booleans(),
    st.sampled_from([None, 0, 2, "\t"]),
    st.booleans(),
    st.sampled_from(["\n", "\r\n"]),
)


def check_places(read: Document) -> None:
    source = read.source
    cells = {subject for subject, prop, _ in read.statements if prop == f"<{RDF}first>"}
    for triple in domain(read):
        # A list of one element may be written without brackets.
        listed = triple[2] in cells or triple[1] == f"<{RDF}rest>"
        span = read.map.triples[triple]
        assert listed or says(source, span, triple[2]), triple
        assert not listed or source[span][0] == "[" or source[span][-1:] not in "]}", triple
    for node in [triple[0] for triple in read.statements if triple[1] == DESCRIBED_IN]:
        whole, identifier = read.map.nodes[node]
        assert isinstance(json.loads(source[whole]), (dict, str))
        if identifier is not None:
            assert says(source, identifier, node)
        elif is_iri(node):
            raise AssertionError(node)


def canonical(nquads: str) -> str:
    """PyLD writes doubles with 16 digits, and canonicalises even those in strings: by value."""
    nquads = re.sub(r'"([^"\\]*)"(?=\^\^<[^>]*[#:]double>)', _rounded, nquads)
    return jsonld.normalize(
        nquads,
        {
            "algorithm": "URDNA2015",
            "inputFormat": "application/n-quads",
            "format": "application/n-quads",
        },
    )


def _rounded(match: re.Match[str]) -> str:
    return f'"{float(match[1]) + 0.0:.13E}"'


def ours(read: Document) -> str:
    return canonical("".join(" ".join(triple) + " .\n" for triple in domain(read)))


def theirs(content: Any, contexts: Contexts | None = None) -> str:
    """What PyLD alone makes of the content, its graphs flattened."""

    def load(url: str, _options: Any) -> dict[str, Any]:
        found = contexts.document(url) if contexts else None
        if found is None:
            raise LookupError(url)
        return {"contextUrl": None, "documentUrl": url, "document": found, "contentType": ""}

    resolver = jsonld.ContextResolver({}, load, max_context_urls=100)
    options = {"base": "https://base.kinlint.invalid/", "documentLoader": load}
    dataset = jsonld.to_rdf(content, {**options, "contextResolver": resolver})
    triples = [triple for graph in dataset.values() for triple in graph]
    return canonical(jsonld.JsonLdProcessor.to_nquads({"@default": triples}))


@pytest.mark.slow
@settings(max_examples=150)
@given(TEXTS)
def test_every_place_says_what_is_there(text: str) -> None:
    check_places(document(text))


@pytest.mark.slow
@settings(max_examples=100)
@given(TEXTS)
def test_the_triples_are_those_of_pyld(text: str) -> None:
    assert ours(document(text)) == theirs(json.loads(text))


def test_zero_and_minus_zero_are_told_apart_in_any_order() -> None:
    for zeros in (["0.0", "-0.0"], ["-0.0", "0.0"]):
        values = ", ".join(zeros)
        read = document(f'{{"@context": {json.dumps(CONTEXT)}, "list": [], "real": [{values}]}}')
        found = [value for _, prop, value in domain(read) if prop.endswith("#real>")]
        assert [value[1:].partition('"')[0] for value in found] == [f"{zero}E0" for zero in zeros]
