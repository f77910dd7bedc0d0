"""Difference between two descriptions of a robot as plain data, which reports show."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TypeAlias

from kinlint.light_dataclasses import dataclass, field
from kinlint.text import Location

Quantity: TypeAlias = "float | str | tuple[float, float, float] | None"

PLAIN = 6
"""Significant digits of numbers, unless two that differ look alike with them."""
EXACT = 17
"""Significant digits that tell any two doubles apart."""
SMALL = 1e-12
"""Magnitude below which a component is what rounding leaves of zero."""


@dataclass(frozen=True)
class Change:
    """Quantity of a part that two descriptions give otherwise."""

    kind: str
    """Kind of the part, `joint` or `link`; `robot` for the whole, `value` for what is no value."""
    part: str
    """Name of the part in the old description."""
    new_part: str
    """Name of the part in the new one."""
    quantity: str
    """Name of the quantity, such as `mass`."""
    unit: str
    """Symbol of the unit; empty for words and plain numbers."""
    old: Quantity
    """Old value; None where there is no bound."""
    new: Quantity
    """New value."""
    old_place: Location | None = None
    """Place of the old value."""
    new_place: Location | None = None
    """Place of the new one."""

    @property
    def title(self) -> str:
        """The part with its name, or both of its names."""
        if self.kind == "robot":
            return "robot"
        if self.kind == "value":
            return "not read, so as if it were not given"
        also = f" (now '{self.new_part}')" if self.new_part != self.part else ""
        return f"{self.kind} '{self.part}'{also}"

    @property
    def values(self) -> tuple[str, str]:
        """Both values as text, with as many digits as tell them apart."""
        for digits in range(PLAIN, EXACT + 1):
            shown = written(self.old, digits), written(self.new, digits)
            if shown[0] != shown[1]:
                break
        return shown

    @property
    def degrees(self) -> tuple[str, str] | None:
        """Both values in degrees, if they are angles."""
        if not self.unit.startswith("rad"):
            return None
        pair = [each for each in (self.old, self.new) if isinstance(each, float)]
        if len(pair) < 2:  # noqa: PLR2004
            return None
        return written(math.degrees(pair[0]), PLAIN), written(math.degrees(pair[1]), PLAIN)

    @property
    def phrase(self) -> str:
        """The change in one phrase, such as `mass 2.1 to 2.4 kg`."""
        if self.kind == "value":
            return f"{self.quantity} is {self.old or self.new}"
        old, new = self.values
        unit = f" {self.unit}" if self.unit else ""
        if self.quantity.startswith("orientation"):
            turned = f"turned by {new}{unit}"
            return f"{self.quantity} {turned}" + (f" ({self.degrees[1]}°)" if self.degrees else "")
        text = f"{self.quantity} {old} to {new}{unit}"
        if self.degrees is not None:
            text += f" ({self.degrees[0]}° to {self.degrees[1]}°)".replace(
                "°", "°/s" if self.unit.endswith("/s") else "°"
            )
        is_place = self.unit == "m" and not self.quantity.startswith("size")
        if is_place and isinstance(self.old, tuple) and isinstance(self.new, tuple):
            text += f" ({written(math.dist(self.old, self.new), 3)} m apart)"
        return text


def written(value: Quantity, digits: int) -> str:
    """Return *value* as text, numbers with at most so many significant *digits*."""
    if value is None:
        return "unlimited"
    if isinstance(value, str):
        return value
    if isinstance(value, tuple):
        return f"({', '.join(written(each, digits) for each in value)})"
    return f"{value if abs(value) > SMALL else 0.0:.{digits}g}"


@dataclass(frozen=True)
class Part:
    """Part that only one description has."""

    kind: str
    """Kind of the part, `joint` or `link`."""
    name: str
    """Name of the part."""
    detail: str = ""
    """Kind of movement, of joints."""
    place: Location | None = None
    """Place of the part."""


@dataclass(frozen=True)
class Unstated:
    """Quantity that only one description states, of some parts."""

    quantity: str
    """Name of the quantity, such as `speed limit`."""
    old_states: bool
    """True if the old description states it, False if the new one does."""
    parts: Sequence[str]
    """Names of the parts."""
    expressible: bool
    """True if the format of the other description could state it."""
    form: str
    """Title of the format of the other description."""
    counts: bool = False
    """True if it is a difference: two descriptions in one format could both state it."""


@dataclass(frozen=True)
class RobotDifference:
    """Difference between two descriptions of a robot."""

    old: str
    """Name of the old description; empty if there is none."""
    new: str
    """Name of the new description; empty if there is none."""
    matched: str = ""
    """Evidence for which parts correspond: `names` or `structure`."""
    joints: tuple[int, int, int] = (0, 0, 0)
    """Number of moving joints in common, in the old and in the new description."""
    changes: Sequence[Change] = field(default=())
    """Quantities that are otherwise, those of the whole first."""
    removed: Sequence[Part] = field(default=())
    """Parts that only the old description has."""
    added: Sequence[Part] = field(default=())
    """Parts that only the new description has."""
    unstated: Sequence[Unstated] = field(default=())
    """Quantities that only one states."""

    @property
    def differs(self) -> bool:
        """Tell whether the descriptions are of different robots."""
        return bool(self.count or self.changes or not (self.old and self.new))

    @property
    def count(self) -> int:
        """Number of differences of quantities and parts; the whole follows from its parts."""
        own = sum(each.kind != "robot" for each in self.changes)
        lost = sum(len(each.parts) for each in self.unstated if each.counts)
        return own + len(self.removed) + len(self.added) + lost

    def by_part(self) -> Sequence[tuple[str, Sequence[Change]]]:
        """Return the changes of each part, with its title."""
        found: dict[str, list[Change]] = {}
        for each in self.changes:
            found.setdefault(each.title, []).append(each)
        return list(found.items())
