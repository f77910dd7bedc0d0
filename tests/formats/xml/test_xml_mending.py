"""Texts that are not well-formed, and are read all the same."""

from __future__ import annotations

import pytest
from data import locate_data
from reading_xml import flaws, graph, model, remarks

from kinlint.errors import SourceError


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("<r name='a'><!-- a -- b --- c ----><l/></r>", [("--", "-- inside a comment")]),
        ("<r name='a'><!-- a ---></r>", [("-", "-- inside a comment")]),
        (
            "<?xml version='0.0'?><r name='a'/>",
            [("<?xml version='0.0'?>", "an unknown XML version")],
        ),
        (
            "<?xml verison='1.0'?><r name='a'/>",
            [("<?xml verison='1.0'?>", "a malformed XML declaration")],
        ),
        (
            "\n<?xml version='1.0'?>\n<r name='a'/>",
            [("<?xml version='1.0'?>", "an XML declaration that is not at the very beginning")],
        ),
        (
            "<!-- x --><?xml version='1.0'?>\n<r name='a'/>",
            [("<?xml version='1.0'?>", "an XML declaration after other content")],
        ),
        (
            "<?xml version='1.0'?>\n<?xml version='1.0'?><r name='a'/>",
            [("<?xml version='1.0'?>", "an XML declaration that is not at the very beginning")],
        ),
        ("?xml version='1.0'?>\n<r name='a'/>", [("?", "no < before the declaration")]),
        ("xml version='1.0'?>\n<r name='a'/>", [("x", "no < before the declaration")]),
        ("robot name='a'><l/></r>", [("r", "no < before robot")]),
        ("!-- b -->\n<r name='a'/>", [("!", "text before the first tag")]),
        ("x<r name='a'/>", [("x", "text before the first tag")]),
        ("\ufeff\ufeff\ufeff<r name='a'/>", [("\ufeff\ufeff", "a second byte order mark")]),
        (
            "\ufeff\ufeff<?xml version='1.0'?>\n<r name='a'/>",
            [("\ufeff", "a second byte order mark before the XML declaration")],
        ),
        (
            "\nrobot name='a'><!-- b -- c --><l/></r>",
            [("r", "no < before robot"), ("--", "-- inside a comment")],
        ),
        ("<r name='a'><g:l/><g::l/></r>", [("g::l", "two colons in g::l")]),
        ("<r name='a' g::b='1'/>", [("g::b", "two colons in g::b")]),
        ("<r name='a'/>\n\0\n", [("\0", "the character U+0000")]),
        ("<r name='a'>\x01\x02</r>", [("\x01\x02", "the character U+0001")]),
        ("<r name='a'/>\n</r>\nrest", [("</r>", "content after the end of <r>")]),
        ("<r name='a'/><r name='b'/>", [("<r name='b'/>", "content after the end of <r>")]),
        ("<r name='a'>a & b</r>", [("&", "unescaped &")]),
        ("<r name='a'>&nbsp;</r>", [("&nbsp;", "the undefined entity &nbsp;")]),
        ("<r name='a'>&#0;</r>", [("&#0;", "unescaped &")]),
        ("<r name='a'>&#x110000;</r>", [("&#x110000;", "unescaped &")]),
        ("<r name='a'>]]></r>", [(">", "]]> outside of a CDATA section")]),
        (
            "<r name='a' x='<&>'/>",
            [("<", "unescaped <"), ("&", "unescaped &")],
        ),
        ("<r name='a'x='1'y='é'/>", [("x", "no space before x"), ("y", "no space before y")]),
    ],
)  # fmt: skip
def test_flaws_are_told_and_read_past(text: str, expected: list[tuple[str, str]]) -> None:
    whole = {"<r ": "<robot ", "</r>": "</robot>", "<r>": "<robot>", "<l/>": "<link/>"}
    for short, long in whole.items():
        text = text.replace(short, long)
        expected = [
            (place.replace(short, long), why.replace(short, long)) for place, why in expected
        ]
    arm = model(text)
    assert flaws(arm) == expected
    assert ("#", "@name", "a") in graph(arm)


