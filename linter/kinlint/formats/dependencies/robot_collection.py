"""Collections of robots, in which an SRDF finds its own without a look at each of the others."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property

from kinlint.formats.dependencies.robot_descriptions import Description


class Robots:
    """Descriptions of robots, by the stems of their files and by their names."""

    def __init__(self, every: Sequence[Description]) -> None:
        self.every = every
        self._found: dict[tuple[object, ...], Sequence[Description]] = {}

    def __contains__(self, robot: Description) -> bool:
        """Tell whether the file of *robot* is one of theirs."""
        return robot.path in self._paths

    @cached_property
    def _paths(self) -> frozenset[object]:
        return frozenset(each.path for each in self.every)

    @cached_property
    def plain(self) -> Sequence[Description]:
        """The robots that are no xacro."""
        return [each for each in self.every if not each.generated]

    @cached_property
    def by_stem(self) -> dict[str, list[Description]]:
        """The robots of each stem."""
        return self._by(lambda each: each.stem)

    @cached_property
    def _by_robot(self) -> dict[str, list[Description]]:
        return self._by(lambda each: each.robot)

    def _by(self, key: Callable[[Description], str]) -> dict[str, list[Description]]:
        found: dict[str, list[Description]] = {}
        for each in self.every:
            found.setdefault(key(each), []).append(each)
        return found

    def of_name(self, srdf: Description) -> Sequence[Description]:
        """Return those with the name of the robot of *srdf* and most of its parts, no text twice.

        The nearest come last. SRDF files of one directory with the same names share the result.
        """
        key = srdf.robot, srdf.names, srdf.generated, srdf.path.parent
        if key not in self._found:
            found = [each for each in self._by_robot.get(srdf.robot, ()) if srdf.resembles(each)]
            found.sort(key=lambda urdf: -shared_directories(srdf, urdf))
            texts = {each.source.text: each for each in reversed(found)}
            self._found[key] = list(texts.values())
        return self._found[key]


def shared_directories(srdf: Description, urdf: Description) -> int:
    """Return the number of directories that the files of both are in."""
    steps = zip(srdf.path.parts, urdf.path.parts, strict=False)
    count = 0
    for one, other in steps:
        if one != other:
            break
        count += 1
    return count
