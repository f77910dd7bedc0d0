"""Trees of queries come back from JSON as they were."""

import json

import pytest

from kinlint import resources
from kinlint.contexts.model_prefixes import model_prefixes
from kinlint.sparql.ast_json import from_json, to_json
from kinlint.sparql.parser import parse_construct, parse_update
from kinlint.vocabulary import INTERMEDIATE

PREFIXES = {**model_prefixes(), "ir": INTERMEDIATE}
QUERIES = sorted(resources.data("shapes").glob("lifting/*/*.rq"))


def kept(tree):
    """*tree* written as JSON and read again."""
    return from_json(json.loads(json.dumps(to_json(tree))))


@pytest.mark.parametrize("file", QUERIES, ids=lambda file: f"{file.parent.name}/{file.stem}")
def test_lifting_queries(file):
    """Whatever they consist of."""
    tree = parse_construct(file.read_text("utf-8"), PREFIXES)

    assert kept(tree) == tree
    assert hash(kept(tree)) == hash(tree)


def test_updates():
    """With a sub-select, values and an existence test."""
    tree = parse_update(
        "DELETE { ?s ?p ?o } INSERT { ?s ?p 1 } WHERE { { SELECT ?s { ?s ?p ?o } LIMIT 1 } "
        "VALUES ?p { <urn:p> } FILTER NOT EXISTS { ?s <urn:q> 'two words' } MINUS { ?s ?s ?s } }",
        {},
    )

    assert kept(tree) == tree
