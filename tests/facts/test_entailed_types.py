"""Types that hold only because something else does."""

from __future__ import annotations

from computed import computed, store_of

from kinlint.facts.computation import facts
from kinlint.terms import RDF_TYPE


def test_a_type_that_only_follows_is_told() -> None:
    """The one that is stated, or for which nobody asks, is not."""
    found = computed(
        {"@id": "ex:implied", "@type": "RevoluteJoint"},
        {"@id": "ex:stated", "@type": ["Joint", "RevoluteJoint"]},
    )
    told = found.values("ex:implied", "entailed-type")

    assert [each.rpartition("#")[2] for each in told] == ["Joint"]
    assert not found.values("ex:stated", "entailed-type")


def test_only_inferred_types_are_told() -> None:
    """Each of them is one."""
    store = store_of({"@id": "ex:implied", "@type": "RevoluteJoint"})
    entailed = [(s, RDF_TYPE, o) for s, p, o in facts(store) if p.endswith("entailed-type>")]

    assert entailed
    assert all(store.is_inferred(each) for each in entailed)
