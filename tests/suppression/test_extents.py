"""A suppression in a comment covers all findings within its element, and is unused without any."""

from dataclasses import replace

import pytest
from support.linting import document
from suppressing import DROPPED, UNIT, applied, finding, told

from kinlint.text import SourceText, Span

ARM = """\
<robot name='r'>
  <!-- kinlint: ignore[UNI001] outer -->
  <link name='a'>
    <inertial> <!-- kinlint: ignore[LD001] inner -->
      <mass value='1'/>
    </inertial>
    <visual/>
  </link>
  <link name='b'/> <!-- kinlint: ignore[UNI001] same line -->
  <link name='c'/>
</robot>
"""


def arm(text=ARM):
    return document(text, form="urdf")


def at(rule, words, text=ARM):
    start = text.index(words)
    return finding(rule, name="arm.urdf", text=text, span=Span(start, start + len(words)))


@pytest.mark.parametrize(
    ("rule", "words", "silenced"),
    [
        (UNIT, "<link name='a'>", True),
        (UNIT, "mass", True),
        (UNIT, "visual", True),
        (DROPPED, "inertial", True),
        (DROPPED, "mass", True),
        (DROPPED, "visual", False),
        (UNIT, "<link name='b'/>", True),
        (UNIT, "'c'", False),
        (UNIT, "robot", False),
        (UNIT, ARM, False),
    ],
)
def test_a_comment_covers_what_is_found_within_its_element(rule, words, silenced):
    document = arm()
    found = applied([at(rule, words)], [document], complete=False)
    assert told(found) == [("-" if silenced else "") + rule.code]


def test_the_excuse_is_the_reason_of_the_innermost_comment():
    text = ARM.replace("LD001", "UNI001")
    (found,) = applied([at(UNIT, "mass", text)], [arm(text)], complete=False)
    assert found.suppressed == "inner"


def test_what_covers_nothing_is_unused():
    found = applied([at(UNIT, "mass")], [arm()])
    assert told(found) == ["-UNI001", "LNT001", "LNT001"]
    places = [one.location.source.position(one.location.span.start).line for one in found[1:]]
    assert places == [4, 9]


def test_a_comment_for_the_file_covers_all_of_it_and_no_other():
    text = ARM.replace("ignore[UNI001] outer", "file-ignore[UNI001] all")
    one = at(UNIT, "'c'", text)
    other = replace(one, location=replace(one.location, source=SourceText("leg.urdf", text)))
    assert told(applied([one, other], [arm(text)], complete=False)) == ["-UNI001", "UNI001"]


@pytest.mark.slow
def test_many_comments_take_no_time():
    links = "".join(f"<link name='a{k}'/> <!-- kinlint: ignore[UNI001] -->\n" for k in range(5_000))
    text = f"<robot name='r'>{links}</robot>"
    document = arm(text)
    spans = [document.map.nodes[f"{document.graph[:-1]}#/link/a{k}>"].best for k in range(5_000)]
    found = [finding(UNIT, name="arm.urdf", text=text, span=span) for span in spans]
    outcome = applied(found, [document])
    assert all(one.suppressed is not None for one in outcome)
