"""The findings, file by file: excerpt, reasons and fixes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from kinlint.finding import Finding
from kinlint.report import Report
from kinlint.reporters.display_width import fold_lines
from kinlint.reporters.fixability import sign
from kinlint.reporters.html.excerpts import excerpts
from kinlint.reporters.html.patches import fixes
from kinlint.reporters.html.tables import chip, rule_id
from kinlint.reporters.picture.escape import element, text
from kinlint.reporters.summary import cause_unapplied, plural

OPEN = 25
"""Number of findings above which all are folded."""
PREMISES = 24
FILTER = """<form class="filter" role="search" hidden>
<label>Filter <input type="search" id="filter" placeholder="code, message, file, entity"></label>
<fieldset><legend class="hidden">Severities</legend>
<label><input type="checkbox" value="error" checked> errors</label>
<label><input type="checkbox" value="warning" checked> warnings</label>
<label><input type="checkbox" value="info" checked> infos</label>
</fieldset>
<button type="button" id="unfold">Unfold all</button>
<output id="shown" aria-live="polite"></output>
</form>
"""


class Articles:
    """The findings of a report, numbered in their order."""

    def __init__(self, report: Report) -> None:
        self.report = report
        self._numbers = {id(one): number for number, one in enumerate(report.findings, 1)}

    def address(self, finding: Finding) -> str:
        """Return the link to *finding* on the page."""
        number = self._numbers.get(id(finding))
        return f"#f-{number}" if number is not None else "#findings"

    def sections(self, anchors: Mapping[int, str]) -> Iterator[str]:
        """The section of findings: a part for each file, and what could not be read.

        *anchors* are the marks of findings in figures, by the `id` of the finding.
        """
        yield '<section id="findings" aria-labelledby="findings-title">\n'
        yield '<h2 id="findings-title">Findings</h2>\n'
        yield from self._unread()
        yield from self._fixed()
        if not self.report.findings:
            if not self.report.errors:
                yield '<p class="clean"><span aria-hidden="true">✓</span> Nothing was found.</p>\n'
            yield "</section>\n"
            return
        yield FILTER
        groups: dict[str, list[Finding]] = {}
        for one in self.report.findings:
            groups.setdefault(one.location.source.name, []).append(one)
        for number, (name, group) in enumerate(groups.items(), 1):
            own = f"file-{number}"
            yield f'<section class="file" id="{own}" aria-labelledby="{own}-title">\n'
            count = element("span", plural(len(group), "finding"), class_="count")
            title = f"{element('span', text(name), class_='place')} {count}"
            yield element("h3", title, id=f"{own}-title") + "\n"
            yield from (self._article(one, anchors.get(id(one))) for one in group)
            yield "</section>\n"
        yield "</section>\n"

    def _unread(self) -> Iterator[str]:
        for error in self.report.errors:
            yield f'<p class="unread">{chip_of_error()} {text(str(error))}</p>\n'
        for name in self.report.unapplied:
            yield f'<p class="idle">No rule applied to <span class="place">{text(name)}</span>: '
            yield f"{cause_unapplied(name)}.</p>\n"

    def _fixed(self) -> Iterator[str]:
        """Yield the fixes that the run made, a line for each."""
        if not self.report.fixed:
            return
        yield "<h3>Fixed</h3>\n<ul>\n"
        for one in self.report.fixed:
            start = one.location.start
            where = f"{one.location.source.name}:{start.line}:{start.column}"
            titles = "; ".join(fold_lines(fix.title) for fix in one.fixes)
            yield (
                f"<li>{chip(one.severity)} <code>{text(one.rule.code)}</code> "
                f"{text(fold_lines(one.message))} {element('span', text(where), class_='place')} "
                f"{text(titles)}</li>\n"
            )
        yield "</ul>\n"

    def _article(self, finding: Finding, anchor: str | None) -> str:
        rule, start = finding.rule, finding.location.start
        number = self._numbers[id(finding)]
        mark = sign(finding, unsafe=self.report.unsafe)
        tags = [*rule.antipatterns, *((mark,) if mark else ())]
        if finding.suppressed is not None:
            tags.append("suppressed")
        head = (
            f"{chip(finding.severity)} <code>{text(rule.code)}</code> "
            f'<span class="message">{text(fold_lines(finding.message))}</span> '
            f'<span class="place">{start.line}:{start.column}</span> '
            + "".join(element("span", text(tag), class_="tag") for tag in tags)
        )
        parts = [*excerpts(finding), *_because(finding), *fixes(finding)]
        if finding.suppressed is not None:
            parts.append(element("p", f"Suppressed: {text(fold_lines(finding.suppressed))}"))
        about = element("code", text(finding.entity))
        shown = f'<a href="#{anchor}">Show on the robot</a> · ' if anchor else ""
        parts.append(
            f'<p class="more">About {about}. {shown}'
            f'<a href="#{rule_id(finding)}">What {text(rule.code)} says</a></p>'
        )
        opened = " open" if len(self.report.findings) <= OPEN else ""
        fold = f"<details{opened}><summary>{head}</summary>{''.join(parts)}</details>"
        kind = f"finding {finding.severity.label}"
        if finding.suppressed is not None:
            kind += " suppressed"
        return element("article", fold, id=f"f-{number}", class_=kind) + "\n"


def chip_of_error() -> str:
    """Return the mark of a file that cannot be read."""
    return '<span class="chip error"><span aria-hidden="true">✖</span> not read</span>'


def _because(finding: Finding) -> Iterator[str]:
    """Yield the sentence with the numbers that show *finding*, and what it was derived from."""
    premises = finding.because
    if not premises and not finding.reason:
        return
    items = [f"<li>{text(finding.reason)}</li>"] if finding.reason else []
    for premise in premises[:PREMISES]:
        said = text(fold_lines(premise.statement))
        if premise.axiom:
            said += f' <span class="note">{"" if premise.computed else "inferred: "}'
            said += f"{text(fold_lines(premise.axiom))}</span>"
        if premise.location is not None:
            name, line = premise.location.source.name, premise.location.start.line
            said += f" {element('span', text(f'{name}:{line}'), class_='place')}"
        items.append(element("li", said, class_=f"depth{min(premise.depth, 4)}"))
    if len(premises) > PREMISES:
        items.append(f"<li>and {len(premises) - PREMISES:,} more</li>")
    yield f'<h4>Because</h4><ul class="because">{"".join(items)}</ul>'
