"""JSON-LD before and after: the difference of the graphs is written as a person would."""

from __future__ import annotations

from pathlib import Path
from textwrap import indent

import pytest
from editing_json_ld import OPTIONS, document, domain, edited

from kinlint.edits import Delta, applied
from kinlint.formats.jsonld.editing.editor import Editor

TEXT = Path(__file__).with_name("json_ld_edits.txt")
CONTEXT = (
    '"@context": '
    '[ "https://w3id.org/kinlint/composable.json", { "ex": "https://example.org/arm#" } ]'
)


def delta(before: str, after: str) -> Delta:
    """What *after* says and *before* does not, and the other way round."""
    old, new = domain(document(before)), domain(document(after))
    return Delta(
        tuple(triple for triple in old if triple not in set(new)),
        tuple(triple for triple in new if triple not in set(old)),
    )


def model(nodes: str, *, newline: str = "\n") -> str:
    """A file with *nodes* in its graph, indented by two."""
    text = f'{{\n  {CONTEXT},\n  "@id": "ex:model",\n  "@graph": [\n{nodes}\n  ]\n}}\n'
    return text.replace("\n", newline)


EXAMPLES = dict(
    example.split("\n", 1)
    for example in ("\n" + TEXT.read_text(encoding="utf-8")).split("\n## ")[1:]
)


def sides(name: str, newline: str = "\n") -> list[str]:
    """The two files of the example called *name*."""
    parts = EXAMPLES[name].split("\n=>\n")
    return [model(indent(part.rstrip("\n"), " " * 4), newline=newline) for part in parts]


@pytest.mark.parametrize("newline", ["\n", "\r\n"])
@pytest.mark.parametrize("name", EXAMPLES)
def test_a_difference_is_written_as_it_would_be_by_hand(name: str, newline: str) -> None:
    before, after = sides(name, newline)
    there = delta(before, after)
    assert there
    assert edited(document(before), there) == after


BOTH_WAYS = sorted(set(EXAMPLES) - {"a property", "a second value", "a type"})


@pytest.mark.parametrize("name", BOTH_WAYS)
def test_a_difference_can_be_taken_back(name: str) -> None:
    before, after = sides(name)
    back = delta(after, before)
    text = edited(document(after), back)
    assert delta(text, before) == Delta()


EX, SRC = "https://example.org/arm#", "https://w3id.org/kinlint/source#"
P, Q = f"<{EX}p>", f"<{EX}q>"
DOUBLE = "<http://www.w3.org/2001/XMLSchema#double>"
A, B = f"<{EX}a>", f"<{EX}b>"


def number(spelling: str) -> str:
    return f'"{spelling}"^^{DOUBLE}'


def rewritten(
    before: str, removed: list[tuple[str, str, str]], added: list[tuple[str, str, str]]
) -> str:
    return edited(document(before), Delta(tuple(removed), tuple(added)))


def written(before: str, *edits: Delta) -> str:
    """*before* after deltas whose effect on the graph is checked elsewhere, all by one editor."""
    read = document(before)
    editor = Editor(read, OPTIONS)
    found = [edit for each in edits for edit in editor.edits(each)]
    return applied(before, found)


def test_a_value_that_moves_keeps_its_spelling() -> None:
    text = model('    { "@id": "ex:a", "@type": "VectorXYZ", "x": 1.570, "y": 2E0 }')
    old = {prop: (A, prop, value) for _, prop, value in domain(document(text)) if value[0] == '"'}
    (x, first), (y, second) = old.items()
    swapped = [(A, x, number("2E0")), (A, y, number("1.570"))]
    assert '"x": 2E0, "y": 1.570 }' in rewritten(text, [first, second], swapped)


