"""Queries and updates are read as the grammar of SPARQL 1.1 says, and written back the same."""

import pytest

from kinlint import resources
from kinlint.contexts.model_prefixes import model_prefixes
from kinlint.engine.store import Store
from kinlint.sparql.ast import Bind, Clause, Triples, render
from kinlint.sparql.parser import parse_construct, parse_update
from kinlint.sparql.patterns import template
from kinlint.sparql.tokens import NotSparql
from kinlint.vocabulary import INTERMEDIATE

PREFIXES = {"": "https://example.org/", "rdf": "http://www.w3.org/1999/02/22-rdf-syntax-ns#"}
XSD = "http://www.w3.org/2001/XMLSchema#"


def triples(text, **options):
    return template(
        parse_construct(f"CONSTRUCT {{ {text} }} WHERE {{}}", PREFIXES).template.tokens, **options
    )


def test_a_construct_query_is_read():
    """Its template is apart from its group, and names are written out."""
    query = parse_construct(
        """
        PREFIX ex: <https://example.org/ns#>  # its own
        construct { ?a ex:b ?c . ?c :d 1 }
        where { ?a ex:b ?c OPTIONAL { ?c ex:d ?d } BIND (?d AS ?e) }
        order by ?a
        """,
        PREFIXES,
    )

    assert query.template.tokens == (
        "?a",
        "<https://example.org/ns#b>",
        "?c",
        ".",
        "?c",
        "<https://example.org/d>",
        "1",
    )
    assert [type(each) for each in query.group.elements] == [Triples, Clause, Bind]
    assert query.tail == ("order", "by", "?a")
    assert parse_construct(render(query)) == query


def test_an_update_is_read():
    """What it removes, what it adds and where may each be empty or missing."""
    both = parse_update("DELETE { ?a :p ?b } INSERT { ?a :q ?b } WHERE { ?a :p ?b } ;", PREFIXES)
    one = parse_update("insert { ?a :q 1 } where {}", PREFIXES)

    assert both.removed.tokens == ("?a", "<https://example.org/p>", "?b")
    assert both.added.tokens == ("?a", "<https://example.org/q>", "?b")
    assert (one.removed.tokens, one.added.tokens[-1]) == ((), "1")
    assert [parse_update(render(each)) for each in (both, one)] == [both, one]


def test_a_template_is_taken_apart():
    """In the order of the text, blank nodes after what leads to them."""
    assert triples("?a a :B , ?c ; :d [ :e 'it\\'s' ; :f [] ] . _:x :y true , 1.5") == [
        ("?a", f"<{PREFIXES['rdf']}type>", "<https://example.org/B>"),
        ("?a", f"<{PREFIXES['rdf']}type>", "?c"),
        ("?a", "<https://example.org/d>", "_:0"),
        ("_:0", "<https://example.org/e>", '"it\'s"'),
        ("_:0", "<https://example.org/f>", "_:1"),
        ("_:x", "<https://example.org/y>", f'"true"^^<{XSD}boolean>'),
        ("_:x", "<https://example.org/y>", f'"1.5"^^<{XSD}decimal>'),
    ]


def test_a_list_of_a_template_is_one_term_or_spelled_out():
    """As whoever reads the template needs it."""
    assert triples("?a :b ( ?x 2 )", lists=True) == [
        ("?a", "<https://example.org/b>", f'( ?x "2"^^<{XSD}integer> )')
    ]
    spelled = triples("?a :b ( ?x )")
    assert [(s, p.rpartition("#")[2], o) for s, p, o in spelled[1:]] == [
        ("_:0", "first>", "?x"),
        ("_:0", "rest>", f"<{PREFIXES['rdf']}nil>"),
    ]


@pytest.mark.parametrize(
    ("term", "token"),
    [
        ("'''a\"b'''", '"a\\"b"'),
        ('"""two\nlines"""', '"two\\nlines"'),
        ("'x'@en-GB", '"x"@en-GB'),
        (f"'1'^^<{XSD}int>", f'"1"^^<{XSD}int>'),
        ("-1e3", f'"-1e3"^^<{XSD}double>'),
    ],
)
def test_literals_of_a_template_are_values(term, token):
    """However they are written."""
    assert triples(f"?a :b {term}") == [("?a", "<https://example.org/b>", token)]


@pytest.mark.parametrize(
    ("parse", "text", "said", "place"),
    [
        (parse_construct, "SELECT * {}", "'SELECT' stands where CONSTRUCT is due", "SELECT"),
        (
            parse_construct,
            "CONSTRUCT { ?a ?b ?c } [ ]",
            "where { is due",
            "[ ]$",
        ),
        (
            parse_construct,
            "CONSTRUCT { FILTER (1) } WHERE {}",
            "'FILTER' stands in a template",
            "FILTER",
        ),
        (parse_update, "DELETE DATA { <a:> <a:> <a:> }", "'DATA' stands where { is due", "DATA"),
        (parse_update, "DELETE {} WHERE {} ; INSERT {} WHERE {}", "after the end", "INSERT"),
        (parse_update, "DELETE { ?a ?b ?c }", "ends too early", "$"),
        (
            parse_update,
            "PREFIX a: <a:> DELETE { ?a b:b ?c } WHERE {}",
            "'b:' is not declared",
            "b:b",
        ),
    ],
)
def test_what_does_not_fit_is_said_with_its_place(parse, text, said, place):
    """So that whoever wrote it finds it."""
    with pytest.raises(NotSparql, match=said) as refusal:
        parse(text)

    rest = text[refusal.value.offset(text) :]
    assert rest == place[:-1] if place.endswith("$") else rest.startswith(place)


def test_a_path_is_no_part_of_a_template():
    """A template says which triples there are."""
    with pytest.raises(NotSparql, match="is a path"):
        triples("?a :b/:c ?d")


@pytest.mark.parametrize(
    "file",
    sorted(resources.data("shapes").glob("lifting/*/*.rq")),
    ids=lambda file: f"{file.parent.name}-{file.stem}",
)
def test_each_lifting_query_is_written_back_the_same(file):
    """Oxigraph takes what is written for the same query: it can run it, at least."""
    query = parse_construct(file.read_text("utf-8"), {**model_prefixes(), "ir": INTERMEDIATE})

    Store().oxigraph.query(render(query))
    assert parse_construct(render(query)) == query
    assert template(query.template.tokens, lists=True)
