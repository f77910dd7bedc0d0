"""Random models and random deltas: what is written is what was to be said."""

from __future__ import annotations

import json
import random
import re
from collections import Counter
from typing import Any

import pytest
from editing_json_ld import OPTIONS, canonical, changed, check_edits, document, domain
from hypothesis import event, given, settings
from hypothesis import strategies as st
from random_triples import EX, XSD, Changer, G

from kinlint.edits import NotExpressible, applied
from kinlint.formats.jsonld.editing.editor import Editor
from kinlint.terms import RDF_TYPE

CONTEXTS = [
    f"{G}structural-entities.json",
    f"{G}coordinates.json",
    f"{G}spatial-relations.json",
    "https://comp-rob2b.github.io/metamodels/qudt.json",
]
OWN = {
    "ex": EX,
    "xsd": XSD,
    "note": "ex:note",
    "count": {"@id": "ex:count", "@type": "xsd:integer"},
    "order": {"@id": "ex:order", "@container": "@list"},
    "knows": {"@id": "ex:knows", "@type": "@id"},
    "path": {"@id": "ex:path", "@type": "@id", "@container": "@list"},
    "part": {"@reverse": "ex:part-of", "@type": "@id"},
    "id": "@id",
}
NAMES = st.sampled_from([f"ex:n{number}" for number in range(8)])
NUMBERS = st.sampled_from([0.0, 1.0, -1.5, 0.1, 1e-06, 2.5e10, 3, 0])
WORDS = st.sampled_from(["a", "b", 'quo"te', "ümlaut", "line\nbreak", ""])
VALUES = NUMBERS | WORDS | st.booleans()


def one_or_more(values: st.SearchStrategy[Any]) -> st.SearchStrategy[Any]:
    return values | st.lists(values, max_size=3)


def nodes(inner: st.SearchStrategy[Any]) -> st.SearchStrategy[dict[str, Any]]:
    types = ["VectorXYZ", "PositionReference", "PoseCoordinate", "Frame", "ex:T", "Euclidean"]
    return st.fixed_dictionaries(
        {},
        optional={
            "@id": NAMES,
            "@type": one_or_more(st.sampled_from(types)),
            "x": NUMBERS,
            "y": NUMBERS,
            "of-position": NAMES,
            "as-seen-by": one_or_more(NAMES),
            "unit": one_or_more(st.sampled_from(["M", "RAD"])),
            "note": one_or_more(VALUES),
            "ex:raw": one_or_more(VALUES | st.fixed_dictionaries({"@id": NAMES})),
            "count": st.integers(-3, 3),
            "order": st.lists(VALUES, max_size=4),
            "path": st.lists(NAMES, max_size=3),
            "knows": one_or_more(NAMES | inner),
            "part": NAMES,
            "_remark": WORDS,
        },
    ).map(dict)


NODES = nodes(st.recursive(st.fixed_dictionaries({"note": WORDS}), nodes, max_leaves=3))


@st.composite
def texts(draw: st.DrawFn) -> str:
    graph = draw(st.lists(NODES, min_size=1, max_size=4))
    content: dict[str, Any] = {"@context": [*CONTEXTS, OWN]}
    if draw(st.booleans()):
        content["@graph"] = graph
    else:
        content |= graph[0]
    manner = draw(st.sampled_from(["2", "4", "tab", "minified", "line", "lines"]))
    return laid_out(content, manner, draw(st.sampled_from(["\n", "\r\n"])), draw(st.booleans()))


def laid_out(content: dict[str, Any], manner: str, newline: str, last: bool) -> str:  # noqa: FBT001
    indents = {"2": 2, "4": 4, "tab": "\t"}
    if manner == "minified":
        text = json.dumps(content, separators=(",", ":"), ensure_ascii=False)
    elif manner == "line":
        text = json.dumps(content)
    elif manner == "lines" and "@graph" in content:
        context = json.dumps(content["@context"])
        lines = ",\n".join(f"    {json.dumps(node)}" for node in content["@graph"])
        text = f'{{\n  "@context": {context},\n  "@graph": [\n{lines}\n  ]\n}}'
    else:
        text = json.dumps(content, indent=indents.get(manner, 2), ensure_ascii=False)
    return (text + ("\n" if last else "")).replace("\n", newline)


SCOPED = {f"<{G}coordinates#{key}>" for key in ("x", "y", "of-position", "as-seen-by")} | {
    "<http://qudt.org/schema/qudt/unit>"
}
"""The properties of keys that only nodes of some types have."""
BLANK = re.compile(r"_:\w+")


@pytest.mark.slow
@settings(max_examples=300)
@given(texts(), st.integers(0, 2**32).map(random.Random))
def test_what_is_written_is_what_was_to_be_said(text: str, chance: random.Random) -> None:
    before = document(text)
    delta = Changer(domain(before), chance).delta()
    try:
        edits = Editor(before, OPTIONS).edits(delta)
    except NotExpressible as why:
        event(f"unsayable: {why}")
        return
    event("said")
    check_edits(text, edits)
    after = applied(text, edits)
    expected = canonical(changed(domain(before), delta))
    written = canonical(domain(document(after)))
    if written != expected:
        event("types give a meaning to keys that had none")
        assert any(prop == RDF_TYPE for _, prop, _ in delta.added), (delta, after)
        wanted, found = (
            Counter(BLANK.sub("_:b", text).splitlines()) for text in (expected, written)
        )
        assert wanted <= found, (delta, after)
        assert {line.split()[1] for line in found - wanted} <= SCOPED, (delta, after)
