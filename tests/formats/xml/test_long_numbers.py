"""Numbers of any length are read in time that is linear in it.

Quadratic time would take hours for the digits here.
"""

import pytest
from support.linting import codes

from kinlint.findings.wording import NUMERIC
from kinlint.formats.doubles import exceeds_doubles
from kinlint.formats.xml.value_reading import NUMBER, IntegerReader

DIGITS = "1" * 200_000


@pytest.mark.parametrize("pattern", [NUMBER, NUMERIC], ids=["read", "told"])
@pytest.mark.parametrize("text", ["{}x", "{0}.{0}x", ".{}x", "{0}e{0}x", "-{0}{0}-"])
def test_no_number_makes_a_pattern_go_back(pattern, text):
    assert pattern.fullmatch(text.format(DIGITS)) is None
    assert pattern.fullmatch(f"{DIGITS}.") is not None


def test_a_long_word_is_no_large_double():
    assert not exceeds_doubles(f"{DIGITS}x")


def test_a_robot_with_one_is_linted():
    robot = '<robot name="r"><link name="a"><visual><origin xyz="{}x 0 0"/></visual></link></robot>'
    assert codes(robot.format(DIGITS[:50_000]))


def test_hexadecimal_numbers_are_bounded():
    assert IntegerReader().read("0xff") == IntegerReader().read("255")
    assert IntegerReader().read("0x" + "F" * 5_000) is None
