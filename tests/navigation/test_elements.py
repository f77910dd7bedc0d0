"""What is named at a place of a large JSON-LD file is found in the element there alone."""

import json

import pytest
from support.linting import book

from kinlint.configuration.settings import Settings
from kinlint.navigation.index import Index
from kinlint.navigation.node_at_offset import Surroundings
from kinlint.pipeline.analyzer import Analyzer
from kinlint.text import SourceText

NAME = "chain.jsonld"
GEOMETRY = "https://comp-rob2b.github.io/metamodels/geometry/structural-entities.json"
PREFIXES = {"rob": "https://robots.example/arm#", "ex": "https://words.example/"}
ELEMENTS = [
    {"@id": "rob:base", "@type": "Point", "ex:note": "first", "ex:near": {"@id": "rob:tip"}},
    {"@id": "rob:tip", "@type": ["Point", "3D"], "ex:list": {"@list": [1, 2, "three"]}},
    {"@id": "rob:base", "ex:height": 2.5, "ex:sees": [{"@id": "rob:tip", "ex:size": 3}]},
    {"@id": "rob:tip"},
    {"@id": "rob:frame", "ex:of": {"ex:unnamed": True, "ex:point": {"@id": "rob:nowhere"}}},
    {"@type": "Point", "ex:reach": {"@value": "1.5", "@type": "ex:length"}},
]


def edited(context, elements):
    """The documents of a model in which somebody has typed a space."""
    model = {"@context": context, "@id": "rob:arm", "@graph": elements}
    text = json.dumps(model, indent=1)
    analyzer = Analyzer(Settings(), book(), repeated=True)
    middle = text.index("\n", text.index("@graph") + 40)
    texts = text, f"{text[:middle]} {text[middle:]}", text
    examinations = [analyzer.examine([SourceText(NAME, each)]) for each in texts]
    return text, examinations[-1].documents


def complete(documents):
    """An index that has looked at all elements."""
    index = Index(documents)
    index.mentions([""])
    index.excerpt_at = lambda *_: None
    return index


@pytest.mark.slow
def test_an_element_tells_what_the_whole_file_tells():
    text, documents = edited([PREFIXES, GEOMETRY], ELEMENTS)
    every = complete(documents)
    all_around = Surroundings(documents, every)

    inside = 0
    for offset in range(len(text)):
        index = Index(documents)
        inside += index.excerpt_at(NAME, offset) is not None
        named = index.at(NAME, offset)
        assert named == every.at(NAME, offset), text[offset - 20 : offset + 5]
        entities = [each.entity for each in named]
        assert index.descriptions(entities) == every.descriptions(entities), entities
        around = Surroundings(documents, index).at(NAME, offset)
        assert around == all_around.at(NAME, offset)
    assert inside > len(text) / 2


@pytest.mark.slow
def test_what_is_described_in_several_elements_is_found_in_all():
    text, documents = edited([PREFIXES, GEOMETRY], ELEMENTS)
    index = Index(documents)
    (entity,) = {each.entity for each in index.at(NAME, text.index("rob:base"))}

    found = index.descriptions([entity])

    places = [each.location.span.start for each in found]
    assert [text[at : at + 10] for at in places] == ['"rob:base"', '"rob:base"']
    assert places == sorted(places)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("context", "element"),
    [
        ([PREFIXES, {"note": "ex:note"}], {"@id": "rob:x", "note": 1}),
        (PREFIXES, {"@context": {"note": "ex:note"}, "@id": "rob:x", "note": 1}),
    ],
    ids=["a term of the outermost context", "a context of the element"],
)
def test_terms_of_a_context_in_the_file_take_all_of_it(context, element):
    text, documents = edited(context, [*ELEMENTS, element])
    index = Index(documents)

    assert index.excerpt_at(NAME, text.index("rob:tip")) is None
    keys = index.at(NAME, text.rindex('"note"') + 2)
    assert [each.location.source.name for each in index.descriptions([keys[0].entity])] == [NAME]
