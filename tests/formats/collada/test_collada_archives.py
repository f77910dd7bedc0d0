"""Documents of COLLADA in archives: found by the manifest, read with their own lines, bounded."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Mapping

import pytest
from reading_collada import model
from support.linting import lint

from kinlint.edits import NotExpressible
from kinlint.errors import SourceError
from kinlint.formats import archive_members
from kinlint.formats.collada import archive
from kinlint.formats.decoding import decode, encode

JOINT = '<joint id="j" sid="j" name="j"><revolute sid="a"><axis>0 2 0</axis></revolute></joint>'
LINKS = '<link sid="base"><attachment_full joint="j"><link sid="tip"/></attachment_full></link>'
ROBOT = (
    '<COLLADA xmlns="http://www.collada.org/2008/03/COLLADASchema" version="1.5.0">\n'
    '<asset><unit name="meter" meter="1"/><up_axis>Z_UP</up_axis></asset>\n'
    f"{model(LINKS, joints=JOINT)}\n</COLLADA>"
)


def packed(members: Mapping[str, str | bytes]) -> bytes:
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as made:
        for name, content in members.items():
            made.writestr(name, content)
    return stream.getvalue()


def manifest(root: str) -> str:
    return f'<?xml version="1.0"?>\n<dae_root xmlns="http://www.collada.org/">{root}</dae_root>'


@pytest.mark.parametrize(
    "members",
    [
        {"manifest.xml": manifest("./arm%201/arm.dae#scene"), "arm 1/arm.dae": ROBOT},
        {"manifest.xml": manifest("arm.dae"), "arm.dae": ROBOT, "other.dae": "<COLLADA/>"},
        {"meshes/arm.dae": ROBOT, "textures/red.png": b"\x89PNG"},
    ],
)
def test_findings_are_at_the_lines_of_the_document(members: dict[str, str | bytes]) -> None:
    report = lint([decode("arm.zae", packed(members))])
    places = [(each.location.start.line, each.rule.code) for each in report.findings]
    assert places == [(1, "TOP034"), (3, "FRM009")]
    assert not report.findings[0].fixes


def test_an_archive_is_never_written() -> None:
    with pytest.raises(NotExpressible):
        encode(decode("arm.zae", packed({"arm.dae": ROBOT})))


@pytest.mark.parametrize(
    ("data", "cause"),
    [
        (b"", "not a readable zip archive"),
        (b"<COLLADA/>", "not a readable zip archive"),
        (packed({"arm.dae": ROBOT})[:-40], "not a readable zip archive"),
        (packed({"a.png": b""}), "no document"),
        (packed({"a.dae": ROBOT, "b.dae": ROBOT}), "2 documents"),
        (packed({"manifest.xml": "<a/>", "a.dae": ROBOT}), "no <dae_root>"),
        (packed({"manifest.xml": manifest("b.dae"), "a.dae": ROBOT}), "which is not there"),
        (packed({"manifest.xml": manifest("../a.dae"), "a.dae": ROBOT}), "leads out"),
        (packed({"manifest.xml": manifest("/a.dae"), "a.dae": ROBOT}), "leads out"),
        (packed({"manifest.xml": manifest("file:/a.dae"), "a.dae": ROBOT}), "leads out"),
        (packed({"a.dae": ROBOT, "../../a.sh": ""}), "leads out"),
    ],
    ids=range(11),  # archives have the time in them, and all processes of a run need the same ids
)
def test_what_is_no_archive_with_a_document_is_told(data: bytes, cause: str) -> None:
    with pytest.raises(SourceError, match=cause) as raised:
        decode("arm.zae", data)
    assert (raised.value.line, raised.value.column) == (1, 1)


def test_no_more_is_unpacked_than_a_document_may_have(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(archive, "LARGEST_DOCUMENT", len(ROBOT))
    assert decode("arm.zae", packed({"arm.dae": ROBOT})).text == ROBOT
    with pytest.raises(SourceError, match="unpacks to more"):
        decode("arm.zae", packed({"arm.dae": f"{ROBOT} "}))


def test_archives_of_countless_files_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(archive_members, "MOST_MEMBERS", 1)
    with pytest.raises(SourceError, match="more than 1 files"):
        decode("arm.zae", packed({"arm.dae": ROBOT, "b.png": b""}))


def test_external_entities_are_refused() -> None:
    text = f'<!DOCTYPE COLLADA [<!ENTITY x SYSTEM "file:///etc/passwd">]>\n{ROBOT}'
    report = lint([decode("arm.zae", packed({"arm.dae": text}))])
    assert report.errors
