"""The page: what the run amounts to, pictures, tables, findings and the rules behind them."""

from __future__ import annotations

import base64
import hashlib
from collections.abc import Iterator
from pathlib import Path

from kinlint.report import Report
from kinlint.reporters.html.articles import Articles
from kinlint.reporters.html.robot_pictures import RobotPictures
from kinlint.reporters.html.rules import rules
from kinlint.reporters.html.tables import tables
from kinlint.reporters.picture import svg
from kinlint.reporters.picture.escape import element, text
from kinlint.reporters.picture.finding_badges import sign
from kinlint.reporters.picture.stick_figure import figure_svg
from kinlint.reporters.summary import plural, verdict
from kinlint.reporters.terminal_style import Style
from kinlint.rule import Severity

HERE = Path(__file__).parent


DARK = "@media screen and (prefers-color-scheme: dark)"
"""Media query of the style rules of the dark theme."""
THEMES = {"dark": "@media screen", "light": "@media not all", "": DARK}
"""Media query of the dark theme in a page of each theme, whatever the reader prefers."""


def render(report: Report, style: Style, *, frames: bool = False, theme: str = "") -> Iterator[str]:
    """The page, piece by piece; where *style* has no characters beyond ASCII, with references.

    With *frames*, trees have the frames of links; *theme* is one of `THEMES`.
    """
    for piece in _page(report, frames=frames, theme=theme):
        yield piece if style.unicode else piece.encode("ascii", "xmlcharrefreplace").decode("ascii")


def _page(report: Report, *, frames: bool, theme: str) -> Iterator[str]:
    articles = Articles(report)
    pictures = RobotPictures(report, articles.address, frames=frames)
    css = (HERE / "page.css").read_text(encoding="utf-8") + svg.rules() + figure_svg.rules()
    css = css.replace(DARK, THEMES[theme])
    script = "".join((HERE / name).read_text(encoding="utf-8") for name in ("page.js", "views.js"))
    yield "<!DOCTYPE html>\n"
    yield '<html lang="en">\n<head>\n<meta charset="utf-8">\n'
    yield f'<meta http-equiv="Content-Security-Policy" content="{_policy(css, script)}">\n'
    yield '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
    yield f'<meta name="color-scheme" content="{theme or "light dark"}">\n'
    yield f'<meta name="generator" content="kinlint {text(report.version)}">\n'
    yield f"<title>kinlint: {text(_title(report))}</title>\n<style>{css}</style>\n</head>\n<body>\n"
    yield '<a class="skip" href="#findings">Skip to the findings</a>\n'
    yield _header(report)
    yield "<main>\n"
    yield pictures.section()
    yield from tables(report)
    yield from articles.sections(pictures.anchors)
    yield from rules(report)
    yield f"</main>\n{_footer(report)}<script>{script}</script>\n</body>\n</html>\n"


def _policy(css: str, script: str) -> str:
    """Return the content security policy: the page's own style and script, and nothing else."""
    return (
        f"default-src 'none'; style-src '{_digest(css)}'; script-src '{_digest(script)}'; "
        "base-uri 'none'; form-action 'none'"
    )


def _digest(part: str) -> str:
    data = hashlib.sha256(part.encode("utf-8")).digest()
    return f"sha256-{base64.b64encode(data).decode('ascii')}"


def _title(report: Report) -> str:
    if report.unsuppressed:
        return plural(len(report.unsuppressed), "finding")
    return "files could not be read" if report.errors else "no findings"


def _header(report: Report) -> str:
    counts = [
        (severity, sum(one.severity is severity for one in report.unsuppressed))
        for severity in sorted(Severity, reverse=True)
    ]
    cards = "".join(
        element(
            "li",
            f'<span class="sign" aria-hidden="true">{sign(severity)}</span>'
            f"<strong>{count:,}</strong> {severity.label if count == 1 else _plural(severity)}",
            class_=f"card {severity.label if count else 'none'}",
        )
        for severity, count in counts
    )
    clean = bool(report.files) and not (report.unsuppressed or report.errors or report.unapplied)
    praise = '<span aria-hidden="true">✓</span> ' if clean else ""
    kind = "verdict clean" if clean else "verdict"
    seal = element("p", praise + text(verdict(report)), class_=kind)
    title = '<h1><span class="brand">kinlint</span> report</h1>'
    content = f'{title}\n{seal}\n<ul class="cards" aria-label="Findings by severity">{cards}</ul>'
    return f"<header>\n{content}\n{_navigation(report)}\n</header>\n"


def _plural(severity: Severity) -> str:
    return {"error": "errors", "warning": "warnings", "info": "infos"}[severity.label]


def _navigation(report: Report) -> str:
    parts = [
        ("robots", "Robots", bool(report.structures)),
        ("counts", "Counts", bool(report.unsuppressed)),
    ]
    parts += [("findings", "Findings", True), ("rules", "Rules", bool(report.findings))]
    links = "".join(
        f'<li><a href="#{name}">{title}</a></li>' for name, title, there in parts if there
    )
    return f'<nav aria-label="Parts of this page"><ul>{links}</ul></nav>'


def _footer(report: Report) -> str:
    rows = [
        ("Version", f"kinlint {report.version}"),
        ("Rule set", report.catalogue or "not kept"),
        ("Rules", f"{report.applied:,} applied"),
        (
            "Read",
            f"{plural(len(report.files), 'file')}, {plural(report.triples, 'triple')}",
        ),
    ]
    content = "".join(f"<dt>{name}</dt><dd>{text(value)}</dd>" for name, value in rows)
    return f"<footer>\n<dl>{content}</dl>\n</footer>\n"
