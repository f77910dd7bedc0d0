"""Poses as MJCF writes them: a position, and an orientation in one of five forms."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from math import cos, hypot, sin, sqrt

from kinlint.formats.mjcf.compiler_settings import CompilerSettings
from kinlint.formats.mjcf.mjcf_elements import MjcfElement
from kinlint.formats.rigid_transform import (
    IDENTITY,
    Quaternion,
    Transform,
    Vector,
    composed,
)

UNTURNED = IDENTITY[1]
AXES: Mapping[str, Vector] = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}
TINY = 1e-14
"""The length below which a vector has no direction for MuJoCo."""


def pose(element: MjcfElement, settings: CompilerSettings) -> Transform | None:
    """Return the pose that *element* says; None if it says one that is none."""
    turned = orientation(element, settings)
    position = element.numbers("pos") or [0.0, 0.0, 0.0]
    if turned is None or len(position) != len("xyz"):
        return None
    return (position[0], position[1], position[2]), turned


def orientation(element: MjcfElement, settings: CompilerSettings) -> Quaternion | None:
    """Return the orientation that *element* says, unturned where it says none; None if invalid."""
    for name, form in FORMS.items():
        numbers = element.numbers(name)
        if name in element.said or name in element.inherited:
            return form(numbers, settings)
    return UNTURNED


def axis_rotation(axis: Sequence[float], angle: float) -> Quaternion | None:
    """Return the rotation by *angle*, in radians, about *axis*; None without a direction."""
    direction = unit(axis)
    if direction is None:
        return None
    s = sin(angle / 2)
    return direction[0] * s, direction[1] * s, direction[2] * s, cos(angle / 2)


def unit(vector: Sequence[float]) -> Vector | None:
    """Return *vector* with length 1; None if it has no direction."""
    length = hypot(*vector)
    if len(vector) != len("xyz") or not TINY <= length < float("inf"):
        return None
    return vector[0] / length, vector[1] / length, vector[2] / length


def upward(z: Sequence[float]) -> Quaternion | None:
    """Return the smallest rotation that takes the axis z to the direction *z*."""
    end = unit(z)
    if end is None:
        return None
    x, y = -end[1], end[0]
    s = hypot(x, y)
    if s < TINY:
        return UNTURNED if end[2] > 0 else (1.0, 0.0, 0.0, 0.0)
    half = sqrt((1 + end[2]) / 2)
    other = sqrt((1 - end[2]) / 2)
    return x / s * other, y / s * other, 0.0, half


def euler(angles: Sequence[float], settings: CompilerSettings) -> Quaternion | None:
    """Return the rotation by three *angles* about the axes that *settings* say."""
    sequence = settings.text("eulerseq", "xyz")
    if len(angles) != len(sequence) or any(each.lower() not in AXES for each in sequence):
        return None
    turned = UNTURNED
    for name, angle in zip(sequence, angles, strict=True):
        step = axis_rotation(AXES[name.lower()], settings.angle(angle))
        assert step is not None
        turned = multiplied(turned, step) if name.islower() else multiplied(step, turned)
    return turned


def multiplied(a: Quaternion, b: Quaternion) -> Quaternion:
    """Return the rotation *b* followed, in the frame that sees both, by *a*."""
    return composed(((0.0, 0.0, 0.0), a), ((0.0, 0.0, 0.0), b))[1]


def _quaternion(numbers: Sequence[float], _settings: CompilerSettings) -> Quaternion | None:
    length = hypot(*numbers)
    if len(numbers) != len("wxyz") or not 0 < length < float("inf"):
        return None
    w, x, y, z = (each / length for each in numbers)
    return x, y, z, w


def _axis_angle(numbers: Sequence[float], settings: CompilerSettings) -> Quaternion | None:
    if len(numbers) != len("xyz") + 1:
        return None
    return axis_rotation(numbers[:3], settings.angle(numbers[3]))


def _axes(numbers: Sequence[float], _settings: CompilerSettings) -> Quaternion | None:
    x = unit(numbers[:3])
    if x is None or len(numbers) != 2 * len("xyz"):
        return None
    along = sum(a * b for a, b in zip(x, numbers[3:], strict=True))
    y = unit([b - along * a for a, b in zip(x, numbers[3:], strict=True)])
    if y is None:
        return None
    z = (x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0])
    return _from_columns(x, y, z)


def _from_columns(x: Vector, y: Vector, z: Vector) -> Quaternion:
    """Return the rotation of the matrix with the columns *x*, *y* and *z*."""
    squares = (
        1 + x[0] - y[1] - z[2],
        1 - x[0] + y[1] - z[2],
        1 - x[0] - y[1] + z[2],
        1 + x[0] + y[1] + z[2],
    )
    # Row k has the products of component k with all others, times four.
    products = (
        (squares[0], y[0] + x[1], z[0] + x[2], y[2] - z[1]),
        (y[0] + x[1], squares[1], z[1] + y[2], z[0] - x[2]),
        (z[0] + x[2], z[1] + y[2], squares[2], x[1] - y[0]),
        (y[2] - z[1], z[0] - x[2], x[1] - y[0], squares[3]),
    )
    row = products[max(range(4), key=squares.__getitem__)]
    length = hypot(*row)
    a, b, c, d = (each / length for each in row)
    return a, b, c, d


FORMS: Mapping[str, Callable[[Sequence[float], CompilerSettings], Quaternion | None]] = {
    "quat": _quaternion,
    "axisangle": _axis_angle,
    "euler": euler,
    "xyaxes": _axes,
    "zaxis": lambda numbers, _: upward(numbers),
}
"""The forms of orientations, by attribute."""
