"""The records of all formats, collected without importing a reader."""

from __future__ import annotations

from importlib import import_module

from kinlint.file_format import Format

FOLDERS = (
    "jsonld",
    "turtle",
    "nquads",
    "urdf",
    "xacro",
    "srdf",
    "sdf",
    "mjcf",
    "collada",
    "usd",
    "yaml",
    "launch",
)
"""The packages of formats that have records, in the order in which formats are listed."""


def _records(folder: str) -> tuple[Format, ...]:
    """Return the records of the package *folder*, which is named at run time: it needs this."""
    found: tuple[Format, ...] = import_module(f"kinlint.formats.{folder}.format").FORMATS
    return found


FORMATS = tuple(each for folder in FOLDERS for each in _records(folder))
"""All formats."""

BY_NAME = {each.name: each for each in FORMATS}

BY_SUFFIX = {suffix: each for each in FORMATS for suffix in each.suffixes}

LONG = tuple(suffix for suffix in BY_SUFFIX if suffix.count(".") > 1 or suffix[0] != ".")
"""Ends of names that say more than the last part of a name."""

TREES = tuple(each for each in FORMATS if each.is_tree)
"""The formats whose files are trees of elements."""

GRAPHS = tuple(each for each in FORMATS if not each.is_tree)
"""The formats of composable models; rules that name the first of them hold for all."""


def spoken_of_as(form: Format) -> str:
    """Return the name by which rules, consumers and features speak of files of *form*.

    Macros count as what they expand to, and all formats of composable models as the first.
    """
    return form.lifted_as if form.is_tree else GRAPHS[0].name


LIFTED = tuple(each for each in TREES if each.expands_to is None and each.lifted)
"""The formats that have a schema, lifting queries and a profile of their own."""

ELEMENTS: tuple[str, ...] = tuple(each.namespace for each in FORMATS if each.namespace)
"""The namespaces of elements; their properties lead from an element to one within it."""

JSON = ".json"
"""The end of the names of files that may be JSON-LD: their content tells."""

SHARED = tuple(suffix for each in FORMATS for suffix in each.shared_suffixes)
"""The ends of the names of files that may be robots in XML: their root element tells."""

SEARCHED = (
    *(suffix for each in FORMATS if each.searched for suffix in each.suffixes),
    *SHARED,
    JSON,
)
"""The ends of the names of files that directories are searched for."""

TOLD = {suffix: each for each in FORMATS if each.robot_files for suffix in each.suffixes}
"""The formats of which directories are searched for robots alone, by the ends of names."""

GLOBBED = (*BY_SUFFIX, *SHARED, JSON)
"""The ends of the names of files that a glob may stand for."""


def by_suffix(name: str) -> Format | None:
    """Return the format that the end of the file *name* stands for, None if it tells nothing."""
    lower = name.lower()
    if lower.endswith(LONG):
        return BY_SUFFIX[next(each for each in LONG if lower.endswith(each))]
    return BY_SUFFIX.get(f".{lower.rpartition('.')[2]}")
