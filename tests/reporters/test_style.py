from __future__ import annotations

import io
from collections.abc import Mapping

import pytest

from kinlint.reporters.terminal_style import Style, When, detect_style


class Stream(io.StringIO):
    def __init__(self, *, terminal: bool, encoding: str = "utf-8") -> None:
        super().__init__()
        self.terminal = terminal
        self.code = encoding

    def isatty(self) -> bool:
        return self.terminal

    @property
    def encoding(self) -> str:  # type: ignore[override]
        return self.code


@pytest.mark.parametrize(
    ("terminal", "when", "environment", "colored"),
    [
        (True, "auto", {}, True),
        (False, "auto", {}, False),
        (True, "never", {"FORCE_COLOR": "1"}, False),
        (False, "always", {"NO_COLOR": "1"}, True),
        (True, "auto", {"NO_COLOR": "1"}, False),
        (True, "auto", {"NO_COLOR": ""}, True),
        (False, "auto", {"FORCE_COLOR": "1"}, True),
        (False, "auto", {"FORCE_COLOR": "0"}, False),
        (False, "auto", {"CLICOLOR_FORCE": "1"}, True),
        (False, "auto", {"CLICOLOR_FORCE": "0"}, False),
        (True, "auto", {"FORCE_COLOR": "1", "NO_COLOR": "1"}, False),
        (True, "auto", {"TERM": "dumb"}, False),
        (True, "auto", {"CLICOLOR": "0"}, False),
    ],
)
def test_colours_follow_the_option_then_the_environment_then_the_terminal(
    terminal: bool,  # noqa: FBT001
    when: When,
    environment: Mapping[str, str],
    colored: bool,  # noqa: FBT001
) -> None:
    style = detect_style(Stream(terminal=terminal), when, environment)
    assert style.color is colored
    assert style.links is (colored and terminal)


@pytest.mark.parametrize(
    ("encoding", "unicode"),
    [("utf-8", True), ("UTF8", True), ("ascii", False), ("latin-1", False), ("what", False)],
)
def test_only_a_utf_stream_shows_unicode(
    encoding: str,
    unicode: bool,  # noqa: FBT001
) -> None:
    assert detect_style(Stream(terminal=False, encoding=encoding), "auto", {}).unicode is unicode
    assert detect_style(io.StringIO(), "auto", {}).unicode


def test_a_plain_style_adds_nothing() -> None:
    assert Style().ink("x", "error") == "x"
    assert Style().link("x", "https://example.org") == "x"
