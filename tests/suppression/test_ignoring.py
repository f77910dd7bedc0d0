"""What is written to silence one finding, as an editor asks for it."""

import pytest

from kinlint.catalogue import rulebook
from kinlint.configuration.settings import Settings
from kinlint.edits import Edit, NotExpressible, applied
from kinlint.fixes.texts import Texts
from kinlint.ignoring.suppression_generator import SuppressionGenerator
from kinlint.lint import examine
from kinlint.suppression.interval_index import IntervalIndex
from kinlint.text import SourceText, Span

ARM = """<robot name="arm">
  <link name="base"/>
  <link name="hand"/>
  <joint name="elbow" type="revolute">
    <parent link="base"/><child link="hand"/><axis xyz="0 0 2"/>
    <limit lower="2" upper="1" effort="10" velocity="1"/>
  </joint>
  <!-- kinlint: ignore[INE001] -->
  <link name="third"/>
</robot>
"""


@pytest.fixture
def silenced(rules_cache):
    """The text after the findings of a rule are silenced, each for itself."""

    def silence(text, code, reason=None, name="arm.urdf"):
        sources = [SourceText(name, text)]
        book = rulebook.load(cache=rules_cache)
        found = examine(sources, [], Settings(), book)
        generator = SuppressionGenerator(found, Texts(sources), Settings(), book, reason=reason)
        findings = [one for one in found.report.findings if one.rule.code == code]
        assert findings
        edits = [edit for one in findings for edit in generator.suppression([one]).text_edits]
        assert all(edit.location.source.name == name for edit in edits)
        return applied(text, [Edit(edit.location.span, edit.text) for edit in edits])

    return silence


def test_one_finding(silenced):
    """By an edit of its own, whatever else there is."""
    comment = "    <!-- kinlint: ignore[LIM001] known -->\n"
    assert silenced(ARM, "LIM001", "known") == ARM.replace("    <limit", f"{comment}    <limit")
    behind = '<axis xyz="0 0 2"/><!-- kinlint: ignore[FRM009] -->'
    assert silenced(ARM, "FRM009") == ARM.replace('<axis xyz="0 0 2"/>', behind)


def test_a_suppression_at_fault_is_not_silenced(silenced):
    """It has to be corrected."""
    with pytest.raises(NotExpressible, match="has to be corrected"):
        silenced(ARM, "LNT001")


def test_nested_spans():
    """The innermost first; what lies elsewhere is none of them."""
    spans = [Span(0, 20), Span(2, 8), Span(3, 5), Span(3, 4), Span(10, 12), Span(0, 20)]
    nest = IntervalIndex.from_spans((span, (number, span)) for number, span in enumerate(spans))
    assert [span for _, span in nest.containing(Span(3, 4))] == [
        (3, 4), (3, 5), (2, 8), (0, 20), (0, 20),
    ]  # fmt: skip
    assert [number for number, _ in nest.containing(Span(4, 6))] == [1, 5, 0]
    assert list(IntervalIndex.from_spans([(Span(2, 3), 1)]).containing(Span(0, 1))) == []
