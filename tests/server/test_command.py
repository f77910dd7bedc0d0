"""The command itself: how it begins and ends, and what it writes."""

import json
import subprocess

import pytest
from editor import KINLINT

HELLO = {"id": 1, "method": "initialize", "params": {"processId": None, "capabilities": {}}}
DOWN = {"id": 2, "method": "shutdown"}
LEAVE = {"method": "exit"}
PLACE = {
    "textDocument": {"uri": "file:///nowhere.urdf"},
    "position": {"line": 0, "character": 0},
}


def framed(*messages):
    bodies = [json.dumps({"jsonrpc": "2.0", **each}).encode() for each in messages]
    return b"".join(b"Content-Length: %d\r\n\r\n%s" % (len(body), body) for body in bodies)


def answers(out):
    """The messages in *out*, which holds nothing else."""
    found = []
    while out:
        head, _, rest = out.partition(b"\r\n\r\n")
        fields = dict(line.split(b": ", 1) for line in head.split(b"\r\n"))
        length = int(fields[b"Content-Length"])
        found.append(json.loads(rest[:length]))
        out = rest[length:]
    return found


@pytest.fixture
def serve(tmp_path, rules_cache):
    def run(said, *options):
        command = [KINLINT, "server", *options]
        return subprocess.run(
            command, input=said, cwd=tmp_path, capture_output=True, timeout=600, check=False
        )

    return run


@pytest.mark.slow
@pytest.mark.parametrize("options", [(), ("--stdio",)])
def test_a_polite_client(serve, options):
    """Standard output has messages only, and the exit code is 0."""
    done = serve(framed(HELLO, {"method": "initialized", "params": {}}, DOWN, LEAVE), *options)

    said = {each.get("id"): each for each in answers(done.stdout)}
    assert said[1]["result"]["serverInfo"]["name"] == "kinlint"
    assert said[1]["result"]["capabilities"]["positionEncoding"] == "utf-16"
    assert said[2]["result"] is None
    assert done.returncode == 0


@pytest.mark.slow
@pytest.mark.parametrize("said", [b"", framed(HELLO), framed(HELLO, LEAVE), b"what?\r\n\r\n"])
def test_a_client_that_goes_without_a_word(serve, said):
    """The server goes, too."""
    assert serve(said).returncode == 1


@pytest.mark.slow
def test_messages_that_make_no_sense_are_answered(serve):
    """With an error, and the next one as ever."""
    strange = {"id": 7, "method": "textDocument/strange", "params": {}}
    wrong = {"method": "textDocument/didChange", "params": {"textDocument": {}}}
    unopened = {
        "method": "textDocument/didChange",
        "params": {
            "textDocument": {"uri": "file:///nowhere.urdf", "version": 2},
            "contentChanges": [{"text": ""}],
        },
    }
    formless = {"id": 8, "method": "textDocument/hover", "params": {"textDocument": 1}}
    late = {"id": 9, "method": "textDocument/hover", "params": PLACE}
    done = serve(framed(HELLO, strange, wrong, unopened, formless, DOWN, late, LEAVE))

    said = {each.get("id"): each for each in answers(done.stdout)}
    assert said[7]["error"]["code"] == -32601
    assert said[8]["error"]["code"] == -32602
    assert said[9]["error"]["code"] == -32600
    assert said[2]["result"] is None
    assert done.returncode == 0


def test_help_and_wrong_options(serve):
    """As for the other commands."""
    assert b"--tcp PORT" in serve(b"", "--help").stdout
    wrong = serve(b"", "--udp")
    assert wrong.returncode == 2
    assert b"unknown option '--udp'" in wrong.stderr
