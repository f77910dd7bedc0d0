"""Values in Turtle give way to others; all else cannot be said."""

from __future__ import annotations

import pytest
from editing_json_ld import OPTIONS
from support.linting import document

from kinlint.document import Document
from kinlint.edits import Delta, NotExpressible, applied
from kinlint.formats.registry import editor
from kinlint.terms import XSD, Term, Triple, literal

TEXT = """@prefix e: <https://e.org/#> .\r
@prefix xsd: <http://www.w3.org/2001/XMLSchema#> .\r
e:a e:real 1.570e0 ; e:to e:b , <https://e.org/other> ; # 1.570e0\r
    a e:Arm ; e:word 'it' ; e:whole 3 ; e:list ( 1 2 ) ; e:odd "x"^^e:t .\r
e:c e:to [ e:real 2e0 ] ; e:real 5e0 . e:c e:real 5e0 .\r
"""


def found(text: str = TEXT) -> Document:
    return document(text, "arm.ttl")


def after(*changes: tuple[str, Term]) -> str:
    """The text after values, given as they are written, are replaced."""
    model = found()
    old = [triple_at(model, text) for text, _ in changes]
    new = [(*triple[:2], value) for triple, (_, value) in zip(old, changes, strict=True)]
    edits = editor(model, OPTIONS).edits(Delta(tuple(old), tuple(new)))
    return applied(TEXT, edits)


def triple_at(model: Document, text: str) -> Triple:
    spans = model.map.triples.items()
    return next(triple for triple, span in spans if model.source[span] == text)


@pytest.mark.parametrize(
    ("old", "new", "written"),
    [
        ("1.570e0", literal("2.5E-1", f"{XSD}double"), "2.5E-1"),
        ("1.570e0", literal("0.25", f"{XSD}double"), '"0.25"^^xsd:double'),
        ("1.570e0", literal("0.25", f"{XSD}decimal"), "0.25"),
        ("e:b", "<https://e.org/#z>", "e:z"),
        ("e:b", "<https://e.org/z>", "<https://e.org/z>"),
        ("<https://e.org/other>", "<https://e.org/#a/b>", "<https://e.org/#a/b>"),
        ("e:Arm", "<https://e.org/#Leg>", "e:Leg"),
        ("'it'", literal('say "x"\n'), "'say \"x\"\\n'"),
        ("'it'", literal("it's"), '"it\'s"'),
        ("'it'", literal("es", language="de"), "'es'@de"),
        ("3", literal("4", f"{XSD}integer"), "4"),
        ("3", literal("true", f"{XSD}boolean"), "true"),
        ("2", literal("7", f"{XSD}integer"), "7"),
        ('"x"^^e:t', literal("y\\", "https://e.org/#t"), '"y\\\\"^^e:t'),
        ("2e0", literal("3E0", f"{XSD}double"), "3E0"),
    ],
)
def test_a_value_gives_way_to_another(old: str, new: Term, written: str) -> None:
    at = TEXT.index(old, TEXT.index("e:a e:real"))
    assert after((old, new)) == TEXT[:at] + written + TEXT[at + len(old) :]
    again = found(after((old, new)))
    assert any(triple[2] == new for triple in again.statements)


def test_values_change_places() -> None:
    one, other = literal("3", f"{XSD}integer"), literal("it")
    text = after(("'it'", one), ("3", other))
    assert 'e:word 3 ; e:whole "it" ;' in text


@pytest.mark.parametrize(
    ("removed", "added", "reason"),
    [
        (["3"], [], "only one value can take the place of another"),
        ([], [("<https://e.org/#a>", "<https://e.org/#p>", '"x"')], "nothing is added"),
        (["[ e:real 2e0 ]"], ["<https://e.org/#b>"], "only one value"),
        (["3"], ["_:b"], "nothing is added"),
        (["5e0"], [literal("1E0", f"{XSD}double")], "not written in one place"),
        (["e:Arm"], ['"Leg"'], "a class is no literal"),
    ],
)
def test_what_turtle_does_not_say(removed: list[str], added: list[object], reason: str) -> None:
    model = found()
    old = [triple_at(model, text) for text in removed]
    new = [each if isinstance(each, tuple) else (*old[0][:2], each) for each in added]
    with pytest.raises(NotExpressible, match=reason):
        editor(model, OPTIONS).edits(Delta(tuple(old), tuple(new)))  # type: ignore[arg-type]
