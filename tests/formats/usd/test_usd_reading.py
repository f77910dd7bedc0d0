"""What text layers state, and where it is written."""

from __future__ import annotations

import pytest
from reading_usd import HEAD, read, said, values

from kinlint.errors import SourceError
from kinlint.formats.usd.layer_comment_edit import comment_edit
from kinlint.text import Span

ARM = """
def Xform "arm" (
    prepend apiSchemas = ["PhysicsArticulationRootAPI", "PhysicsDriveAPI:angular"]
    delete references = @a.usda@</b>
    kind = "component"
)
{
    double3 xformOp:translate = (1, -.5, 2e1)
    custom uniform token[] xformOpOrder = ['xformOp:translate']
    rel physics:body0 = [<../base>, </arm/tip>]
    float x.timeSamples = { 0: 1, 1: 2 }
    float x = 3; float x = 4 // the last one counts
    over "tip" { bool flag = 1; }
    class "c" {} # comment
    variantSet "look" = { "red" { def Cube "cube" {}
    } }
}
"""


def test_values_are_at_their_places():
    layer = read(ARM)

    assert list(said(layer, "xformOp:translate-2")) == [("/prim/arm", "-.5", "-.5")]
    assert list(said(layer, "xformOpOrder-1")) == [
        ("/prim/arm", "xformOp:translate", "xformOp:translate")
    ]
    assert list(said(layer, "x")) == [("/prim/arm", "4", "4")]
    assert values(layer, "flag") == {"/prim/arm/prim/tip": "true"}
    assert values(layer, "attribute#metersPerUnit") == {"": "1"}
    assert values(layer, "kind") == {"/prim/arm": "component"}


def test_prims_have_specifiers_types_and_places():
    layer = read(ARM)

    assert values(layer, "specifier") == {
        "/prim/arm": "def",
        "/prim/arm/prim/tip": "over",
        "/prim/arm/prim/c": "class",
        "/prim/arm/variantSet/look/variant/red/prim/cube": "def",
    }
    (place,) = (
        spans.best for node, spans in layer.map.nodes.items() if node.endswith("#/prim/arm>")
    )
    assert layer.source[place] == '"arm"'


def test_items_of_lists_have_their_operation():
    layer = read(ARM)

    assert values(layer, "value") == {
        "/prim/arm/apiSchema": "PhysicsArticulationRootAPI",
        "/prim/arm/apiSchema;2": "PhysicsDriveAPI:angular",
    }
    assert values(layer, "op") == {
        "/prim/arm/apiSchema": "prepend",
        "/prim/arm/apiSchema;2": "prepend",
        "/prim/arm/reference": "delete",
    }
    assert values(layer, "asset") == {"/prim/arm/reference": "a.usda"}


def test_targets_lead_to_prims():
    """Relative paths begin at the prim with the relationship."""
    layer = read(ARM)
    stem = "/prim/arm/relationship/physics%3Abody0/target"

    assert values(layer, "prim")[stem] == "/prim/base"
    assert values(layer, "prim")[f"{stem};2"] == "/prim/arm/prim/tip"
    assert [text for _, _, text in said(layer, "path")][:1] == ["/b"]


@pytest.mark.parametrize(
    ("written", "reason"),
    [
        ("float physics:mass = nan", "nan is not a number"),
        ("float physics:mass = 1e400", "1e400 is too large for a float"),
        ("float physics:mass = 1e39", "1e39 is too large for a float"),
        ('float physics:mass = "4"', "4 is not a number"),
        ("float3 physics:diagonalInertia = (1, 2)", "2 values"),
        ("bool physics:rigidBodyEnabled = on", "on is neither true nor false"),
    ],
)
def test_values_that_are_none_of_their_type_are_stated(written, reason):
    layer = read(f'def "arm" {{ {written}; }}')

    assert set(values(layer, "reason").values()) == {reason}


