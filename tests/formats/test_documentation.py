"""What elements and attributes mean: all of them have a few words, and none is unknown."""

import pytest

from kinlint.formats.records import LIFTED
from kinlint.formats.xml.documentation import documentation
from kinlint.formats.xml.schema import schema

FORMATS = [each.name for each in LIFTED if each.fence == "xml"]


@pytest.mark.parametrize("form", FORMATS)
def test_every_element_has_a_meaning(form):
    known = documentation(form)
    assert [tag for tag in schema(form).types if not known.element(tag)] == []
    assert set(known.elements) <= set(schema(form).types)


@pytest.mark.parametrize("form", FORMATS)
def test_every_attribute_has_a_meaning(form):
    known = documentation(form)
    attributes = {
        (tag, name)
        for tag, types in schema(form).types.items()
        for each in types
        for name in each.attributes
    }
    assert [each for each in sorted(attributes) if not known.attribute(*each)] == []
    assert {each for each in known.attributes if each[0]} <= attributes
