"""Text drawn by rich: loaded only for tables and pages on a terminal."""

from __future__ import annotations

import io

from rich.console import Console, RenderableType

from kinlint.reporters.terminal_style import Style


def rich_text(thing: RenderableType, style: Style) -> str:
    """Render *thing* as text with escape sequences, whatever the environment says."""
    out = io.StringIO()
    console = Console(
        file=out,
        force_terminal=True,
        color_system="standard",
        width=style.width,
        legacy_windows=False,
        _environ={},
    )
    console.print(thing)
    return out.getvalue()
