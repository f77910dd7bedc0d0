"""Makes the table of the schemas of USD from those that usd-core and plugins register.

    python tests/formats/usd/usd_schemas.py usd-physics.tsv PLUGINS...

Prints `shapes/formats/usd-elements.ttl`. It asks the schema registry of usd-core, to which it adds
the plugins, directories with a `plugInfo.json`: those of newton-usd-schemas, physx-usd-schemas,
mujoco-usd-converter and isaacsim-robot-schema. The list has the units, which no schema has.
"""

from __future__ import annotations

import csv
import sys
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from textwrap import fill
from typing import Any

HEAD = """\
# USD: the schemas that prims have by their type or by applying them, and their properties.
# What does not follow from the schemas is in usd.ttl.
# Made from usd-core, newton-usd-schemas, physx-usd-schemas, mujoco-usd-converter and
# isaacsim-robot-schema by tests/formats/usd/usd_schemas.py, not edited by hand.
@prefix fmt: <https://w3id.org/kinlint/format#> .
@prefix usd: <https://w3id.org/kinlint/usd#> .
"""
INSTANCE = "__INSTANCE_NAME__"
ROOTS = {"Typed", "APISchemaBase", "SchemaBase", ""}
"""Schemas without properties that all others extend."""
UNITS = {
    "degree": "degree",
    "length unit (metersPerUnit)": "length",
    "mass unit (kilogramsPerUnit)": "mass",
    "M L2": "inertia",
    "M / L3": "density",
    "degree / s": "degree-per-second",
    "L / s": "length-per-second",
}
"""Names of units in the table, by what the list says; others depend on the prim."""


def registry_with(plugins: Iterable[Path]) -> Any:
    """Return the schema registry of usd-core with the *plugins*."""
    from pxr import Plug, Usd  # noqa: PLC0415  not installed with kinlint

    for each in plugins:
        Plug.Registry().RegisterPlugins(str(each))
    return Usd.SchemaRegistry()


def elements(units: Path, plugins: Sequence[Path]) -> str:
    """Return the table of all schemas with the *plugins*, and with the *units* in that list."""
    from pxr import Plug, Tf, Usd  # noqa: PLC0415  not installed with kinlint

    registry = registry_with(plugins)
    known = Plug.Registry.GetAllDerivedTypes(Tf.Type.Find(Usd.SchemaBase))
    names = sorted(filter(None, map(registry.GetSchemaTypeName, known)))
    table = Table(registry, units)
    return HEAD + "\n" + "".join(map(table.schema, names))


class Table:
    """Statements about the schemas of a *registry*, with the units in the list at *units*."""

    def __init__(self, registry: Any, units: Path) -> None:
        from pxr import Sdf, Usd  # noqa: PLC0415  not installed with kinlint

        self.registry = registry
        self.kinds = Usd.SchemaKind
        self.uniform = Sdf.VariabilityUniform
        self.units: dict[tuple[str, str], str] = {}
        with units.open(encoding="utf-8", newline="") as text:
            for row in csv.DictReader(text, delimiter="\t", quoting=csv.QUOTE_NONE):
                if known := UNITS.get(row["unit"]):
                    self.units[row["schema"], row["property"]] = known

    def schema(self, name: str) -> str:
        """Return the statements about the schema *name*; none if no prim can have it."""
        kind = self.registry.GetSchemaKind(name)
        if kind in (self.kinds.AbstractBase, self.kinds.NonAppliedAPI, self.kinds.Invalid):
            return ""
        said = [f'fmt:tag "{name}"', *self._kind(name, kind), *self._properties(name)]
        return f"usd:{name} " + " ;\n    ".join(said) + " .\n"

    def _kind(self, name: str, kind: Any) -> Iterator[str]:
        if kind in (self.kinds.SingleApplyAPI, self.kinds.MultipleApplyAPI):
            multiple = kind == self.kinds.MultipleApplyAPI
            yield f'fmt:applied "{"multiple" if multiple else "single"}"'
            if ends := self.registry.GetAPISchemaCanOnlyApplyToTypeNames(name):
                yield _list("fmt:appliesTo", (f"usd:{each}" for each in sorted(ends)))
        elif kind == self.kinds.AbstractTyped:
            yield "fmt:abstract true"
        if base := self._base(name):
            yield f"fmt:extends usd:{base}"
        if included := self._included(name):
            yield _list("fmt:includes", (f"usd:{each}" for each in included))

    def _base(self, name: str) -> str:
        """Return the typed schema that *name* extends, if there is one with properties."""
        bases = map(self.registry.GetSchemaTypeName, self.registry.GetTypeFromName(name).baseTypes)
        return next((each for each in bases if each not in ROOTS), "")

    def _definition(self, name: str) -> Any:
        return (
            self.registry.FindAppliedAPIPrimDefinition(name)
            or self.registry.FindConcretePrimDefinition(name)
            or self.registry.FindAbstractPrimDefinition(name)
        )

    def _included(self, name: str) -> list[str]:
        """Return the API schemas that *name* brings, but for instances of those with several."""
        schemas = self._definition(name).GetAppliedAPISchemas()
        return sorted({each for each in schemas if ":" not in each} - {name})

    def _own(self, name: str) -> Iterator[tuple[str, Any]]:
        """Yield the properties that *name* has of itself, as the table writes their names."""
        definition = self._definition(name)
        names = set(definition.GetPropertyNames())
        for other in (self._base(name), *self._included(name)):
            names -= set(self._definition(other).GetPropertyNames()) if other else set()
        for each in sorted(names):
            yield _quoted(each.replace(INSTANCE, "*")), definition.GetSchemaPropertySpec(each)

    def _properties(self, name: str) -> Iterator[str]:
        lists: dict[str, list[str]] = {}
        units: dict[str, list[str]] = {}
        for said, spec in self._own(name):
            if not hasattr(spec, "typeName"):
                lists.setdefault("rel", []).append(said)
                continue
            lists.setdefault(str(spec.typeName).replace("[]", "-array"), []).append(said)
            if spec.variability == self.uniform:
                lists.setdefault("uniform", []).append(said)
            if spec.allowedTokens:
                words = " ".join(map(_quoted, spec.allowedTokens))
                lists.setdefault("choice", []).append(f"( {said} {words} )")
            if unit := self.units.get((name, spec.name)):
                units.setdefault(unit, []).append(said)
        if units:
            lists["unit"] = [
                f"( {_quoted(unit)} {' '.join(names)} )" for unit, names in sorted(units.items())
            ]
        for word, said_of in sorted(lists.items()):
            yield _list(f"fmt:{word}", said_of)


def _quoted(words: str) -> str:
    escaped = words.replace("\\", "\\\\").replace('"', '\\"')
    return f'"{escaped}"'


def _list(property_: str, values: Iterable[str]) -> str:
    return fill(
        f"{property_} {' , '.join(values)}",
        96,
        subsequent_indent=" " * 8,
        break_long_words=False,
        break_on_hyphens=False,
    )


if __name__ == "__main__":
    sys.stdout.write(elements(Path(sys.argv[1]), [Path(each) for each in sys.argv[2:]]))