@pytest.mark.parametrize(
    ("spelling", "text"),
    [
        ("1.0E0", "1.0"),
        ("1.0E-6", "1e-06"),
        ("1.5707963267948966E0", "1.5707963267948966"),
        ("0.1", "0.1"),
        ("-0.0E0", "-0.0"),
        ("+5", "5.0"),
        ("1", "1.0"),
        ("0.1000", "0.1"),
        (".5", "0.5"),
        ("1.0E100", "1e+100"),
    ],
)
def test_a_new_number_has_the_digits_that_it_needs(spelling: str, text: str) -> None:
    before = model('    { "@id": "ex:a", "@type": "VectorXYZ", "x": 7.5 }')
    old = next(triple for triple in domain(document(before)) if triple[2][0] == '"')
    after = rewritten(before, [old], [(*old[:2], number(spelling))])
    assert after == before.replace("7.5", text)


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ('"x": "1.570", "y": "-2"', '"x": "-2", "y": "1.570"'),
        ('"x": "1.570", "y": -2E0', '"x": "-2E0", "y": 1.570'),
        (
            f'"x": 1.570, "y": {{"@type": "{DOUBLE[1:-1]}", "@value": "-2.50"}}',
            f'"x": -2.50, "y": {{"@type": "{DOUBLE[1:-1]}", "@value": "1.570"}}',
        ),
        ('"x": 1, "y": -26e-1', '"x": -26e-1, "y": 1'),
    ],
)
def test_values_that_change_places_keep_their_spelling(before: str, after: str) -> None:
    text = model(f'    {{ "@id": "ex:a", "@type": "VectorXYZ", {before} }}')
    old = [triple for triple in domain(document(text)) if triple[2][0] == '"']
    values = [float(value[1:].partition('"')[0]) for _, _, value in old]
    swapped = [
        (*each[:2], number(f"{value!r}")) for each, value in zip(old, values[::-1], strict=True)
    ]
    assert after in rewritten(text, old, swapped)


def test_a_new_number_in_quotes_is_as_short_as_others() -> None:
    before = model('    { "@id": "ex:a", "@type": "VectorXYZ", "x": "7.5" }')
    old = next(triple for triple in domain(document(before)) if triple[2][0] == '"')
    assert rewritten(before, [old], [(*old[:2], number("5.0E-1"))]) == before.replace("7.5", "0.5")


def test_what_json_has_no_number_for_is_written_in_quotes() -> None:
    before = model('    { "@id": "ex:a", "@type": "VectorXYZ", "x": 7.5 }')
    old = next(triple for triple in domain(document(before)) if triple[2][0] == '"')
    assert rewritten(before, [old], [(*old[:2], number("INF"))]) == before.replace("7.5", '"INF"')


def test_a_number_in_quotes_stays_in_quotes() -> None:
    before = model('    { "@id": "ex:a", "@type": "VectorXYZ", "x": "7.5" }')
    old = next(triple for triple in domain(document(before)) if triple[2][0] == '"')
    assert rewritten(before, [old], [(*old[:2], number("0.5"))]) == before.replace("7.5", "0.5")


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ('    { "@type": "Frame" }', '    { "@id": "ex:n", "@type": "Frame" }'),
        (
            '    {\n      "@type": "Frame",\n      "ex:p": { "ex:q": 1 } }',
            '    {\n      "@id": "ex:n",\n      "@type": "Frame",\n      "ex:p": { "ex:q": 1 } }',
        ),
        ('    { "@id": "_:x", "@type": "Frame" }', '    { "@id": "ex:n", "@type": "Frame" }'),
        (
            '    { "@id": "ex:a", "ex:p": { "@type": "Frame" } }',
            '    { "@id": "ex:a", "ex:p": { "@id": "ex:n", "@type": "Frame" } }',
        ),
        (
            '    { "@id": "_:x", "@type": "Frame" },\n    { "ex:p": { "@id": "_:x" } }',
            '    { "@id": "ex:n", "@type": "Frame" },\n    { "ex:p": { "@id": "ex:n" } }',
        ),
    ],
)
def test_an_anonymous_node_gets_a_name(before: str, after: str) -> None:
    text, name = model(before), f"<{EX}n>"
    triples = domain(document(text))
    node = next(s for s, _, value in triples if value.endswith("#Frame>"))
    old = [triple for triple in triples if node in triple]
    new = [tuple(name if term == node else term for term in triple) for triple in old]
    assert rewritten(text, old, new) == model(after)  # type: ignore[arg-type]


def test_a_new_node_without_a_name_stands_where_it_is_used() -> None:
    before = model('    { "@id": "ex:a", "@type": "Frame" }')
    new = [(A, P, "_:n"), ("_:n", Q, number("0.5")), ("_:n", Q, '"x"')]
    after = '    { "@id": "ex:a", "@type": "Frame", "ex:p": { "ex:q": [ 0.5, "x" ] } }'
    assert rewritten(before, [], new) == model(after)


def test_a_node_without_a_name_moves_as_it_is_written() -> None:
    nodes = '    { "@id": "ex:a", "ex:r": 1%s },\n    { "@id": "ex:b", %s"ex:q": 2 }'
    moving = '"ex:p": { "ex:q":  1 }'
    before = model(nodes % (f", {moving}", ""))
    (_, _, node) = triple = next(t for t in domain(document(before)) if t[:2] == (A, P))
    assert rewritten(before, [triple], [(B, P, node)]) == model(nodes % ("", f"{moving}, "))


