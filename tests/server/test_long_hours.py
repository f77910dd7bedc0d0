"""A server over thousands of edits, and among clients that make no sense.

`KINLINT_SERVER_EDITS=10000 pytest -m slow tests/server/test_long_hours.py` edits that often.
"""

from __future__ import annotations

import json
import os
import random
import shutil
from pathlib import Path

import pytest
from incremental.random_edits import versions
from support.fixable_files import FILES
from wire import Wire, framed

from kinlint.cli.main import main

pytestmark = pytest.mark.slow

EDITS = int(os.environ.get("KINLINT_SERVER_EDITS", "200"))
EVERY = 10
"""Edits after which what the server tells is compared."""
GROWTH = 1.1
YAML = """controllers:
  ros__parameters:
    joints: [j, k]
joint_limits:
  j: {has_velocity_limits: true, max_velocity: 9.0}
"""
MJCF = """<mujoco>
  <worldbody>
    <body name="b"><joint name="j" range="1 -1" limited="true"/><geom size="0.1"/></body>
  </worldbody>
</mujoco>
"""
USD = """#usda 1.0
(
    metersPerUnit = 1
    upAxis = "Z"
)
def Xform "arm" (
    prepend apiSchemas = ["PhysicsRigidBodyAPI", "PhysicsMassAPI"]
)
{
    float physics:mass = -2
}
"""
COLLADA = """<COLLADA xmlns="http://www.collada.org/2008/03/COLLADASchema" version="1.5.0">
  <asset><unit meter="1"/><up_axis>Z_UP</up_axis></asset>
  <library_visual_scenes>
    <visual_scene id="v"><node id="n"><instance_node url="#gone"/></node></visual_scene>
  </library_visual_scenes>
</COLLADA>
"""
TEXTS = {**FILES, "yaml": YAML, "xml": MJCF, "usda": USD, "dae": COLLADA}
NAMES = {f"arm-{form}.{form}": text for form, text in TEXTS.items()}
NAMED = (".ttl", ".usda", ".dae")
"""Suffixes of files that walks pass over."""
PLACED = (
    *("definition", "references", "hover", "documentHighlight", "codeAction", "completion"),
    *("documentSymbol", "codeLens", "documentLink", "diagnostic", "rename", "declaration"),
)
"""Requests about a place in a text, some of which the server does not know."""


@pytest.fixture
def here(tmp_path, rules_cache):
    folder = tmp_path / "opened" / "robots"
    folder.mkdir(parents=True)
    for name, text in NAMES.items():
        (folder / name).write_text(text, "utf-8")
    return folder


@pytest.fixture
def wire(here):
    connected = Wire(here)
    for name, text in NAMES.items():
        connected.open(name, text)
    yield connected
    connected.end()


def _ends(diagnostic):
    """The ends that are compared: what cannot be read has none for the command."""
    return ("start", "end") if diagnostic.get("code") else ("start", "start")


def told(wire, name):
    """What the server tells of a file: codes, places and the first lines of messages."""
    return sorted(
        (
            one.get("code", ""),
            *(one["range"][end][unit] for end in _ends(one) for unit in ("line", "character")),
            one["message"].partition("\n")[0],
        )
        for one in wire.diagnostics(name)
    )


def told_of_all(wire):
    """What the server tells of each file; something of each."""
    answer = {name: told(wire, name) for name in NAMES}
    assert all(answer.values())
    return answer


