"""Dataclasses that cost little behave as those of the standard library."""

from __future__ import annotations

import dataclasses
import pickle
import subprocess
import sys
from types import ModuleType
from typing import Any, ClassVar

import pytest

from kinlint import light_dataclasses


def _point(module: ModuleType, **flags: bool) -> Any:
    @module.dataclass(**flags)
    class Point:
        """A point with fields of all kinds."""

        kind: ClassVar[str] = "point"
        x: int
        y: int = 2
        marks: list[int] = module.field(default_factory=list, compare=False, repr=False)
        name: str = module.field(kw_only=True, default="origin")
        sum: int = module.field(init=False, default=0, compare=False)

        def __post_init__(self) -> None:
            object.__setattr__(self, "sum", self.x + self.y)

    return Point


FLAGS = [{}, {"frozen": True}, {"slots": True}, {"frozen": True, "slots": True}, {"eq": False}]


@pytest.mark.parametrize("flags", FLAGS, ids=str)
def test_classes_are_as_those_of_the_standard_library(flags: dict[str, bool]) -> None:
    light, standard = (_point(module, **flags) for module in (light_dataclasses, dataclasses))
    assert light.__match_args__ == standard.__match_args__
    assert getattr(light, "__slots__", None) == getattr(standard, "__slots__", None)
    assert (light.__hash__ is None) == (standard.__hash__ is None)
    assert light.__qualname__ == standard.__qualname__
    assert light.__doc__ == standard.__doc__
    for made in (light, standard):
        one, same, other = made(1, marks=[3]), made(1, 2, [4]), made(x=1, y=3, name="tip")
        assert (one == same) is flags.get("eq", True)
        assert one != other
        assert one != 1
        assert made(1).marks is not made(1).marks
        assert other.sum == 4
        if flags.get("frozen"):
            assert hash(one) == hash(same) == hash((1, 2, "origin"))
        with pytest.raises(TypeError):
            made()
        with pytest.raises(TypeError):
            made(1, 2, [], "positional")
    assert repr(light(1)) == repr(standard(1))


def test_operations_are_as_those_of_the_standard_library() -> None:
    one = _point(light_dataclasses, frozen=True, slots=True)(1, name="tip")
    for module in (light_dataclasses, dataclasses):
        assert [each.name for each in module.fields(one)] == ["x", "y", "marks", "name", "sum"]
        assert module.replace(one, y=5).sum == 6
        assert module.asdict(one) == {"x": 1, "y": 2, "marks": [], "name": "tip", "sum": 3}
        assert module.astuple(one) == (1, 2, [], "tip", 3)
        assert module.is_dataclass(one)
        assert module.is_dataclass(type(one))
        assert not module.is_dataclass(1)


@light_dataclasses.dataclass(frozen=True)
class Base:
    """A base."""

    first: int
    second: int = 2


@light_dataclasses.dataclass(frozen=True, slots=True)
class Derived(Base):
    """A class with the fields of its base before its own."""

    third: int = 3


def test_fields_are_inherited() -> None:
    assert repr(Derived(1, third=4)) == "Derived(first=1, second=2, third=4)"
    assert Derived(1) != Base(1)


def test_instances_are_pickled() -> None:
    assert pickle.loads(pickle.dumps(Derived(7))) == Derived(7)  # noqa: S301  our own


def test_what_a_class_defines_itself_stays() -> None:
    @light_dataclasses.dataclass(frozen=True)
    class Own:
        x: int

        def __repr__(self) -> str:
            return "mine"

        def __hash__(self) -> int:
            return 7

    assert (repr(Own(1)), hash(Own(1)), Own(1)) == ("mine", 7, Own(1))


def test_the_standard_library_is_not_imported() -> None:
    code = "import sys, kinlint.light_dataclasses; print('dataclasses' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "False\n"
