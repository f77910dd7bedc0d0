"""Documents of COLLADA for tests, and what is stated of them."""

from __future__ import annotations

from support.linting import document

from kinlint.document import Document
from kinlint.terms import literal_value

HEAD = '<COLLADA xmlns="http://www.collada.org/2008/03/COLLADASchema" version="1.5.0">'


def read(*content: str, unit: str = '<unit name="meter" meter="1"/>') -> Document:
    """Return the document with *content* below an asset with *unit*."""
    asset = f"<asset>{unit}<up_axis>Z_UP</up_axis></asset>"
    return document(f"{HEAD}{asset}{''.join(content)}</COLLADA>", "arm.dae")


def model(*content: str, joints: str = "") -> str:
    """Return libraries with a model 'arm' of *content*, and with *joints*."""
    return (
        f"<library_joints>{joints}</library_joints>"
        '<library_kinematics_models><kinematics_model id="arm" name="arm"><technique_common>'
        f"{''.join(content)}"
        "</technique_common></kinematics_model></library_kinematics_models>"
    )


def derived(read_: Document, name: str) -> dict[str, float | str]:
    """Return the last part of the subjects of the property *name*, with the values."""
    found: dict[str, float | str] = {}
    for subject, predicate, value in read_.statements:
        if predicate.endswith(f"/source#{name}>"):
            text = literal_value(value) if value.startswith('"') else value[1:-1].split("#/")[-1]
            number = text.lstrip("-")[:1].isdigit()
            found[subject[1:-1].split("#/")[-1]] = float(text) if number else text
    return found