@pytest.mark.parametrize(
    ("written", "meant"), [("yes", "true"), ("TRUE", "true"), ("2", "true"), ("No", "false")]
)
def test_words_of_truth_are_those_of_openusd(written, meant):
    layer = read(f'def "arm" {{ bool physics:rigidBodyEnabled = {written}; }}')

    assert set(values(layer, "physics:rigidBodyEnabled").values()) == {meant}


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        ('def "a" {', "expected '}', found the end of the file"),
        ('def "a" { float x = 1 float y = 2 }', "expected a line break or ';' behind a statement"),
        ('def "a" { float x = 90 }', "expected a line break or ';' behind a statement"),
        ('def "a" { float x = 90;; }', "expected a prim or a property"),
        ('def "a" (d = {int b = 1, int c = 2})', "expected a line break or ';' behind a statement"),
        ('def "a" { float x.timeSamples = { 0: 1; 1: 2 }; }', "expected ',' or '}'"),
        ("def a {}", "expected the name of a prim in quotes"),
        ('def "a" { float x = "1 }', "a string is not closed"),
        ("float x = 1", "expected 'def', 'over' or 'class'"),
        ('def "a" { float x = (1, 2 }', "expected ',' or ')'"),
        ('def "a" { rel x = "/b" }', "expected the path of a target"),
        ('def "a" {};', "';' stands behind a block"),
        ('def "a" { def "b" {}; }', "';' stands behind a block"),
        ('def "a" {\n float x = 1\n ; }', "';' stands at the start of a line"),
        ('def "a" { float x = 1 /* \n */ float y = 2\n }', "expected a line break or ';'"),
        ('def "a" { rel x =\n </b>\n }', "a line break stands in the middle of a statement"),
        ('def "a" { float[] x = [1\n , 2]\n }', "a line break stands in the middle"),
        ('def "a" { float2 x = ()\n }', "expected a number, found ')'"),
    ],
)
def test_a_text_that_is_no_layer_states_only_that(content, reason):
    layer = read(content)

    ((_, told, _),) = said(layer, "reason")
    assert told.startswith(reason)
    assert values(layer, "unread")
    assert not values(layer, "specifier")


@pytest.mark.parametrize(
    ("content", "repeated"),
    [
        ('def "a" { rel x = [</b>, <../b>]; }', "<../b>"),
        ('def "a" { float x.connect = [</b.x>, </b.x>]; }', "</b.x>"),
        ('def "a" ( inherits = [</b>, </c>, </b>] ) {}', "</b>"),
        ('def "a" ( variantSets = ["b", "b"] ) {}', '"b"'),
    ],
)
def test_an_item_that_openusd_finds_twice_in_a_list_is_no_value(content, repeated):
    layer = read(content)

    assert [told for _, told, _ in said(layer, "reason")] == ["it is listed before"]
    (place,) = (
        spans.best
        for node, spans in layer.map.nodes.items()
        if node in {node for node, way, _ in layer.statements if way.endswith("#reason>")}
    )
    assert layer.source.text[place.start :].startswith(repeated)


@pytest.mark.parametrize(
    "content",
    [
        'def Xform "a"\n(\n kind = "b"\n)\n\n{\n}\n',
        'def "a" { float x = 1; # comment\n }\n',
        'def "a" { float[] x = [\n 1, # comment\n 2\n ]\n float2 y = (1,\n 2)\n }\n',
        'def "a" {\n variantSet "v" =\n {\n "w"\n {\n }\n }\n}\n',
    ],
)
def test_lines_are_broken_where_openusd_lets_them_be(content):
    assert not values(read(content), "unread")


@pytest.mark.parametrize("head", ["", "#sdf 1.4.32\n", "#usda 9.0\n", "\n#usda 1.0\n"])
def test_a_layer_begins_with_its_version(head):
    assert values(read('def "a" {}', head), "unread")


@pytest.mark.parametrize(
    "content",
    [
        'def "a" {' * 10_000,
        f'def "a" {{ float x = {"(" * 10_000}',
        f'def "{"a" * 10_000}" {{}}',
        "\n".join(f'def "{"a" * 1_000}" {{' for _ in range(100)) + "}\n" * 100,
    ],
    ids=["deep", "deep value", "long name", "long address"],
)
def test_bombs_are_refused_where_they_stand(content):
    with pytest.raises(SourceError) as refused:
        read(content)

    assert refused.value.line is not None


def test_bulk_data_is_not_stated():
    points = ", ".join(f"({n}, 0, 0)" for n in range(100))
    layer = read(f'def Mesh "m" {{ point3f[] points = [{points}]; }}', HEAD)

    assert len(layer.statements) < 30


def test_comments_silence_what_begins_on_their_line_or_the_next():
    """In strings they say nothing."""
    layer = read(
        """
# kinlint: ignore[LIM001] known
def "a"
{
    float x = 1  # kinlint: ignore[SRC007]
    string s = "# kinlint: ignore[SRC005]"
}
"""
    )

    assert [code for _, code, _ in said(layer, "rule")] == ["LIM001", "SRC007"]


def test_a_comment_is_never_written_before_the_first_line():
    source = read('def "a" {}').source
    edit = comment_edit(source, Span(0, 1), ["CMP001"], "known")
    text = source.text[: edit.span.start] + edit.text + source.text[edit.span.end :]

    assert text.splitlines()[:2] == ["#usda 1.0", "# kinlint: file-ignore[CMP001] known"]
