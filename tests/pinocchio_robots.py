"""What tests ask of Pinocchio, besides to read robots."""

from __future__ import annotations

import math
import os
import random
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any

ROOT = "what the root moves by"
"""The name of a joint that Pinocchio puts above the root, so that it keeps the root's inertia."""


def configuration(
    pin: Any, model: Any, numbers_of: Callable[[str], random.Random]
) -> tuple[Mapping[str, Sequence[float]], Any]:
    """A position of each joint by name, and the same as Pinocchio's configuration vector."""
    q = pin.neutral(model)
    positions: dict[str, Sequence[float]] = {}
    for index in range(1, model.njoints):
        joint, name = model.joints[index], model.names[index]
        numbers = numbers_of(name)
        angle = numbers.uniform(-3.0, 3.0)
        at = slice(joint.idx_q, joint.idx_q + joint.nq)
        match joint.nq:
            case 1:
                positions[name] = [angle]
                q[at] = [angle]
            case 2:
                positions[name] = [angle]
                q[at] = [math.cos(angle), math.sin(angle)]
            case 4:
                x, y = (numbers.uniform(-1.0, 1.0) for _ in range(2))
                positions[name] = [x, y, angle]
                q[at] = [x, y, math.cos(angle), math.sin(angle)]
            case 7:
                free = [numbers.uniform(-1.0, 1.0) for _ in range(7)]
                norm = math.hypot(*free[3:])
                positions[name] = [*free[:3], *(each / norm for each in free[3:])]
                q[at] = positions[name]
    return positions, q


@contextmanager
def silence() -> Iterator[None]:
    """What parsers print goes nowhere."""
    sys.stderr.flush()
    kept = os.dup(2)
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, 2)
    try:
        yield
    finally:
        os.dup2(kept, 2)
        os.close(kept)
        os.close(nowhere)
