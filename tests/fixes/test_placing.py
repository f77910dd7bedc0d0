"""Where a change goes that several files say."""

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
