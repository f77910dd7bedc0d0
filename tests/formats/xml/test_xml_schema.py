"""The tables of the formats are read, and values are what they say."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from kinlint.file_format import Format
from kinlint.formats.records import LIFTED
from kinlint.formats.xml.element_types import version
from kinlint.formats.xml.schema import schema
from kinlint.formats.xml.value_reading import Form, value_reader
from kinlint.terms import literal_value


@pytest.mark.parametrize("form", ["urdf", "srdf", "sdf"])
def test_a_schema_is_linked_and_loaded_once(form: str) -> None:
    found = schema(form)
    assert schema(form) is found
    assert found.roots
    for types in found.types.values():
        for each in types:
            assert each.once <= each.children.keys()
            assert each.children.keys() >= {*each.requires, *each.expects, *each.assumed}
            assert each.attributes.keys() >= {*each.required, *each.lifetimes}
            assert all(tag == child.tag for tag, child in each.children.items())
            lives = [*each.lifetimes.values(), *([each.lifetime] if each.lifetime else [])]
            assert all(version(life.since or life.until or "") for life in lives)


def test_every_type_is_reached_from_a_root() -> None:
    for form in ("urdf", "srdf", "sdf"):
        found = schema(form)
        waiting, seen = list(found.roots.values()), set()
        while waiting:
            each = waiting.pop()
            if id(each) not in seen:
                seen.add(id(each))
                waiting += each.children.values()
        lost = [
            each.tag for types in found.types.values() for each in types if id(each) not in seen
        ]
        assert lost == []


@pytest.mark.parametrize("form", LIFTED, ids=lambda form: form.name)
def test_what_a_schema_refers_to_is_there(form: Format) -> None:
    """Attributes with references, files and choices are declared, and so is what they may name."""
    found = schema(form.name)
    known = {(each.namespace, tag) for each in LIFTED for tag in schema(each.name).types}
    assert found.names or form.fence != "xml"
    for each in (type_ for types in found.types.values() for type_ in types):
        places = {slot.predicate for slot in (*each.attributes.values(), each.content) if slot}
        assert places >= {*each.references, *each.files}
        named = [name for name in each.choices if "*" not in name]  # "*" is any instance
        assert all(name in each.attributes if name else each.content for name in named)
        assert known >= {end for one in each.references.values() for end in one.targets}
        assert {tag for _, tag in known} >= set(each.scope)


@pytest.mark.parametrize(
    ("kinds", "infinite", "written", "value"),
    [
        (("text",), False, " a ", " a "),
        (("text",), False, "$5", "$5"),
        (("text",), False, "${a}", None),
        (("number",), False, " 1.50 ", "1.50"),
        (("number",), False, "-.5e-3", "-.5e-3"),
        (("number",), False, "1.", "1."),
        (("number",), False, "0x1", None),
        (("number",), False, "1 2", None),
        (("number",), False, "", None),
        (("number",), False, "1_0", None),
        (("number",), False, "\u0661", None),
        (("number",), False, "inf", None),
        (("number",), False, "1e999", None),
        (("number",), False, "1e-999", "1e-999"),
        (("number",), True, "1e999", None),
        (("number",), True, "-Inf", "-INF"),
        (("number",), True, "nan", None),
        (("integer",), False, "+3", "+3"),
        (("integer",), False, "0x1F", "31"),
        (("integer",), False, "3.0", "3"),
        (("integer",), False, "3u", "3"),
        (("integer",), False, "3.5", None),
        (("boolean",), False, "TRUE", "true"),
        (("boolean",), False, "0", "0"),
        (("boolean",), False, "yes", None),
        (("vector3",), False, "1 2\t3", ("1", "2", "3")),
        (("vector3",), False, "1 2", None),
        (("vector3", "vector4"), False, "1 2 3 4", ("1", "2", "3", "4")),
        (("vectors",), False, "1", ("1",)),
        (("vectors",), False, " ", None),
    ],
)
def test_a_value_is_of_its_kind_or_none(
    kinds: tuple[str, ...], *, infinite: bool, written: str, value: str | tuple[str, ...] | None
) -> None:
    found = value_reader(Form(kinds, infinite))[written]
    if isinstance(found, tuple):
        assert tuple(map(literal_value, found)) == value
    else:
        assert (None if found is None else literal_value(found)) == value


@pytest.mark.parametrize(
    ("written", "value", "reason"),
    [
        ("0", "0", ""),
        ("2", "2", ""),
        ("-0.1", None, "-0.1 is out of range"),
        ("2.1", None, "2.1 is out of range"),
        ("-inf", None, "-inf is not finite"),
        ("1e999", None, "1e999 is too large for a double"),
    ],
)
def test_a_number_is_in_its_range(written: str, value: str | None, reason: str) -> None:
    reader = value_reader(Form(("number",), least=0, greatest=2))
    found = reader[written]

    assert reader.expected == "number from 0 to 2"
    assert (None if found is None else literal_value(found)) == value
    assert value is not None or reader.reason(written) == reason


def test_an_infinite_number_is_in_its_range() -> None:
    reader = value_reader(Form(("number",), infinite=True, least=0))

    assert reader.expected == "number from 0"
    assert reader["inf"] is not None
    assert reader["-inf"] is None


@pytest.mark.parametrize(
    ("kinds", "written", "reason"),
    [
        (("number",), "1,5", "decimal comma in 1,5"),
        (("vector3",), "1,0, 2,0, 3,0", "decimal comma in 1,0,"),
        (("vector3",), "1 2 x", "'x' is not a number"),
        (("number",), "1e999", "1e999 is too large for a double"),
        (("vector3",), "1 2", "2 numbers"),
        (("vector3",), "", "empty"),
        (("boolean",), "yes", "not true or false"),
        (("integer",), "1.5", "not a whole number"),
        (("integer",), " ", "empty"),
    ],
)
def test_a_wrong_value_has_a_reason(kinds: tuple[str, ...], written: str, reason: str) -> None:
    assert value_reader(Form(kinds)).reason(written) == reason


def test_reading_a_robot_imports_no_other_front_end(tmp_path: Path) -> None:
    path = tmp_path / "arm.urdf"
    path.write_text("<robot name='a'/>")
    code = (
        "import sys; from kinlint.formats.registry import read, decode;"
        "from kinlint.formats.options import ReadOptions;"
        f"read(decode('arm.urdf', open({str(path)!r}, 'rb').read()), ReadOptions());"
        "others = {f'kinlint.formats.{each}.reader' for each in ('jsonld', 'xacro', 'sdf')};"
        "wrong = {'pyld', 'rdflib', 'pyshacl', *others};"
        "sys.exit(len(wrong & set(sys.modules)))"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_reading_json_ld_imports_nothing_of_xml(tmp_path: Path) -> None:
    path = tmp_path / "arm.jsonld"
    path.write_text("{}")
    code = (
        "import sys; from kinlint.formats.registry import read, decode;"
        "from kinlint.formats.options import ReadOptions;"
        f"read(decode('arm.jsonld', open({str(path)!r}, 'rb').read()), ReadOptions());"
        "sys.exit(any('formats.xml' in name or 'expat' in name for name in sys.modules))"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
