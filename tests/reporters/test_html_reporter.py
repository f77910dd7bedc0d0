"""The page of HTML: what is on it, that its parts lead to each other, and that names are text."""

from __future__ import annotations

import base64
import hashlib
import re
import shutil
import subprocess
from dataclasses import replace
from html import unescape
from html.parser import HTMLParser
from pathlib import Path

import pytest
from drawn import HOSTILE, about, chain, picture, standing
from reported import (
    BOTH,
    DYNAMICS,
    INERTIA_FINDING,
    SAFE,
    UNIT_FINDING,
    UNSAFE,
    edit,
    here,
    report,
    unit_finding,
)

from kinlint.errors import SourceError
from kinlint.finding import Related
from kinlint.report import Report
from kinlint.reporters.html.page import render
from kinlint.reporters.terminal_style import Style
from kinlint.rule import Severity
from kinlint.structure import Joint, Structure
from kinlint.text import Location, SourceText, Span

VOID = {"meta", "input", "br", "hr"}


class Page(HTMLParser):
    """A page as browsers take it apart; elements have to be closed where they are opened."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.text = text
        self.open: list[str] = []
        self.elements: list[tuple[str, dict[str, str | None]]] = []
        self.said: list[tuple[str, str]] = []
        self.feed(text)
        self.close()
        assert self.open == []

    def handle_starttag(self, tag, attrs):
        self.elements.append((tag, dict(attrs)))
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.elements.append((tag, dict(attrs)))

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.said.append((self.open[-1] if self.open else "", data))

    def all(self, tag: str) -> list[dict[str, str | None]]:
        return [attributes for name, attributes in self.elements if name == tag]

    @property
    def words(self) -> str:
        said = (text for tag, text in self.said if tag not in {"script", "style"})
        return " ".join(" ".join(said).split())


def page(made: Report) -> Page:
    return Page("".join(render(made, Style())))


ARM = chain("base", "upper", "lower", close=True)
DRAWN = picture(about("urn:l1"), INERTIA_FINDING, robots=(ARM,))


def test_it_says_what_the_run_amounts_to_and_by_what() -> None:
    words = page(report(INERTIA_FINDING, catalogue="c0ffee", applied=2, triples=1204)).words
    assert "Found 1 error" in words
    assert "Version kinlint 1.2.3" in words
    assert "c0ffee" in words


def test_all_ids_differ_and_all_links_lead_somewhere() -> None:
    made = page(DRAWN)
    ids = [attributes["id"] for _, attributes in made.elements if "id" in attributes]
    assert len(ids) == len(set(ids))
    targets = [attributes["href"] for attributes in made.all("a")]
    assert targets
    for target in targets:
        assert target is not None
        assert not target.startswith("#") or target[1:] in ids
        assert target.startswith(("#", "https://", "http://"))


def test_badges_in_the_picture_lead_to_the_finding() -> None:
    badges = [each for each in page(DRAWN).all("a") if "aria-label" in each]
    assert [each["href"] for each in badges] == ["#f-1"]


def test_nothing_is_loaded_and_nothing_but_its_own_may_run() -> None:
    made = page(DRAWN)
    assert not made.all("link")
    assert not made.all("img")
    for _, attributes in made.elements:
        assert "src" not in attributes
        assert "style" not in attributes
        assert not any(name.startswith("on") for name in attributes)
    (policy,) = (each["content"] for each in made.all("meta") if "http-equiv" in each)
    assert policy is not None
    assert policy.startswith("default-src 'none'; ")
    for tag in ("style", "script"):
        (own,) = (text for name, text in made.said if name == tag)
        digest = base64.b64encode(hashlib.sha256(own.encode()).digest()).decode()
        assert f"{tag}-src 'sha256-{digest}'" in policy


def test_a_finding_has_excerpt_reasons_fix_and_documentation() -> None:
    fixed = report(unit_finding(UNIT_FINDING.location, fixes=(UNSAFE,)), INERTIA_FINDING)
    words = page(fixed).words
    for said in (
        '"as-seen-by": "rob:link1-root"',
        "but the inertia belongs to rob:link2",
        "inferred: what has an origin is a Frame",
        "models/skeleton.jsonld:2:",
        "Express it in frame 'rob:link2-root'",
        "unsafe fix",
        "The numbers stay as they are.",
        '-      "as-seen-by": "rob:link1-root",',
        '+      "as-seen-by": "rob:link2-root",',
        "An inertia is a matrix of numbers, and numbers need a frame.",
    ):
        assert " ".join(said.split()) in words


def test_a_fix_is_a_patch() -> None:
    text = "".join(render(report(unit_finding(UNIT_FINDING.location, fixes=(SAFE,))), Style()))
    (diff,) = re.findall(r'<pre class="diff".*?</pre>', text, re.DOTALL)
    assert "@@ -7,1 +7,1 @@" in diff
    assert f"--- {DYNAMICS.name}" in diff


def test_the_patch_on_the_page_can_be_applied(tmp_path: Path) -> None:
    if (program := shutil.which("patch")) is None:
        pytest.skip("there is no patch")
    before, after = '{\n\t"a": 1,\n\t"b": "<&>"}', '{\n\t"a": 1,\n\t"b": "</pre>",\n\t"c": 2}'
    source = SourceText("m.json", before)
    edits = (edit(source, "<&>", "</pre>"), edit(source, "}", ',\n\t"c": 2}'))
    finding = unit_finding(Location(source, Span(0, 1)), fixes=(replace(SAFE, edits=edits),))
    made = "".join(render(report(finding), Style()))
    assert 'class="copy"' in made
    (diff,) = re.findall(r'<pre class="diff"[^>]*>(.*?)</pre>', made, re.DOTALL)
    (tmp_path / "m.json").write_text(before, "utf-8")
    patch = unescape(re.sub(r"<[^>]*>", "", diff))
    done = subprocess.run([program, "-p0"], input=patch.encode(), cwd=tmp_path, check=False)
    assert done.returncode == 0
    assert (tmp_path / "m.json").read_text("utf-8") == after


@pytest.mark.parametrize("line", ["\r\n", "\x00\n"])
def test_what_is_no_patch_is_not_copied(line: str) -> None:
    source = SourceText("m.json", f'"a": 1{line}')
    fix = replace(SAFE, edits=(edit(source, "1", "2\x00"),))
    finding = unit_finding(Location(source, Span(0, 1)), fixes=(fix,))
    assert 'class="copy"' not in "".join(render(report(finding), Style()))


def test_places_that_say_nothing_more_are_listed() -> None:
    text = "x\n" * 40
    source = SourceText("m.json", text)
    others = tuple(Related(Location(source, Span(at, at + 1)), "") for at in range(20, 60, 2))
    words = page(report(unit_finding(Location(source, Span(0, 1)), related=others))).words
    assert "The same at 20 other places m.json: 11:1, 12:1," in words


def test_tables_count_by_severity_rule_anti_pattern_and_file() -> None:
    made = page(BOTH)
    captions = [text for tag, text in made.said if tag == "caption"]
    assert captions == ["By severity", "By rule", "By anti-pattern", "By file"]
    assert "AP3 Artificial structural constraints 1" in made.words
    assert all(each["scope"] in {"row", "col"} for each in made.all("th"))


def test_it_has_landmarks_a_language_and_a_way_past_the_picture() -> None:
    made = page(DRAWN)
    assert [len(made.all(tag)) for tag in ("header", "nav", "main", "footer", "h1")] == [1] * 5
    assert made.all("html")[0]["lang"] == "en"
    assert {"href": "#findings", "class": "skip"} in [
        {name: each.get(name) for name in ("href", "class")} for each in made.all("a")
    ]
    (svg,) = made.all("svg")
    titles = [text for tag, text in made.said if tag == "title"]
    assert svg["aria-labelledby"] == "robot0-title"
    assert "Kinematic structure of arm: 3 links, 3 joints, 1 loop" in titles


def test_everything_can_be_read_without_a_script() -> None:
    made = page(DRAWN)
    assert [each.get("hidden", "shown") for each in made.all("form")] == [None]
    assert all("hidden" in each for each in made.all("button") if each.get("class") == "copy")
    assert made.all("details")


def test_a_clean_run_says_so() -> None:
    made = page(report(files=("arm.urdf",), applied=3))
    assert "All checks passed" in made.words
    assert "Nothing was found." in made.words
    assert not made.all("table")


def test_files_that_cannot_be_read_come_first() -> None:
    made = page(report(INERTIA_FINDING, errors=(SourceError("x.urdf", "torn", 3, 4),)))
    assert "not read x.urdf:3:4: torn" in made.words


def test_a_suppressed_finding_is_marked_and_not_counted() -> None:
    quiet = unit_finding(UNIT_FINDING.location, suppressed="set at run time")
    made = page(report(quiet))
    assert "Suppressed: set at run time" in made.words
    assert "0 errors" in made.words


def test_fixed_findings_are_listed() -> None:
    made = page(report(fixed=(unit_finding(UNIT_FINDING.location, fixes=(SAFE,)),)))
    assert "Fixed" in made.words


@pytest.mark.slow
@pytest.mark.parametrize("unicode", [True, False])
def test_names_are_text_wherever_they_stand(*, unicode: bool) -> None:
    for name in HOSTILE:
        location = here(f'"{name}" {name}', 0, len(name) + 2, name=f"{name}.urdf")
        finding = unit_finding(
            location, name, message=f"It is {name}.", iri=f"urn:{name}", severity=Severity.WARNING
        )
        robot = standing(chain(name, f"{name} 2", close=True))
        made = picture(finding, about("urn:l1", message=name), robots=(robot,))
        text = "".join(render(made, Style(unicode=unicode)))
        assert unicode or text.isascii()
        text.encode()
        parsed = Page(text)
        tags = {tag for tag, _ in parsed.elements}
        assert tags <= ALLOWED
        assert len(parsed.all("script")) == len(parsed.all("style")) == 1
        for _, attributes in parsed.elements:
            assert not any(each.startswith("on") for each in attributes)
            assert not str(attributes.get("href", "#")).lower().startswith("javascript")


def test_names_are_text_in_the_outline_of_a_large_robot() -> None:
    names = [f"{name} {number}" for number in range(3) for name in HOSTILE]
    robot = standing(chain(*names, close=True))
    found = [about(f"urn:l{index}", message=name) for index, name in enumerate(names[::7])]
    parsed = page(picture(*found, robots=(robot,)))
    assert {tag for tag, _ in parsed.elements} <= ALLOWED
    assert len(parsed.all("script")) == 1
    assert {"class": "outline"} in parsed.all("div")


def test_findings_and_the_figure_lead_to_each_other() -> None:
    made = page(picture(about("urn:l1"), robots=(standing(ARM),)))
    ids = {attributes.get("id") for _, attributes in made.elements}
    (shown,) = (
        str(each["href"])
        for each in made.all("a")
        if str(each["href"]).startswith("#robot0-figure")
    )
    assert shown[1:] in ids
    flags = [each for each in made.all("a") if "aria-label" in each]
    assert [each["href"] for each in flags] == ["#f-1", "#f-1"]
    assert "All joints at zero." in made.words


def test_infos_are_listed_and_not_drawn() -> None:
    made = page(picture(about("urn:l1", Severity.INFO), robots=(standing(ARM),)))
    assert not [each for each in made.all("a") if "aria-label" in each]
    assert "UNI002" in made.words


def test_a_tree_deeper_than_browsers_nest_is_outlined() -> None:
    links = chain(*(f"link {n}" for n in range(400))).links
    joints = tuple(
        Joint(f"urn:j{n}", f"joint {n}", "fixed", f"urn:l{n // 2 * 2}", f"urn:l{n + 1}")
        for n in range(399)
    )
    robot = Structure("urn:arm", "arm", links, joints, roots=("urn:l0",))
    text = "".join(render(picture(about("urn:l399"), robots=(robot,)), Style()))
    depth = deepest = 0
    for tag in re.findall(r"<(/?)(?:ul|details)\b", text):
        depth += -1 if tag else 1
        deepest = max(deepest, depth)
    assert 20 < deepest < 60
    assert text.count('class="link-name"') == 400


ALLOWED = {
    *(
        "html",
        "head",
        "meta",
        "title",
        "style",
        "body",
        "header",
        "nav",
        "main",
        "footer",
        "section",
    ),
    *("article", "details", "summary", "figure", "form", "fieldset", "legend", "label", "input"),
    *(
        "button",
        "output",
        "table",
        "caption",
        "thead",
        "tbody",
        "tr",
        "th",
        "td",
        "div",
        "span",
        "p",
        "br",
    ),
    *("a", "ul", "li", "dl", "dt", "dd", "h1", "h2", "h3", "h4", "strong", "em", "code", "pre"),
    *(
        "mark",
        "del",
        "ins",
        "script",
        "svg",
        "g",
        "rect",
        "circle",
        "figcaption",
        "ellipse",
        "path",
        "text",
        "defs",
        "marker",
    ),
}
