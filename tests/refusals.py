"""What Pinocchio, MuJoCo and Drake refuse of URDF, meshes aside; each where it is installed."""

from __future__ import annotations

import importlib
import importlib.util
import os
import re
import signal
from collections.abc import Callable, Mapping
from pathlib import Path

PATIENCE = 40
"""Seconds after which a consumer is not waited for."""
MESH = re.compile(rb"<mesh\b[^>]*?(?:/>|>.*?</mesh\s*>)", re.DOTALL)
BOX = b'<box size="0.1 0.1 0.1"/>'
MODULES = {"pinocchio": "pinocchio", "mujoco": "mujoco", "drake": "pydrake.multibody.parsing"}
"""The Python module that loads files for each consumer."""


def without_meshes(text: bytes) -> bytes:
    """Return *text* with a small box for each mesh, whose files may be missing."""
    return MESH.sub(BOX, text)


def is_installed(consumer: str) -> bool:
    """Tell whether *consumer* can be imported."""
    return importlib.util.find_spec(MODULES[consumer].partition(".")[0]) is not None


def refuses(consumer: str, path: Path) -> bool:
    """Tell whether *consumer* refuses the URDF at *path*, or dies of it.

    It runs in a process of its own: Drake aborts for some files. It is imported before, once.
    """
    importlib.import_module(MODULES[consumer])
    child = os.fork()
    if child == 0:
        sink = os.open(os.devnull, os.O_WRONLY)
        os.dup2(sink, 1)
        os.dup2(sink, 2)
        signal.alarm(PATIENCE)
        try:
            LOADERS[consumer](str(path))
        except BaseException:  # noqa: BLE001  Drake raises SystemExit
            os._exit(1)
        os._exit(0)
    return os.waitpid(child, 0)[1] != 0


def _pinocchio(path: str) -> None:
    import pinocchio  # noqa: PLC0415

    pinocchio.buildModelFromUrdf(path)


def _mujoco(path: str) -> None:
    import mujoco  # noqa: PLC0415

    mujoco.MjModel.from_xml_path(path)


def _drake(path: str) -> None:
    from pydrake.multibody.parsing import Parser  # noqa: PLC0415
    from pydrake.multibody.plant import AddMultibodyPlantSceneGraph  # noqa: PLC0415
    from pydrake.systems.framework import DiagramBuilder  # noqa: PLC0415

    plant, _ = AddMultibodyPlantSceneGraph(DiagramBuilder(), 0.001)
    Parser(plant).AddModels(path)
    plant.Finalize()


LOADERS: Mapping[str, Callable[[str], None]] = {
    "pinocchio": _pinocchio,
    "mujoco": _mujoco,
    "drake": _drake,
}
"""By consumer, what loads the file of a path or raises."""
