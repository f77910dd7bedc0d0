"""Commands that users of editors call by name."""

from __future__ import annotations

import platform
from collections.abc import Iterator, Mapping
from functools import partial
from importlib.metadata import version
from typing import Any

from lsprotocol import types

from kinlint import __version__
from kinlint.facts.robot_structures import structures
from kinlint.findings.locator import Locator
from kinlint.light_dataclasses import replace
from kinlint.reporters.picture import svg
from kinlint.reporters.picture.finding_badges import Marks, marks
from kinlint.reporters.picture.mermaid import lines
from kinlint.reporters.rule_page import brief, markdown
from kinlint.reporters.terminal_style import Style
from kinlint.server.app import KinlintServer
from kinlint.server.code_actions import FIX_ALL, fix_all
from kinlint.server.request_context import RequestContext
from kinlint.structure import Structure


def register(server: KinlintServer) -> None:
    """Add the commands; each takes a URI, or an object that has one as `uri`."""

    @server.command("kinlint.applyAutofix")
    async def apply_autofix(*arguments: Any) -> bool:
        """Make all safe fixes of a file; whether any was made."""
        action = types.CodeAction(
            "kinlint: Make all safe fixes", FIX_ALL, data={"uri": _uri(arguments)}
        )
        edit = (await fix_all(server, action)).edit
        if edit is None:
            return False
        applied = await server.workspace_apply_edit_async(
            types.ApplyWorkspaceEditParams(edit, action.title)
        )
        return applied.applied

    @server.command("kinlint.printDebugInformation")
    def print_debug_information(*_arguments: Any) -> str:
        """Return the state of the server for a bug report, and log it."""
        page = "\n".join(_state(server))
        server.log(page, types.MessageType.Info)
        return page

    @server.command("kinlint.showGraph")
    async def show_graph(*arguments: Any) -> str | None:
        """The robot of a file as a Mermaid flowchart; None if it has none."""
        return await server.consult(_uri(arguments), _graph)

    @server.command("kinlint.showRobot")
    async def show_robot(*arguments: Any) -> str | None:
        """The robot of a file as a picture in SVG, with what was found; None if it has none."""
        return await server.consult(_uri(arguments), _picture)

    @server.command("kinlint.showRobotPage")
    async def show_robot_page(*arguments: Any) -> str | None:
        """The robot of a file, with its findings, as a page of HTML; None if it has none.

        A second argument names the theme, `dark` or `light`.
        """
        theme = str(arguments[1]) if len(arguments) > 1 else ""
        return await server.consult(_uri(arguments), partial(_page, theme=theme))

    @server.command("kinlint.showRulePage")
    async def show_rule_page(*arguments: Any) -> str | None:
        """The page in Markdown of the rule with the code in the second argument; None if none has.

        The first names a file of the project whose rules may have it.
        """
        code = str(arguments[1]) if len(arguments) > 1 else ""
        return await server.consult(_uri(arguments), partial(_rule_page, code=code))


def _uri(arguments: tuple[Any, ...]) -> str:
    """The URI in *arguments*, which clients send in several forms."""
    first = arguments[0] if arguments else ""
    for name in ("uri", "textDocument"):
        if isinstance(first, Mapping) and name in first:
            first = first[name]
    return str(first)


def _graph(view: RequestContext) -> str | None:
    return "\n\n".join("\n".join(lines(one, found)) for one, found in _robots(view)) or None


def _picture(view: RequestContext) -> str | None:
    robots = _robots(view)
    return "".join(svg.document(robots)) if robots else None


def _page(view: RequestContext, theme: str) -> str | None:
    from kinlint.reporters.html.page import THEMES, render  # noqa: PLC0415  few ask for pages

    robots = tuple(structure for structure, _ in _robots(view))
    report = replace(view.examination.report, structures=robots)
    return (
        "".join(render(report, Style(), theme=theme if theme in THEMES else "")) if robots else None
    )


def _rule_page(view: RequestContext, code: str) -> str | None:
    rule = view.rulebook.by_code.get(code)
    return None if rule is None else markdown(brief(rule))


def _robots(view: RequestContext) -> list[tuple[Structure, Marks]]:
    """Return the robots of a file, or else those of its model, with what was found of each."""
    examination = view.examination
    found = examination.report.findings
    locator = Locator(examination.documents, examination.store)
    drawn = structures(examination.store, locator, found, placed=True)
    own = [one for one in drawn if view.source.name in one.files] or drawn
    return [(one, marks(one, found)) for one in own]


def _state(server: KinlintServer) -> Iterator[str]:
    yield f"kinlint {__version__}, Python {platform.python_version()}, {platform.platform()}"
    yield f"pygls {version('pygls')}, lsprotocol {version('lsprotocol')}"
    yield f"positions in {server.encoding}"
    yield from (f"folder: {root}" for root in server.roots)
    yield from (f"open: {one.uri}, version {one.version}" for one in server.buffers)
    yield f"settings: {server.preferences}"
    told = sum(bool(server.diagnostics(path).items) for path in server.told)
    yield f"files with diagnostics: {told} of {len(server.told)}"
