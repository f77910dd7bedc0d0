"""The walk in linter/README.md: the functions from a limit in a text to its fix."""

from __future__ import annotations

import re
import sys
from importlib import import_module
from operator import attrgetter
from types import CodeType, FrameType
from typing import Any

from fenced import ROOT
from support.linting import book

from kinlint.configuration.settings import Settings
from kinlint.fixes.rounds import fix_in_rounds
from kinlint.formats.registry import decode
from kinlint.rule import Applicability

README = ROOT / "linter" / "README.md"
MOST = 30
ROW = re.compile(r"^\| (?:\w+ )?\| `([\w.]+)` \| .+ \|$", re.MULTILINE)
ROBOT = """<robot name="arm">
  <link name="base"/>
  <link name="hand"/>
  <joint name="elbow" type="revolute">
    <parent link="base"/>
    <child link="hand"/>
    <axis xyz="0 0 1"/>
    <limit {} effort="1" velocity="1"/>
  </joint>
</robot>
"""


def walk() -> list[str]:
    """Return the functions of the table."""
    text = README.read_text("utf-8")
    return ROW.findall(text.partition("## One finding from text to fix")[2].partition("\n## ")[0])


def code(name: str) -> CodeType:
    """Return the code of the function of kinlint called *name*, that of a class by its class."""
    parts = name.split(".")
    at = next((n for n, part in enumerate(parts) if part[0].isupper()), len(parts) - 1)
    module = import_module(".".join(("kinlint", *parts[:at])))
    found = attrgetter(".".join(parts[at:]))(module)
    return getattr(found, "__wrapped__", found).__code__


def test_the_walk_is_short_and_names_each_function_once() -> None:
    names = walk()

    assert 0 < len(names) <= MOST
    assert len(set(names)) == len(names)


def test_all_functions_of_the_walk_are_called_from_text_to_fix() -> None:
    """None is named that the limit does not come by."""
    rules = book()
    wanted = {code(name): name for name in walk()}
    called: dict[CodeType, None] = {}

    def note(frame: FrameType, event: str, _argument: Any) -> None:
        if event == "call" and frame.f_code in wanted:
            called.setdefault(frame.f_code)

    # Numbers that no other test reads, since their values are remembered.
    before = ROBOT.format('lower="2.7182" upper="1.4142"')
    sys.setprofile(note)
    try:
        source = decode("arm.urdf", before.encode())
        fixed = fix_in_rounds([source], (), Settings(), rules, Applicability.UNSAFE)
    finally:
        sys.setprofile(None)

    assert [each.text for each in fixed.texts] == [ROBOT.format('lower="1.4142" upper="2.7182"')]
    assert [name for function, name in wanted.items() if function not in called] == []
