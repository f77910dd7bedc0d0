"""Settings of the compiler of one model: the last ones of its assembled file."""

from __future__ import annotations

from math import radians

from kinlint.formats.mjcf.mjcf_elements import MjcfElement
from kinlint.light_dataclasses import dataclass, field
from kinlint.terms import Triple

GROUPS = (0, 5)
"""The first and the last group of geoms that give inertia by default."""


@dataclass(frozen=True)
class CompilerSettings:
    """Settings of the elements `compiler` of a model together."""

    said: dict[str, list[Triple]] = field(default_factory=dict)
    """The statements of each attribute that is written, of the last element that has it."""
    element: MjcfElement | None = None
    """The settings as attributes of one element; None where the model has no compiler."""
    overruled: tuple[tuple[Triple, Triple], ...] = ()
    """The statements of attributes that a later element says otherwise, each with that."""

    @classmethod
    def from_root(cls, root: MjcfElement) -> CompilerSettings:
        """Return the settings of the model below *root*."""
        said: dict[str, list[Triple]] = {}
        last, written = None, []
        for last in root.all("compiler"):
            said |= {name: triples for name, triples in last.said.items() if triples}
            written += [(name, triples[0]) for name, triples in last.said.items() if triples]
        final = ((each, said[name][0]) for name, each in written)
        overruled = tuple((each, later) for each, later in final if each[2] != later[2])
        if last is None:
            return cls()
        element = MjcfElement(last.node, last.tag, root, last.type, said)
        return cls(said, element, overruled)

    def text(self, name: str, default: str = "") -> str:
        """Return the setting *name*, or its *default*."""
        return (self.element.text(name) if self.element else "") or default

    def number(self, name: str, default: float) -> float:
        """Return the number of the setting *name*, or its *default*."""
        numbers = self.element.numbers(name) if self.element else []
        return numbers[0] if numbers else default

    @property
    def degrees(self) -> bool:
        """Tell whether angles are in degrees."""
        return self.text("angle") != "radian"

    def angle(self, value: float) -> float:
        """Return an angle of the model in radians."""
        return radians(value) if self.degrees else value

    @property
    def autolimits(self) -> bool:
        """Tell whether a range is a limit unless something else is written."""
        return self.text("autolimits") != "false"

    @property
    def groups(self) -> tuple[float, float]:
        """The first and the last group of geoms that give inertia."""
        found = self.element.numbers("inertiagrouprange") if self.element else []
        return (found[0], found[1]) if len(found) == len(GROUPS) else GROUPS
