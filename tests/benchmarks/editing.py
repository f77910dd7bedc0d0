"""Times a keystroke in an editor: from the change that it sends to the diagnostics that it gets."""

from __future__ import annotations

import json
import os
import subprocess
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import count, cycle
from pathlib import Path
from typing import Any, Self

from benchmarks.keystrokes import strokes
from benchmarks.processes import KINLINT, Workplace
from benchmarks.table import Row
from benchmarks.timing import interleaved

SHARE = 0.1
"""A keystroke takes at most this part of a whole process."""
TOLD = "textDocument/publishDiagnostics"


def rows(place: Workplace, runs: int, wanted: str = "") -> Iterator[Row]:
    """A row for each keystroke, against a process that lints the file as it is then.

    The titles have *wanted*.
    """
    for stroke in strokes("typed in an editor", wanted):
        with Editor(place, stroke.name, stroke.text, stroke.at) as editor:
            editor.press()
            ours, theirs = interleaved([editor.press, editor.lint], 2 * runs)
        yield Row(stroke.title, "`kinlint` on that file", (ours, theirs), target=SHARE)


@dataclass
class Editor:
    """A file that is open in a server, and into which somebody types `at` an offset."""

    place: Workplace
    name: str
    text: str
    at: int
    _versions: Iterator[int] = field(default_factory=lambda: count(2))

    def __enter__(self) -> Self:
        self._changes = cycle(self._both())
        self._server = subprocess.Popen(
            [KINLINT, "server"],
            cwd=self.place.directory,
            env=self.place.environment,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
        )
        hello = {"processId": os.getpid(), "capabilities": {}, "rootUri": None}
        self._say("initialize", hello, number=1)
        while self._hear().get("id") != 1:
            pass
        self._say("initialized", {})
        document = {"uri": self.path.as_uri(), "languageId": "", "version": 1, "text": self.text}
        self._say("textDocument/didOpen", {"textDocument": document})
        self._wait(1)
        return self

    def __exit__(self, *_error: object) -> None:
        self._server.kill()
        self._server.communicate()

    @property
    def path(self) -> Path:
        """The file."""
        return self.place.directory / self.name

    def press(self) -> None:
        """Type a character, or delete it again, and wait for what the server says of the text."""
        change, self.text = next(self._changes)
        version = next(self._versions)
        document = {"uri": self.path.as_uri(), "version": version}
        self._say("textDocument/didChange", {"textDocument": document, "contentChanges": [change]})
        self._wait(version)

    def lint(self) -> None:
        """Lint the file, which holds what was typed, in a process that recalls nothing of it."""
        self.path.write_text(self.text, "utf-8")
        recalled = self.place.directory / "cache"
        for kept in recalled.rglob("*"):
            if kept.is_file() and not kept.name.startswith("catalogue-"):
                kept.unlink()
        self.place.run([KINLINT, "--output-format=concise", self.name])

    def _both(self) -> Sequence[tuple[dict[str, Any], str]]:
        """The changes that type a character and delete it, each with the text then."""
        at = self.at
        line = self.text.count("\n", 0, at)
        column = at - self.text.rfind("\n", 0, at) - 1
        here, behind = ({"line": line, "character": column + more} for more in (0, 1))
        typed = f"{self.text[:at]}1{self.text[at:]}"
        return (
            ({"range": {"start": here, "end": here}, "text": "1"}, typed),
            ({"range": {"start": here, "end": behind}, "text": ""}, self.text),
        )

    def _wait(self, version: int) -> None:
        """Wait for the diagnostics of the text that has *version*."""
        while True:
            heard = self._hear()
            if heard.get("method") == TOLD and heard["params"].get("version") == version:
                return

    def _say(self, method: str, params: Any, number: int | None = None) -> None:
        assert self._server.stdin is not None
        message = {"jsonrpc": "2.0", "method": method, "params": params}
        body = json.dumps(message if number is None else {**message, "id": number}).encode()
        self._server.stdin.write(b"Content-Length: %d\r\n\r\n%s" % (len(body), body))
        self._server.stdin.flush()

    def _hear(self) -> dict[str, Any]:
        """The next message of the server. Raises `RuntimeError` if it ended."""
        assert self._server.stdout is not None
        length = 0
        while line := self._server.stdout.readline().strip():
            name, _, value = line.partition(b":")
            length = int(value) if name.lower() == b"content-length" else length
        if not length:
            raise RuntimeError("the server ended")
        heard: dict[str, Any] = json.loads(self._server.stdout.read(length))
        return heard
