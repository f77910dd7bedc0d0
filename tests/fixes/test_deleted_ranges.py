"""Ranges that are within others count once."""

from __future__ import annotations

from itertools import pairwise

from hypothesis import given
from hypothesis import strategies as st

from kinlint.formats.jsonld.editing.container_changes import DeletedRanges
from kinlint.text import Span

# A tree of brackets: any two of its ranges are apart or nested.
TREES = st.recursive(st.just([]), lambda inner: st.lists(inner, max_size=4), max_leaves=20)


def ranges(tree: list, start: int = 0) -> list[Span]:
    found, at = [], start + 1
    for branch in tree:
        inner = ranges(branch, at)
        found += inner
        at = inner[-1].end + 1
    return [*found, Span(start, at + 1)]


@given(TREES.map(ranges), st.data())
def test_a_range_is_cut_if_one_that_holds_it_is(spans: list[Span], data: st.DataObject) -> None:
    cut = data.draw(st.lists(st.sampled_from(spans)))
    cuts = DeletedRanges()
    for span in cut:
        cuts.add(span)
    for span in spans:
        held = any(each.start <= span.start and span.end <= each.end for each in cut)
        assert (span in cuts) == held
    widest = list(cuts)
    assert widest == sorted(widest)
    assert set(widest) <= set(cut)
    assert all(one.end <= other.start for one, other in pairwise(widest))
