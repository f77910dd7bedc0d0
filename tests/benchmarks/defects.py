"""Mistakes that people make in models, to be put into clean chains and found there."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator
from typing import Any, TypeAlias

STEP = 3
"""Every third joint gets a defect. A step of one would hide what one defect does to others."""

Node: TypeAlias = dict[str, Any]
Nodes: TypeAlias = dict[str, Node]
"""The nodes of a chain by identifier, in the order in which they are written."""


def inject(nodes: Nodes, joints: int) -> None:
    """Put one defect into every third of *joints*, each kind of `DEFECTS` in turn."""
    for number, (_, defect) in _planned(joints):
        defect(nodes, number)


def expected(joints: int) -> Counter[str]:
    """How many findings of each rule, by code, a spoiled chain of *joints* has."""
    return Counter(code for _, (code, _) in _planned(joints))


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
    nodes[f"rob:link{number}-orientation-coord"]["direction-cosine-y"] = [0.0, 0.0, 1.0]


def _inflate_inertia(nodes: Nodes, number: int) -> None:
    nodes[f"rob:link{number}-moments"]["izz"] = 0.4


def _sever(nodes: Nodes, number: int) -> None:
    del nodes[f"rob:joint{number}"]["between-attachments"][1]


def _misspell_reference(nodes: Nodes, number: int) -> None:
    nodes[f"rob:joint{number}"]["origin-offset"] = f"rob:joint{number}-ofset"


def _misspell_key(nodes: Nodes, number: int) -> None:
    nodes[f"rob:joint{number}"]["origin-ofset"] = f"rob:joint{number}-offset"


def _misspell_type(nodes: Nodes, number: int) -> None:
    nodes[f"rob:link{number}-root"]["@type"][3] = "Orthonomal"


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


def _move_twin(nodes: Nodes, number: int) -> None:
    twin = {**_coordinates(nodes, number), "@id": f"rob:joint{number}-offset-twin", "z": 0.1}
    nodes[twin["@id"]] = twin


def _relate_to_itself(nodes: Nodes, number: int) -> None:
    nodes[f"rob:link{number}-pose"]["of"] = f"rob:link{number}-root"


def _start_elsewhere(nodes: Nodes, number: int) -> None:
    nodes[f"rob:link{number}-root-x"]["start"] = f"rob:link{number}-tip-origin"


def _turn_axis_back(nodes: Nodes, number: int) -> None:
    nodes[f"rob:joint{number}-axis"]["lines"][1] = f"rob:link{number}-root-z"


def _attach_to_point(nodes: Nodes, number: int) -> None:
    nodes[f"rob:joint{number}"]["between-attachments"][1] = f"rob:link{number + 1}-root-origin"


def _share_vector(nodes: Nodes, number: int) -> None:
    nodes[f"rob:link{number}"]["simplices"].append(f"rob:link{number + 1}-tip-y")


def _forget_point(nodes: Nodes, number: int) -> None:
    del nodes[f"rob:link{number}-inertia"]["about"]


def _swap_limits(nodes: Nodes, number: int) -> None:
    limit = f"rob:joint{number}-limit"
    nodes[limit] = {
        "@id": limit,
        "@type": "JointPositionLimit",
        "of-joint": f"rob:joint{number}",
        "quantity-kind": "Angle",
        "unit": "RAD",
        "lower": 1.5,
        "upper": -1.5,
    }


def _forget_kind(nodes: Nodes, number: int) -> None:
    del nodes[f"rob:joint{number}-offset"]["quantity-kind"]


def _take_wrong_kind(nodes: Nodes, number: int) -> None:
    nodes[f"rob:link{number}-inertia"]["quantity-kind"].append("Length")


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
    ("FRM003", _move_twin),
    ("FRM016", _relate_to_itself),
    ("FRM021", _start_elsewhere),
    ("FRM023", _turn_axis_back),
    ("TOP010", _attach_to_point),
    ("TOP011", _share_vector),
    ("INE012", _forget_point),
    ("LIM001", _swap_limits),
    ("UNI010", _forget_kind),
    ("UNI014", _take_wrong_kind),
)
"""Each kind of mistake, by the code of the rule that finds it."""
