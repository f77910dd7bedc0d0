"""Makes the table of the elements of COLLADA from a list of the classes of its schema.

    python tests/formats/collada/collada_classes.py collada-kinematics.tsv

Prints `shapes/formats/collada-elements.ttl`. The list has a row for each element, attribute and
child of the classes that collada-dom generates from the schema of COLLADA 1.5.
"""

from __future__ import annotations

import csv
import re
import sys
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from textwrap import fill

HEAD = """\
# COLLADA 1.5: which element stands where, what attributes it has, what its text is.
# One node is one class of its schema under one tag.  fmt:required are attributes that the schema
# requires.  What is not listed in detail is open.
# Made from the classes by tests/formats/collada/collada_classes.py, not edited by hand; what they
# do not say is in collada.ttl.
@prefix fmt: <https://w3id.org/kinlint/format#> .
@prefix collada: <https://w3id.org/kinlint/collada#> .
"""
EXTENSION = "profile="
"""Mark of the rows about extensions, which are no part of the schema."""
TEXTS = {"token", "text", "SID reference", "string"}
BY_NAME = {"Int": "int", "SIDREF": "token"}
"""Content of classes that the list has without."""
NUMBERS = {"float": "number", "int": "integer", "boolean": "boolean"}


@dataclass
class Class:
    """Class of the schema."""

    content: str = "-"
    """Type of its text; "-" for none."""
    attributes: dict[str, tuple[str, bool]] = field(default_factory=dict)
    """Types of its attributes, and whether they are required."""
    children: dict[str, tuple[str, str]] = field(default_factory=dict)
    """Classes and cardinalities of its children, by tag."""


def classes(path: Path) -> tuple[dict[str, Class], dict[str, dict[str, None]]]:
    """Return the classes by name, and those of each tag."""
    found: dict[str, Class] = {}
    tags: dict[str, dict[str, None]] = {}
    with path.open(encoding="utf-8", newline="") as text:
        for row in csv.DictReader(text, delimiter="\t", quoting=csv.QUOTE_NONE):
            name, item = row["schema type"], row["item"]
            if EXTENSION in name:
                continue
            known = found.setdefault(name, Class())
            tags.setdefault(row["element"], {})[name] = None
            if item == "element":
                known.content = BY_NAME.get(name, row["type"])
            elif item == "attribute":
                required = row["cardinality"] == "1..1"
                known.attributes[row["name"]] = row["type"], required
            else:
                known.children[row["name"]] = row["type"], row["cardinality"]
                tags.setdefault(row["name"], {})[row["type"]] = None
    return found, tags


def elements(path: Path) -> str:
    """Return the table that the list at *path* makes."""
    found, tags = classes(path)
    nodes = {
        (tag, name): _node(tag, name, alone=len(names) == 1)
        for tag, names in tags.items()
        for name in names
    }
    said = (_element(tag, found.get(name), node, nodes) for (tag, name), node in nodes.items())
    return HEAD + "\n" + "".join(said)


def _node(tag: str, name: str, *, alone: bool) -> str:
    """Return the node of the elements with *tag* of a class, which may be *alone* to have it."""
    if alone:
        return f"collada:{tag}"
    slug = name.lower().replace(".", "-")
    return f"collada:{slug if slug.endswith(tag.lower()) else f'{slug}-{tag}'}"


def _element(tag: str, known: Class | None, node: str, nodes: Mapping[tuple[str, str], str]) -> str:
    said = [f'fmt:tag "{tag}"']
    if known is None or (known.content == "-" and not known.attributes and not known.children):
        said.append("fmt:open true")
    else:
        said += _content(known.content)
        said += _attributes(known.attributes)
        said += _children(known.children, nodes)
    return f"{node} " + " ;\n    ".join(said) + " .\n"


def _content(content: str) -> Iterator[str]:
    vector = re.fullmatch(r"(\d+) floats", content)
    if vector:
        yield f"fmt:content fmt:vector{vector[1]}"
    elif content in NUMBERS:
        yield f"fmt:content fmt:{NUMBERS[content]}"
    elif content in TEXTS:
        yield "fmt:content fmt:text"
    elif content != "-":
        words = " ".join(f'"{each}"' for each in content.split())
        yield "fmt:content fmt:text"
        yield f'fmt:choice ( "" {words} )'


def _attributes(attributes: Mapping[str, tuple[str, bool]]) -> Iterator[str]:
    kinds: dict[str, list[str]] = {}
    for name, (type_, _) in sorted(attributes.items()):
        kinds.setdefault(NUMBERS.get(type_, "text"), []).append(name.replace("xml_", "xml:"))
    for kind, names in sorted(kinds.items()):
        yield _list(f"fmt:{kind}", [f'"{name}"' for name in names])
    required = [f'"{name}"' for name, (_, is_required) in attributes.items() if is_required]
    if required:
        yield _list("fmt:required", sorted(required))


def _children(
    children: Mapping[str, tuple[str, str]], nodes: Mapping[tuple[str, str], str]
) -> Iterator[str]:
    """Yield the children; those of a choice are listed as if each were there exactly once."""
    for word, once in (("once", True), ("many", False)):
        known = [
            nodes[tag, name]
            for tag, (name, cardinality) in children.items()
            if (cardinality == "0..1") is once
        ]
        if known:
            yield _list(f"fmt:{word}", known)


def _list(property_: str, values: list[str]) -> str:
    return fill(
        f"{property_} {' , '.join(values)}",
        96,
        subsequent_indent=" " * 8,
        break_long_words=False,
        break_on_hyphens=False,
    )


if __name__ == "__main__":
    sys.stdout.write(elements(Path(sys.argv[1])))
