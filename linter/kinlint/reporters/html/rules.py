"""The documentation of the rules that found something, folded in."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.report import Report
from kinlint.reporters.html.tables import rule_id
from kinlint.reporters.picture.escape import element, text
from kinlint.reporters.rule_page import help_markdown


def rules(report: Report) -> Iterator[str]:
    """The section of rules; nothing if nothing was found."""
    told = {one.rule.code: one for one in report.findings}
    if not told:
        return
    from markdown_it import MarkdownIt  # noqa: PLC0415  pages without findings need none

    markdown = MarkdownIt("commonmark", {"html": False})
    yield '<section id="rules" aria-labelledby="rules-title">\n<h2 id="rules-title">Rules</h2>\n'
    for code in sorted(told):
        rule = told[code].rule
        title = f"<code>{text(code)}</code> {text(rule.name)}"
        head = element("summary", f"<h3>{title}</h3>")
        body = f"<p><strong>{text(rule.title)}</strong></p>{markdown.render(help_markdown(rule))}"
        doc = element("div", body, class_="doc")
        yield element("details", head + doc, id=rule_id(told[code]), class_="rule") + "\n"
    yield "</section>\n"
