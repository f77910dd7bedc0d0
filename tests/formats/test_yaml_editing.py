"""YAML keeps its quotes when names change, and its comments silence rules."""

import pytest
from support.linting import codes, document

from kinlint.edits import Delta, NotExpressible, applied
from kinlint.formats.line_comments import comment_edit
from kinlint.formats.options import ReadOptions
from kinlint.formats.yaml.editor import Editor
from kinlint.terms import literal
from kinlint.text import SourceText, Span

LIMITS = "joint_limits:\n  lift: {min_position: 1, max_position: -1}\n"


def renamed(text, new):
    """*text* with another name for its only joint."""
    read = document(text, "arm.yaml")
    (old,) = (each for each in read.statements if each[2] == '"elbo"')
    delta = Delta((old,), ((*old[:2], literal(new)),))
    return applied(text, Editor(read, ReadOptions()).edits(delta))


@pytest.mark.parametrize(
    ("text", "new", "after"),
    [
        ("joints: [elbo]", "elbow", "joints: [elbow]"),
        ("joints: ['elbo']", "el'bow", "joints: ['el''bow']"),
        ('joints: ["elbo"]', 'el"bow', 'joints: ["el\\"bow"]'),
        ("joints: [elbo]", "no", 'joints: ["no"]'),
        ("joints: [elbo]", "1: 2", 'joints: ["1: 2"]'),
        ("a: {projection_evaluator: joints(elbo)}", "elbow",
         "a: {projection_evaluator: joints(elbow)}"),
    ],
)  # fmt: skip
def test_a_name_is_written_as_the_one_before(text, new, after):
    assert renamed(text, new) == after


def test_only_values_change():
    read = document("joints: [elbo]", "arm.yaml")
    with pytest.raises(NotExpressible):
        Editor(read, ReadOptions()).edits(Delta(added=read.statements[:1]))


@pytest.mark.parametrize(
    ("text", "silent"),
    [
        (LIMITS.replace("}", "} # kinlint: ignore[CMP009] set at run time"), True),
        (LIMITS.replace("  lift", "  # kinlint: ignore[CMP009]\n  lift"), True),
        (f"# kinlint: ignore[CMP009]\n\n# more\n{LIMITS}", True),
        (f"a: 1\n\n# kinlint: file-ignore[CMP009]\n{LIMITS}", True),
        (f"# kinlint: ignore[CMP009]\na: 1\n{LIMITS}", False),
        (f"a: '# kinlint: file-ignore[CMP009]'\n{LIMITS}", False),
        (f"a: |\n  # kinlint: file-ignore[CMP009]\n{LIMITS}", False),
        (f"{LIMITS}  # kinlint: ignore[CMP009]\n  other: {{}}\n", False),
    ],
    ids=["behind", "above", "around", "file", "another", "quoted", "block", "after"],
)
def test_a_comment_silences_what_it_is_about(text, silent):
    found = codes(text, "arm.yaml")
    assert ("CMP009" not in found) is silent


def test_a_comment_joins_one_with_the_same_reason():
    text = "a:\r\n  # kinlint: ignore[CMP001] known\r\n  joints: [x]\r\n"
    source = SourceText("arm.yaml", text)
    place = Span(text.index("[x]"), text.index("[x]") + 1)
    same = applied(text, [comment_edit(source, place, ["CMP009"], "known")])
    assert same == text.replace("CMP001", "CMP001, CMP009")
    other = applied(text, [comment_edit(source, place, ["CMP009"], None)])
    assert other == text.replace("  joints", "  # kinlint: ignore[CMP009]\r\n  joints")
