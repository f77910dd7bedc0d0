"""Mistakes that people make in models, to be put into clean chains and found there."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from typing import Any, TypeAlias

STEP = 5
"""Every fifth joint gets a defect. A step of one would hide what one defect does to others."""

Node: TypeAlias = dict[str, Any]
Nodes: TypeAlias = Mapping[str, Node]
"""The nodes of a chain by identifier."""


def inject(nodes: Nodes, joints: int) -> None:
    """Put one defect into every fifth of *joints*, each kind of `DEFECTS` in turn."""
    for number, (_, defect) in _planned(joints):
        defect(nodes, number)


def expected(joints: int) -> Counter[str]:
    """How many findings of each rule, by code, a spoiled chain of *joints* has."""
    found = Counter(code for _, (code, _) in _planned(joints))
    if found["TOP005"]:
        # Joints without a second body leave the one chain in pieces, however many there are.
        found["TOP006"] = 1
    return found


def _planned(joints: int) -> Iterator[tuple[int, tuple[str, Callable[[Nodes, int], None]]]]:
    for turn, number in enumerate(range(0, joints, STEP)):
        yield number, DEFECTS[turn % len(DEFECTS)]


def _forget_unit(nodes: Nodes, number: int) -> None:
    del _coordinates(nodes, number)["unit"]


def _forget_frame(nodes: Nodes, number: int) -> None:
    del _coordinates(nodes, number)["as-seen-by"]


def _take_wrong_unit(nodes: Nodes, number: int) -> None:
    _coordinates(nodes, number)["unit"] = "RAD"


def _forget_reference(nodes: Nodes, number: int) -> None:
    del nodes[f"rob:joint{number}-offset"]["with-respect-to"]


def _reflect(nodes: Nodes, number: int) -> None:
    nodes[f"rob:link{number}-pose-coord"]["direction-cosine-y"] = [0.0, 0.0, 1.0]


def _inflate_inertia(nodes: Nodes, number: int) -> None:
    nodes[f"rob:link{number}-inertia-coord"]["izz"] = 0.4


def _sever(nodes: Nodes, number: int) -> None:
    del nodes[f"rob:joint{number}"]["between-attachments"][1]


def _misspell_reference(nodes: Nodes, number: int) -> None:
    nodes[f"rob:joint{number}"]["origin-offset"] = f"rob:joint{number}-ofset"


def _misspell_key(nodes: Nodes, number: int) -> None:
    nodes[f"rob:joint{number}"]["positve-direction"] = f"rob:link{number}-tip-z"


def _misspell_type(nodes: Nodes, number: int) -> None:
    nodes[f"rob:joint{number}"]["@type"][1] = "RevoluteJiont"


def _strip_frame(nodes: Nodes, number: int) -> None:
    frame = nodes[f"rob:link{number}-tip"]
    frame["@type"].remove("OriginVectorsXYZ")
    for key in ("origin", "vector-x", "vector-y", "vector-z"):
        del frame[key]


def _give_two_origins(nodes: Nodes, number: int) -> None:
    nodes[f"rob:link{number}-root"]["origin"] = [
        f"rob:link{number}-{frame}-origin" for frame in ("root", "tip")
    ]


def _forget_identifier(nodes: Nodes, number: int) -> None:
    nodes[f"rob:link{number}"]["simplices"].append({"@type": ["3D", "Euclidean", "Point"]})


def _forget_prefix(nodes: Nodes, number: int) -> None:
    nodes[f"rob:joint{number}"]["common-axis"] = f"joint{number}-axis"


def _coordinates(nodes: Nodes, number: int) -> Node:
    return nodes[f"rob:joint{number}-offset-coord"]


DEFECTS: tuple[tuple[str, Callable[[Nodes, int], None]], ...] = (
    ("UNI001", _forget_unit),
    ("FRM002", _forget_frame),
    ("UNI002", _take_wrong_unit),
    ("FRM001", _forget_reference),
    ("FRM004", _reflect),
    ("INE001", _inflate_inertia),
    ("TOP005", _sever),
    ("LD006", _misspell_reference),
    ("LD001", _misspell_key),
    ("LD003", _misspell_type),
    ("FRM014", _strip_frame),
    ("ID004", _give_two_origins),
    ("LD007", _forget_identifier),
    ("LD004", _forget_prefix),
)
"""Each kind of mistake, by the code of the rule that finds it."""
