"""What natively reads robots of each format, as far as PyPI brings it: urdfdom, Pinocchio, xacro,
PyLD. Nothing there brings libsdformat or srdfdom; their formats are read as XML only.
"""

from __future__ import annotations

import json
import os
import random
import subprocess
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import cache, partial
from pathlib import Path
from types import ModuleType
from typing import Any, NamedTuple
from xml.etree import ElementTree as ET

from pinocchio_robots import ROOT, configuration, silence

from kinlint.contexts.context_library import Contexts
from kinlint.files.packages import Packages

CONFIGURATIONS = 2
PATIENCE = 60
"""Seconds after which a consumer is not waited for."""


class Motion(NamedTuple):
    """The total mass, in kg, and where links are, by their names, seen from the first by name.

    A place is the 12 numbers of a rotation and a translation, in m, for each configuration.
    """

    mass: float
    places: Mapping[str, Sequence[float]]

    def apart(self, other: Motion) -> float:
        """The largest difference, relative where numbers are above one; infinite for other links.

        Robots that agree in links are in the same configurations if they agree in joints.
        """
        if self.places.keys() != other.places.keys():
            return float("inf")
        pairs = [(self.mass, other.mass)]
        for link, place in self.places.items():
            pairs += zip(place, other.places[link], strict=True)
        return max(abs(a - b) / max(1.0, abs(a)) for a, b in pairs)


Reading = Mapping[str, Motion | bool]
"""By consumer, what it makes of a file: a motion, that it read it, or that it refused to."""


def reading(form: str, path: Path, packages: Packages) -> Reading:
    """What each consumer of *form* makes of the file at *path*."""
    return {name: read(path, packages) for name, read in CONSUMERS[form].items()}


def urdfdom(path: Path, _: Packages) -> bool:
    """Whether check_urdf accepts a file."""
    command = check_urdf()
    assert command is not None
    libraries = {"LD_LIBRARY_PATH": str(command.parents[1] / "lib")}
    done = subprocess.run(
        [command, path],
        capture_output=True,
        check=False,
        timeout=PATIENCE,
        env={**os.environ, **libraries},
    )
    return done.returncode == 0


@cache
def check_urdf() -> Path | None:
    """The program, which comes with Pinocchio; None where neither is installed."""
    try:
        import pinocchio  # noqa: PLC0415
    except ImportError:
        return None
    prefixes = (each for each in Path(pinocchio.__file__).parents if each.name == "cmeel.prefix")
    found = next(prefixes, Path()) / "bin" / "check_urdf"
    return found if found.exists() else None


def pinocchio(path: Path, _: Packages) -> Motion | bool:
    """How a robot moves and weighs; False if Pinocchio refuses it."""
    import pinocchio as pin  # noqa: PLC0415

    try:
        with silence():
            model = pin.buildModelFromUrdf(str(path), pin.JointModelFreeFlyer(), ROOT)
    except (ValueError, RuntimeError):
        return False
    links = sorted(each.name for each in model.frames if each.type == pin.FrameType.BODY)
    places: dict[str, list[float]] = {link: [] for link in links}
    data = model.createData()
    for number in range(CONFIGURATIONS):
        numbers = partial(_numbers, number)
        q = configuration(pin, model, numbers)[1]
        pin.framesForwardKinematics(model, data, q)
        found = [data.oMf[model.getFrameId(link, pin.FrameType.BODY)] for link in links]
        for link, place in zip(links, found, strict=True):
            seen = found[0].actInv(place)
            places[link] += [*seen.rotation.flatten().tolist(), *seen.translation.tolist()]
    return Motion(float(pin.computeTotalMass(model)), places)


def _numbers(configuration: int, joint: str) -> random.Random:
    """What the position of a joint is drawn from, whatever the others are called."""
    return random.Random(f"{configuration} {joint}")  # noqa: S311


def xacro(path: Path, packages: Packages) -> bool:
    """Whether the xacro package expands a file, finding ROS packages where *packages* does."""
    return _expanded(path, packages) is not None


def _expanded(path: Path, packages: Packages) -> str | None:
    import xacro as expander  # noqa: PLC0415

    try:
        with ament(packages), silence():
            text: str = expander.process_file(str(path), mappings={}).toxml()
    except Exception:  # noqa: BLE001  of any kind
        return None
    return text


def _of_the_expansion(read: Callable[[Path, Packages], Motion | bool]) -> Any:
    def read_expansion(path: Path, packages: Packages) -> Motion | bool:
        text = _expanded(path, packages)
        if text is None:
            return False
        scratch = path.with_name("expanded by xacro.urdf")
        scratch.write_text(text, "utf-8")
        try:
            return read(scratch, packages)
        finally:
            scratch.unlink()

    return read_expansion


@contextmanager
def ament(packages: Packages) -> Iterator[None]:
    """The package that tells others of ROS packages knows those of *packages*."""
    outer, inner = ModuleType("ament_index_python"), ModuleType("ament_index_python.packages")

    def share(name: str) -> str:
        found = packages.find(name, Path("/"))
        if found is None:
            raise KeyError(name)
        return str(found)

    inner.get_package_share_directory = share  # type: ignore[attr-defined]
    kept = {name: sys.modules.get(name) for name in (outer.__name__, inner.__name__)}
    sys.modules.update({outer.__name__: outer, inner.__name__: inner})
    try:
        yield
    finally:
        for name, module in kept.items():
            if module is None:
                del sys.modules[name]
            else:
                sys.modules[name] = module


def elementtree(path: Path, _: Packages) -> bool:
    """Whether a file is well-formed XML with declared prefixes."""
    try:
        ET.parse(path)  # noqa: S314  files of our own data
    except (ET.ParseError, LookupError, ValueError):
        return False
    return True


def pyld(path: Path, _: Packages) -> bool:
    """Whether PyLD expands a file under the published contexts."""
    from pyld import jsonld  # noqa: PLC0415

    try:
        document = json.loads(path.read_text("utf-8-sig"))
        options = {"base": "https://robot.example/", "documentLoader": _loader}
        jsonld.expand(document, options)
    except (ValueError, jsonld.JsonLdError):
        return False
    return True


def _loader(iri: str, _: object) -> Mapping[str, Any]:
    found = _contexts().document(iri)
    if found is None:
        raise ValueError(iri)
    return {
        "contentType": "application/ld+json",
        "contextUrl": None,
        "documentUrl": iri,
        "document": found,
    }


@cache
def _contexts() -> Contexts:
    return Contexts.bundled()


CONSUMERS: Mapping[str, Mapping[str, Callable[[Path, Packages], Motion | bool]]] = {
    "jsonld": {"PyLD": pyld},
    "urdf": {"urdfdom": urdfdom, "Pinocchio": pinocchio},
    "xacro": {
        "xacro": xacro,
        "urdfdom": _of_the_expansion(urdfdom),
        "Pinocchio": _of_the_expansion(pinocchio),
    },
    "srdf": {"XML": elementtree},
    "sdf": {"XML": elementtree},
}
"""By format."""