def found(texts, folder, capsys, monkeypatch):
    """What the command finds in *texts*, by file."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for name, text in texts.items():
        (folder / name).write_text(text, "utf-8", newline="")
    capsys.readouterr()
    monkeypatch.chdir(folder)
    named = [name for name in texts if name.endswith(NAMED)]
    main(["--isolated", "--no-cache", "--output-format", "json", ".", *named])
    answer = {name: [] for name in texts}
    for one in json.loads(capsys.readouterr().out):
        ends = [one["location"], one["end_location"] or one["location"]]
        place = [end[unit] - 1 for end in ends for unit in ("row", "column")]
        message = one["message"].partition("\n")[0]
        code = one["code"] if one["name"] != "unreadable-file" else ""
        answer[Path(one["filename"]).name].append((code or "", *place, message))
    return {name: sorted(each) for name, each in answer.items()}


def test_edits(wire, tmp_path, monkeypatch, capsys):
    """The server tells what the command finds, and its memory does not grow."""
    texts = dict(NAMES)
    edits = {
        name: versions(text, list(NAMES.values())[number : number + 1], number, EDITS)
        for number, (name, text) in enumerate(NAMES.items())
    }
    rng = random.Random(EDITS)  # noqa: S311  nothing is secret
    memory = []
    for number in range(EDITS):
        name = rng.choice(sorted(NAMES))
        texts[name] = next(edits[name])
        wire.change(name, texts[name])
        if number % 3:
            wire.request("textDocument/codeLens", textDocument={"uri": wire.uri(name)})
        if number % EVERY == 0:
            expected = found(texts, tmp_path / "alone" / "robots", capsys, monkeypatch)
            assert {name: told(wire, name) for name in texts} == expected, number
        if number % max(1, EDITS // 10) == 0:
            for each, text in NAMES.items():
                wire.change(each, text)
                wire.diagnostics(each)
                wire.change(each, texts[each])
            memory.append(wire.memory)
    assert max(memory[-3:]) < GROWTH * max(memory[1:4]), memory
    assert not wire.logged
    assert wire.leave() == 0


def test_requests_that_are_cancelled_at_once(wire):
    """In storms, while texts change; what is asked afterwards is answered as ever."""
    before = told_of_all(wire)
    rng = random.Random(EDITS)  # noqa: S311  nothing is secret
    asked = []
    for number in range(EDITS):
        name = rng.choice(sorted(NAMES))
        if number % 5 == 0:
            wire.change(name, NAMES[name] + " " * (number % 7))
        method = f"textDocument/{rng.choice(PLACED[:5])}"
        asked.append(wire.request(method, **_place(wire, name, rng)))
        for each in rng.sample(asked[-20:], min(len(asked), 2)):
            wire.tell("$/cancelRequest", id=each)
    wire.tell("$/cancelRequest", id="nobody")
    for name, text in NAMES.items():
        wire.change(name, text)
    assert told_of_all(wire) == before
    answers = [wire.answer(number) for number in asked]
    assert {each["error"]["code"] for each in answers if "error" in each} <= {-32800}
    assert sum("error" not in each for each in answers) > 0
    assert not wire.answers
    assert not wire.logged
    assert wire.leave() == 0


def _place(wire, name, rng):
    place = {"line": rng.randrange(-1, 9), "character": rng.randrange(-1, 200)}
    place = {unit: max(0, value) for unit, value in place.items()}
    return {
        "textDocument": {"uri": wire.uri(name)},
        "position": place,
        "range": {"start": place, "end": place},
        "context": {"includeDeclaration": True, "diagnostics": []},
    }


STRANGE = (
    *(None, True, -1, 2**31, 2**64, 1.5, "", "x", "\ud800", "file://", "file:///\0", "untitled:1"),
    *("file:///nowhere/else.urdf", "http://[", [], [[]], {}, {"uri": 1}, {"line": -1}),
)


def _distorted(value, rng):
    """Return *value* with something in it replaced, removed or repeated."""
    if rng.random() < 0.2 or not isinstance(value, dict | list) or not value:
        return rng.choice(STRANGE)
    changed = dict(value) if isinstance(value, dict) else list(value)
    key = rng.choice(sorted(changed)) if isinstance(changed, dict) else rng.randrange(len(changed))
    if rng.random() < 0.2:
        del changed[key]
    else:
        changed[key] = _distorted(changed[key], rng)
    return changed


def test_messages_that_make_no_sense(wire):
    """Whatever parameters have: requests are answered, and the server goes on."""
    rng = random.Random(EDITS)  # noqa: S311  nothing is secret
    asked = []
    for number in range(EDITS):
        name = rng.choice(sorted(NAMES))
        params = _place(wire, name, rng)
        told_of = {
            "didOpen": {"uri": wire.uri(name), "languageId": "xml", "version": 1, "text": "<a/>"},
            "didChange": {"uri": wire.uri(name), "version": number},
            "didSave": {"uri": wire.uri(name)},
        }
        if number % 4 == 0:
            method = rng.choice(sorted(told_of))
            params = {
                "textDocument": told_of[method],
                "contentChanges": [{"range": params["range"], "text": "x"}, {"text": "<a/>"}],
            }
            wire.send({"method": f"textDocument/{method}", "params": _distorted(params, rng)})
            continue
        message = {
            "id": f"n{number}",
            "method": f"textDocument/{rng.choice(PLACED)}",
            "params": _distorted(params, rng),
        }
        wire.send(message)
        asked.append(message["id"])
    others = {
        "executeCommand": {"command": "kinlint.applyAutofix", "arguments": [{"uri": "file:///x"}]},
        "didChangeConfiguration": {"settings": {"kinlint": {"select": ["ALL"]}}},
        "didChangeWatchedFiles": {"changes": [{"uri": "file:///x", "type": 2}]},
    }
    for number in range(EDITS // 10):
        for method, params in others.items():
            message = {"method": f"workspace/{method}", "params": _distorted(params, rng)}
            wire.send({"id": f"c{number}", **message} if "execute" in method else message)
        asked.append(f"c{number}")
    for each in asked:
        wire.answer(each)
    name = "arm-urdf.urdf"
    wire.tell("workspace/didChangeConfiguration", settings={"kinlint": {}})
    wire.open(name, NAMES[name])
    assert "LIM001" in {one.get("code") for one in wire.diagnostics(name)}
    assert not [each for each in wire.logged if "kinlint/" in each.partition("lsprotocol")[0]]
    assert wire.leave() == 0


@pytest.mark.parametrize(
    "said",
    [
        framed(b"{"), framed(b"[]"), framed(b"null"), framed(b"\xff\xfe"), framed(b"{}"),
        framed(b'{"jsonrpc": "2.0"}'), framed(b'{"jsonrpc": "1.0", "id": 5, "method": "shutdown"}'),
        framed(b'{"jsonrpc": "2.0", "id": {}, "method": "workspace/strange"}'),
        framed(b'{"jsonrpc": "2.0", "id": 77, "result": null}'),
        framed(b'{"jsonrpc": "2.0", "id": 77, "error": 5}'),
        framed(b"[" * 100_000), b"Content-Type: x\r\n" + framed(b"{}"),
    ],
    ids=range(12),
)  # fmt: skip
def test_bytes_that_are_no_message(wire, said):
    """The next message is heard as ever."""
    wire.say(said)
    assert "LIM001" in {one.get("code") for one in wire.diagnostics("arm-urdf.urdf")}
    assert wire.leave() == 0


def test_files_that_vanish(wire):
    """Files, and the folder itself, with and without a word; what is open stays."""
    before = told_of_all(wire)
    rng = random.Random(EDITS)  # noqa: S311  nothing is secret
    for number in range(max(20, EDITS // 10)):
        name = rng.choice(sorted(NAMES))
        act = number % 5
        if act == 0:
            (wire.here / name).unlink(missing_ok=True)
        elif act == 1:
            wire.close(name)
        elif act == 2:
            shutil.rmtree(wire.here, ignore_errors=True)
        else:
            wire.here.mkdir(exist_ok=True)
            (wire.here / name).write_text(NAMES[name], "utf-8")
        if number % 3:
            wire.touched(name)
        wire.ask("textDocument/definition", **_place(wire, name, rng))
        wire.ask("workspace/diagnostic", previousResultIds=[])
        if act == 1:
            wire.open(name, NAMES[name])
    assert told_of_all(wire) == before
    assert not wire.logged
    assert wire.leave() == 0
