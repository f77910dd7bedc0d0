"""A server of a process of its own, and the bytes that are said to it and heard of it."""

from __future__ import annotations

import json
import subprocess
import threading
from collections import deque
from contextlib import suppress
from pathlib import Path
from typing import Any

from editor import KINLINT, PATIENCE


def framed(body: bytes) -> bytes:
    return b"Content-Length: %d\r\n\r\n%s" % (len(body), body)


class Wire:
    """A client that may say anything, and answers what it is asked with nothing."""

    def __init__(self, here: Path, options: object = None) -> None:
        self.here = here
        self.process = subprocess.Popen(
            [KINLINT, "server"],
            cwd=here,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
        )
        self.answers: dict[str, dict[str, Any]] = {}
        self.logged: deque[str] = deque(maxlen=100)
        self._news = threading.Condition()
        self._number = 0
        self._versions: dict[str, int] = {}
        self._listener = threading.Thread(target=self._listen, daemon=True)
        self._listener.start()
        self.ask(
            "initialize",
            processId=None,
            rootUri=here.as_uri(),
            initializationOptions=options,
            capabilities={
                "general": {"positionEncodings": ["utf-32"]},
                "textDocument": {"diagnostic": {}},
            },
        )
        self.tell("initialized")

    def say(self, content: bytes) -> None:
        """Say *content*, whatever it is."""
        assert self.process.stdin is not None
        self.process.stdin.write(content)
        self.process.stdin.flush()

    def send(self, message: dict[str, Any]) -> None:
        """Send *message* as the protocol has it."""
        self.say(framed(json.dumps({"jsonrpc": "2.0", **message}).encode()))

    def tell(self, method: str, **params: object) -> None:
        """Send a notification."""
        self.send({"method": method, "params": params})

    def request(self, method: str, **params: object) -> int:
        """Send a request, and return its number."""
        self._number += 1
        self.send({"id": self._number, "method": method, "params": params})
        return self._number

    def answer(self, number: object) -> dict[str, Any]:
        """Return the answer to the request *number*, which is forgotten then."""
        with self._news:
            key = str(number)
            came = self._news.wait_for(lambda: key in self.answers or self.gone, PATIENCE)
            assert came, f"no answer within {PATIENCE} s"
            assert key in self.answers, f"the server left with {self.process.poll()}"
            return self.answers.pop(key)

    def ask(self, method: str, **params: object) -> Any:
        """Return the result of a request."""
        found = self.answer(self.request(method, **params))
        assert "error" not in found, found
        return found["result"]

    def uri(self, name: str) -> str:
        return (self.here / name).as_uri()

    def open(self, name: str, text: str) -> None:
        self._versions[name] = 1
        item = {"uri": self.uri(name), "languageId": "xml", "version": 1, "text": text}
        self.tell("textDocument/didOpen", textDocument=item)

    def change(self, name: str, text: str) -> None:
        """Tell that the file called *name*, which is open, is *text* now."""
        self._versions[name] += 1
        which = {"uri": self.uri(name), "version": self._versions[name]}
        self.tell("textDocument/didChange", textDocument=which, contentChanges=[{"text": text}])

    def close(self, name: str) -> None:
        self.tell("textDocument/didClose", textDocument={"uri": self.uri(name)})

    def touched(self, *names: str) -> None:
        """Tell that files changed on disk."""
        changes = [{"uri": self.uri(name), "type": 2} for name in names]
        self.tell("workspace/didChangeWatchedFiles", changes=changes)

    def diagnostics(self, name: str) -> list[dict[str, Any]]:
        items: list[dict[str, Any]] = self.ask(
            "textDocument/diagnostic", textDocument={"uri": self.uri(name)}
        )["items"]
        return items

    @property
    def memory(self) -> int:
        """Return the resident memory of the server in pages."""
        path = Path(f"/proc/{self.process.pid}/statm")
        return int(path.read_text("ascii").split()[1])

    @property
    def gone(self) -> bool:
        return self.process.poll() is not None

    def leave(self) -> int:
        """Say good-bye; the exit code."""
        self.ask("shutdown")
        self.tell("exit")
        return self.process.wait(PATIENCE)

    def end(self) -> None:
        """End the server, if it has not ended, and all that is said to it and heard of it."""
        self.process.kill()
        self.process.wait()
        self._listener.join(PATIENCE)
        for stream in (self.process.stdin, self.process.stdout):
            assert stream is not None
            with suppress(OSError):
                stream.close()

    def _listen(self) -> None:
        out = self.process.stdout
        assert out is not None
        while head := out.readline():
            length = int(head.split(b":")[1])
            while out.readline().strip():
                pass
            message = json.loads(out.read(length))
            with self._news:
                self._hear(message)
                self._news.notify_all()
        with self._news:
            self._news.notify_all()

    def _hear(self, message: dict[str, Any]) -> None:
        if "method" not in message:
            self.answers[str(message.get("id"))] = message
        elif "id" in message:
            self.send({"id": message["id"], "result": None})
        elif message["method"] == "window/logMessage":
            self.logged.append(message["params"]["message"])
