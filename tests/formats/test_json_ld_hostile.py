"""Files that nobody would write are read or refused, never more than that."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

import pytest
from reading import document, domain, losses

from kinlint.errors import SourceError

CONTEXT = '"@context": {"p": "https://e.org/p"}'


class Library:
    """Contexts by the last part of `https://c.org/NAME`."""

    release = ""

    def __init__(self, **contexts: Any) -> None:
        self.contexts = contexts
        self.memory: dict[Any, Any] = {}

    def document(self, iri: str) -> Mapping[str, Any] | None:
        found = self.contexts.get(iri.removeprefix("https://c.org/"))
        return None if found is None else {"@context": found}

    def below(self, iri: str) -> tuple[str, ...]:
        return ()

    def at_release(self, release: str) -> Library:
        return self


def read(context: Any, library: Library | None = None, **content: Any) -> Any:
    content = {"@context": context, "@id": "https://e.org/a", **content}
    return document(content, contexts=library or Library(), releases=())


def test_contexts_that_include_each_other() -> None:
    library = Library(a=["https://c.org/b"], b="https://c.org/a")
    found = losses(read(["https://c.org/a", {"p": "https://e.org/p"}], library, p=1, q=2))
    assert found == [("InvalidContext", '"https://c.org/a"'), ("UnreadKey", '"q"')]


def test_a_context_that_scopes_itself() -> None:
    scoped = {
        "p": "https://e.org/p",
        "T": {"@id": "https://e.org/T", "@context": "https://c.org/a"},
    }
    found = read("https://c.org/a", Library(a=scoped), **{"@type": "T", "p": {"@type": "T"}})
    assert losses(found) == []
    assert len(domain(found)) == 3


def test_a_context_document_with_an_error_in_it() -> None:
    broken = {"p": "https://e.org/p", "q": {"@id": 7}}
    found = read("https://c.org/a", Library(a=broken), p=1, q=2)
    assert losses(found) == [("InvalidContext", '"https://c.org/a"'), ("UnreadKey", '"q"')]
    assert len(domain(found)) == 1


def test_a_context_document_that_does_not_propagate() -> None:
    library = Library(a={"@propagate": False, "p": "https://e.org/p"})
    assert losses(read("https://c.org/a", library, p={"p": 1})) == [("DroppedKey", '"p"')]


def test_imports_leave_the_imported_document_as_it_was() -> None:
    library = Library(a={"p": "https://e.org/p"})
    extended = {"@import": "https://c.org/a", "q": "https://e.org/q"}
    assert losses(read([extended, None, "https://c.org/a"], library, p=1, q=1)) == [
        ("DroppedKey", '"q"')
    ]
    assert library.contexts == {"a": {"p": "https://e.org/p"}}


def test_imports_of_nothing_and_of_imports() -> None:
    own = {"@import": "https://c.org/a", "p": "https://e.org/p"}
    assert losses(read(own, p=1, q=1))[0][0] == "UnresolvedContext"
    library = Library(a={"@import": "https://c.org/a"})
    assert losses(read(own, library, p=1))[0][0] == "InvalidContext"


def test_twenty_contexts_are_no_cycle() -> None:
    library = Library(**{f"c{i}": {f"p{i}": f"https://e.org/{i}"} for i in range(20)})
    found = read([f"https://c.org/c{i}" for i in range(20)], library, p0=1, p19=1)
    assert len(domain(found)) == 2


@pytest.mark.parametrize(
    ("content", "statements"),
    [
        ('"p": ' + '{"p": ' * 490 + "1" + "}" * 490, 491),
        ('"p": ' + "[" * 490 + "1" + "]" * 490, 1),
        ('"@graph": ' + '[{"@graph": ' * 245 + '[{"p": 1}]' + "}]" * 245, 1),
        ('"p": "' + "\\n" * 1_000_000 + "x" * 5_000_000 + '"', 1),
        ('"p": [' + ", ".join(map(str, range(20_000))) + "]", 20_000),
        (", ".join(f'"p": {i}' for i in range(5_000)), 1),
    ],
    ids=["objects", "arrays", "graphs", "a string", "an array", "repetitions"],
)
def test_deep_and_long_files_are_read(content: str, statements: int) -> None:
    """All that they state; of repeated keys the last."""
    assert len(domain(document(f"{{{CONTEXT}, {content}}}"))) == statements


def test_nesting_without_end_is_refused_at_its_place() -> None:
    with pytest.raises(SourceError, match="levels deep"):
        document(f'{{{CONTEXT}, "p": ' + "[" * 100_000)


def test_contexts_nested_deep() -> None:
    content = '{"p": {"@id": "https://e.org/p", "@context": ' * 240 + "{}" + "}}" * 240
    (statement,) = domain(document('{"@context": ' + content + ', "p": 1}'))
    assert statement[1] == "<https://e.org/p>"


@pytest.mark.parametrize(
    ("content", "line", "cause"),
    [
        ({"p": [{"@id": "https://e.org/b"}, {"@id": 5}]}, 10, "@id value must be a string"),
        ({"@type": [5]}, 5, "@type value must be"),
        ({"p": {"@value": [1]}}, 6, "@value"),
        ({"p": {"@value": "x", "@language": 1}}, 7, "@language"),
        ({"p": {"@list": [], "q": 1, "p": 2}}, 5, "@list"),
        ({"@reverse": 1}, 5, "@reverse"),
    ],
)
def test_json_that_breaks_the_rules_of_json_ld(content: Any, line: int, cause: str) -> None:
    whole = {"@context": {"p": "https://e.org/p"}, **content}
    with pytest.raises(SourceError, match=cause) as caught:
        document(json.dumps(whole, indent=1))
    assert caught.value.line == line


@pytest.mark.parametrize("text", ['"x"', "5", "null"])
def test_a_mere_value_is_no_json_ld(text: str) -> None:
    with pytest.raises(SourceError, match="neither an object nor an array"):
        document(text)


@pytest.mark.parametrize("name", ["hasOwnProperty", "__class__", "toString", "mappings", "_blind"])
def test_no_name_is_special(name: str) -> None:
    found = read({name: f"https://e.org/{name}"}, **{name: 1})
    assert domain(found)[0][1] == f"<https://e.org/{name}>"


@pytest.mark.parametrize(
    ("number", "lexical", "datatype"),
    [
        ("0.1", "1.0E-1", "double"),
        ("0.10010000000000001", "1.0010000000000001E-1", "double"),
        ("5e-324", "5.0E-324", "double"),
        ("-1.5e300", "-1.5E300", "double"),
        ("1e21", "1.0E21", "double"),
        ("123456789012345678901234567890", "1.2345678901234568E29", "double"),
        ("100.0", "100", "integer"),
        ("-0", "0", "integer"),
        ("999999999999999999999", "999999999999999999999", "integer"),
    ],
)
def test_numbers_lose_no_digit(number: str, lexical: str, datatype: str) -> None:
    found = document(f'{{{CONTEXT}, "p": {number}}}')
    value = domain(found)[0][2]
    assert value == f'"{lexical}"^^<http://www.w3.org/2001/XMLSchema#{datatype}>'
    assert found.source[found.map.triples[domain(found)[0]]] == number