def test_no_offset_moves() -> None:
    arm = model(
        "<?xml version='0.0'?><!-- é -- \N{ROBOT FACE} -- -->\n"
        "<robot name='\N{ROBOT FACE}'version='1'><!-- -- -->\0<link name='é & ü'/>"
        "<link name='ö'x='a'>]]>q</link></robot>"
    )
    said = {
        o: arm.source[arm.map.triples[s, p, o]] for s, p, o in arm.statements if "attribute#" in p
    }
    assert said == {
        '"\N{ROBOT FACE}"': "\N{ROBOT FACE}",
        '"1"': "1",
        '"é & ü"': "é & ü",
        '"ö"': "ö",
        '"a"': "a",
    }
    shown = [
        arm.source[arm.map.nodes[s].whole]
        for s, p, _ in arm.statements
        if p.endswith("attribute#name>")
    ]
    assert shown[-2:] == ["<link name='é & ü'/>", "<link name='ö'x='a'>]]>q</link>"]


def test_of_an_attribute_given_twice_the_first_counts() -> None:
    arm = model("<robot name='a' version='1' name='b'/>")
    assert ("#", "@name", "a") in graph(arm)
    assert remarks(arm) == [("RepeatedAttribute", "name", {"attribute": "name", "tag": "robot"})]


@pytest.mark.parametrize(
    ("text", "place", "reason"),
    [
        ("", "", "the file is empty"),
        ("  \n", " ", "the file is empty"),
        ("<!-- nothing -->", "<", "the file has no element"),
        ("<robot><link name='b'></robot>", "</robot>", "</robot> closes <link>"),
        ("<robot name='a'>\n<link name='b'/>", "robot", "<robot> is never closed"),
        ("<robot name='a'><!-- ", "<", "this tag, comment or section is never closed"),
        ("<robot name='a'><link name=b/></robot>", "b", "not well-formed (invalid token)"),
        ("<robot name='a'>1 < 2</robot>", " ", "not well-formed (invalid token)"),
        ("robot", "r", "syntax error"),
    ],
)  # fmt: skip
def test_what_nobody_reads_is_one_remark_and_no_graph(text: str, place: str, reason: str) -> None:
    arm = model(text)
    assert remarks(arm) == [("MalformedText", place, {"reason": reason, "unread": "true"})]
    assert graph(arm) == []


@pytest.mark.parametrize(
    "inside",
    [
        "<!DOCTYPE robot [<!ENTITY a 'b'>]>",
        "<!DOCTYPE robot SYSTEM 'robot.dtd'>",
        "<!DOCTYPE robot PUBLIC 'a' 'file:///etc/passwd'>",
        "<!DOCTYPE robot [<!ATTLIST robot name CDATA 'x'>]>",
        "<!DOCTYPE robot [<!ENTITY % a SYSTEM 'file:///etc/passwd'> %a;]>",
    ],
)
def test_definitions_are_refused_where_they_stand(inside: str) -> None:
    with pytest.raises(SourceError, match="document type definition") as caught:
        model(f"<?xml version='1.0'?>\n {inside}<robot name='a'/>")
    assert (caught.value.line, caught.value.column) == (2, 2)


def test_a_document_type_without_a_definition_is_read() -> None:
    assert ("#", "@name", "a") in graph(model("<!DOCTYPE robot><robot name='a'/>"))


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["urdf", "sdf"])
def test_real_files_are_read_unless_a_tag_is_not_closed(kind: str) -> None:
    unread = []
    for path in sorted(locate_data("robots", kind).rglob(f"*.{kind}")):
        found = remarks(model(path.read_bytes(), str(path)), "MalformedText")
        unread += [path.name for _, _, said in found if "unread" in said]
    assert unread == {"urdf": ["error_xml_syntax.urdf"], "sdf": ["invalid_xml_syntax.sdf"]}[kind]
