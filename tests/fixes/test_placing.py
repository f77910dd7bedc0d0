"""Where a change goes that several files say."""

import pytest
from support.linting import book

from kinlint.configuration.settings import Settings
from kinlint.fixes.rounds import fix_in_rounds
from kinlint.rule import Applicability
from kinlint.text import SourceText

MASS = """{
  "@context": ["https://w3id.org/kinlint/composable.json", {"ex": "https://example.org/arm#"}],
  "@id": "ex:elbow-mass", "@type": "Quantity", "quantity-kind": "Mass", "unit": "M"
}
"""


def test_what_two_files_say_is_replaced_in_both():
    """Neither loses the value without getting the new one."""
    texts = [SourceText(name, MASS) for name in ("a.jsonld", "b.jsonld")]
    made = fix_in_rounds(texts, (), Settings(), book(), Applicability.UNSAFE).texts

    assert [each.text for each in made] == [MASS.replace('"unit": "M"', '"unit": "KiloGM"')] * 2


NEGATIVE_URDF = """<robot name="arm"><link name="base"><inertial>
  <mass value="-2.50"/>
  <inertia ixx="0.010" iyy="1e-2" izz="0.01" ixy="0" ixz="0" iyz="0"/>
</inertial></link></robot>
"""
NEGATIVE_JSON_LD = """{
  "@context": ["https://w3id.org/kinlint/composable.json", {"ex": "https://example.org/arm#"}],
  "@id": "ex:hand-mass", "@type": ["MassReference", "MassScalar"],
  "unit": "KiloGM", "mass": -2.50
}
"""


@pytest.mark.parametrize(
    ("name", "text"), [("arm.urdf", NEGATIVE_URDF), ("arm.jsonld", NEGATIVE_JSON_LD)]
)
def test_a_number_that_changes_its_sign_keeps_its_spelling(name, text):
    made = fix_in_rounds((SourceText(name, text),), (), Settings(), book(), Applicability.UNSAFE)

    assert [each.text for each in made.texts] == [text.replace("-2.50", "2.50")]
