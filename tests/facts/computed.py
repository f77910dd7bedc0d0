"""What is computed from a small model, for tests: nodes as ex:name, numbers as floats."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping
from typing import Any

from support.linting import book, document

from kinlint.engine.closure import close
from kinlint.engine.store import Store
from kinlint.facts.computation import facts
from kinlint.facts.fact_kinds import KINDS
from kinlint.facts.fact_statements import fact
from kinlint.terms import Term, iri_value, is_literal, literal_datatype, literal_value
from kinlint.vocabulary import FACT

OF_MODELS = frozenset(
    fact(name) for kind in KINDS if kind.module != "written_features" for name in kind.needs
)
"""All facts but the features of files, which runs with targets ask for (`tests/targets`)."""
EX = "https://example.org/arm#"
CONTEXT = ["https://w3id.org/kinlint/composable.json", {"ex": EX}]
FACT_NODE = re.compile(r"urn:kinlint:fact:([\w-]+):0*")
Node = dict[str, Any]


def store_of(*nodes: Node) -> Store:
    """A closed store of one file that holds *nodes*, whose identifiers start with ex:."""
    return closed({"arm.jsonld": json.dumps({"@context": CONTEXT, "@graph": nodes})})


def closed(texts: Mapping[str, str]) -> Store:
    """A store of all *texts* by file name, closed under the axioms."""
    rules = book()
    store = Store()
    store.load([document(text, name) for name, text in texts.items()])
    store.load_vocabulary(rules.vocabulary)
    close(store, rules.axioms)
    return store


class Computed:
    """Facts by node and name."""

    def __init__(self, triples: Iterable[tuple[Term, Term, Term]]) -> None:
        self.triples = [(_plain(s), _plain(p), _plain(o)) for s, p, o in triples]

    def values(self, node: str, name: str) -> list[Any]:
        return [o for s, p, o in self.triples if (s, p) == (node, f"fact:{name}")]

    def value(self, node: str, name: str) -> Any:
        (value,) = self.values(node, name)
        return value

    def of(self, node: str) -> dict[str, Any]:
        """Whatever has one value: names are those of facts."""
        names = {p for s, p, _ in self.triples if s == node}
        found = {p.removeprefix("fact:"): self.values(node, p.removeprefix("fact:")) for p in names}
        return {name: values[0] for name, values in found.items() if len(values) == 1}

    def nodes(self, kind: str) -> list[str]:
        """The fact nodes of *kind*, in order."""
        found = dict.fromkeys(s for s, _, _ in self.triples if s.startswith(f"{kind}:"))
        return list(found)


def computed(*nodes: Node) -> Computed:
    """What follows from *nodes*."""
    return Computed(facts(store_of(*nodes), OF_MODELS))


def _plain(term: Term) -> Any:
    if is_literal(term):
        number = literal_datatype(term).endswith(("#double", "#integer"))
        return float(literal_value(term)) if number else literal_value(term)
    value = iri_value(term) if term[0] == "<" else term
    return FACT_NODE.sub(r"\1:", value.replace(EX, "ex:").replace(FACT, "fact:"))


def frame(name: str) -> list[Node]:
    """A frame ex:name with its origin."""
    return [
        {"@id": f"ex:{name}", "@type": "Frame", "origin": f"ex:{name}-origin"},
        {"@id": f"ex:{name}-origin", "@type": "Point"},
    ]


def pose(name: str, of: str, base: str, *coordinates: Node) -> list[Node]:
    """A pose ex:name of ex:of with its *coordinates*, which may override any key."""
    relation = {"@id": f"ex:{name}", "@type": "Pose", "of": f"ex:{of}"}
    return [
        relation | {"with-respect-to": f"ex:{base}"},
        *(
            {
                "@id": f"ex:{name}-coord{index or ''}",
                "@type": ["PoseReference", "PoseCoordinate", "DirectionCosineXYZ", "VectorXYZ"],
                "of-pose": f"ex:{name}",
                "as-seen-by": f"ex:{base}",
                "unit": ["UNITLESS", "M"],
            }
            | each
            for index, each in enumerate(coordinates)
        ),
    ]


def turn(x: Iterable[float], y: Iterable[float], z: Iterable[float]) -> Node:
    """Direction cosines."""
    return {
        "direction-cosine-x": list(x),
        "direction-cosine-y": list(y),
        "direction-cosine-z": list(z),
    }


def shift(x: float, y: float, z: float) -> Node:
    """The components of a vector."""
    return {"x": x, "y": y, "z": z}


STRAIGHT = turn((1, 0, 0), (0, 1, 0), (0, 0, 1))
QUARTER = turn((0, 1, 0), (-1, 0, 0), (0, 0, 1))
"""A quarter turn about z: the new x axis is the old y axis."""