def lost(before: str, prop: str, old: str, new: str | None = None) -> Delta:
    """The loss of *old* that is mended, or taken out."""
    read = document(before)
    triple = next(t for t in read.statements if t[1:] == (f"<{SRC}{prop}>", f'"{old}"'))
    return Delta((triple,), ((*triple[:2], f'"{new}"'),) if new else ())


def test_a_lost_key_is_called_otherwise() -> None:
    before = model('    { "@id": "ex:a", "@type": "Position", "with-regard-to": "ex:b" }')
    after = before.replace("with-regard-to", "with-respect-to")
    assert written(before, lost(before, "key", "with-regard-to", "with-respect-to")) == after


def test_a_lost_key_is_taken_out() -> None:
    before = model('    { "@id": "ex:a", "lost": 1, "@type": "Position" }')
    assert written(before, lost(before, "key", "lost")) == before.replace('"lost": 1, ', "")


def test_a_repeated_key_is_taken_out() -> None:
    before = model('    { "@id": "ex:a", "ex:p": 1, "ex:q": 2, "ex:p": 1 }')
    assert written(before, lost(before, "key", "ex:p")) == before.replace(', "ex:p": 1 }', " }")


def test_a_context_is_called_otherwise() -> None:
    before = model('    { "@id": "ex:a" }').replace("composable.json", "composible.json")
    old, new = (f"https://w3id.org/kinlint/compos{letter}ble.json" for letter in "ia")
    assert written(before, lost(before, "context", old, new)) == model('    { "@id": "ex:a" }')


CONTEXTS = {
    "": '"@context": "urn:new", ',
    '"@context": "urn:old", ': '"@context": [ "urn:old", "urn:new" ], ',
    '"@context": { "ex": "urn:ex#" }, ': '"@context": [ "urn:new", { "ex": "urn:ex#" } ], ',
    '"@context": [ "urn:old" ], ': '"@context": [ "urn:old", "urn:new" ], ',
    '"@context": [ "urn:old", { "ex": "urn:ex#" } ], ': (
        '"@context": [ "urn:old", "urn:new", { "ex": "urn:ex#" } ], '
    ),
    '"@context": [], ': '"@context": [ "urn:new" ], ',
    '"@context": null, ': '"@context": "urn:new", ',
}


@pytest.mark.parametrize("old", CONTEXTS)
def test_a_context_is_added_before_the_terms_of_the_file(old: str) -> None:
    before = f'{{ {old}"@id": "urn:a" }}'
    read = document(before)
    delta = Delta((), ((read.graph, f"<{SRC}context>", "<urn:new>"),))
    edits = Editor(read, OPTIONS).edits(delta)
    assert applied(before, edits) == f'{{ {CONTEXTS[old]}"@id": "urn:a" }}'


LABEL = "<http://www.w3.org/2000/01/rdf-schema#label>"
RDFS = '"rdfs": "http://www.w3.org/2000/01/rdf-schema#"'
PREFIXES = {
    '"@context": { "ex": "https://example.org/arm#" }': (
        f'"@context": {{ "ex": "https://example.org/arm#", {RDFS} }}'
    ),
    '"@context": "https://w3id.org/kinlint/composable.json"': (
        f'"@context": [ "https://w3id.org/kinlint/composable.json", {{ {RDFS} }} ]'
    ),
    '"@context": [ "https://w3id.org/kinlint/composable.json" ]': (
        f'"@context": [ "https://w3id.org/kinlint/composable.json", {{ {RDFS} }} ]'
    ),
}


@pytest.mark.parametrize("old", PREFIXES)
def test_a_prefix_is_added_for_a_property_that_no_context_maps(old: str) -> None:
    before = f'{{ {old}, "@id": "{EX}a", "{EX}p": 1 }}'
    after = f'{{ {PREFIXES[old]}, "@id": "{EX}a", "{EX}p": 1, "rdfs:label": "it" }}'
    assert rewritten(before, [], [(A, LABEL, '"it"')]) == after


def test_an_iri_that_nobody_abbreviates_is_written_out() -> None:
    before = f'{{"@context": {{}}, "@id": "{EX}a", "{EX}q": 1}}'
    after = before.replace("}, ", "}, ").replace("1}", f'1, "{EX}p": {{"@id": "{EX}b"}}}}')
    assert rewritten(before, [], [(A, P, B)]) == after
