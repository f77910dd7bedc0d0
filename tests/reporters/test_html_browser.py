"""The page and the picture in a browser: its script works, its policy holds, nothing is fetched."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from collections.abc import Sequence
from pathlib import Path

import pytest
from drawn import HOSTILE, about, chain, picture, standing
from reported import INERTIA_FINDING, UNIT_FINDING, UNSAFE, unit_finding

from kinlint.report import Report
from kinlint.reporters.html.page import render
from kinlint.reporters.picture.formats import pieces
from kinlint.reporters.terminal_style import Style
from kinlint.rule import Severity

CHROMIUM = next(
    filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None
)
OPTIONS = (
    *("--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run"),
    *("--disable-background-networking", "--disable-component-update", "--disable-sync"),
    *("--hide-scrollbars", "--virtual-time-budget=2000", "--enable-logging=stderr"),
)
pytestmark = [
    pytest.mark.external,
    pytest.mark.skipif(CHROMIUM is None, reason="Chromium is not installed"),
]
ARM = chain("base", "upper", "lower", close=True)
PROBE = """<script>
const said = { shown: document.getElementById("shown")?.textContent, titles: document.title,
  form: document.querySelector("form.filter")?.hidden,
  copy: document.querySelector(".copy")?.hidden,
  folded: [...document.querySelectorAll("article.finding")].map((each) => each.hidden),
  wide: document.documentElement.scrollWidth <= document.documentElement.clientWidth };
document.title = JSON.stringify(said);
</script>"""


def browse(file: Path, *arguments: str, fragment: str = "") -> tuple[str, str]:
    """The page as it is once its scripts ran, and what the browser says of it."""
    assert CHROMIUM is not None
    profile = file.parent / "profile"
    url = f"{file.as_uri()}{fragment}"
    command: Sequence[str] = (CHROMIUM, *OPTIONS, f"--user-data-dir={profile}", *arguments, url)
    done = subprocess.run(command, capture_output=True, check=False, timeout=120)
    logged = done.stderr.decode("utf-8", "replace")
    return done.stdout.decode("utf-8", "replace"), logged


def console(logged: str) -> list[str]:
    return [line for line in logged.splitlines() if "CONSOLE" in line]


def page(directory: Path, made: Report, extra: str = "") -> Path:
    file = directory / "report.html"
    text = "".join(render(made, Style()))
    file.write_text(text.replace("</body>", f"{extra}</body>"), "utf-8")
    return file


MADE = picture(
    about("urn:l1"),
    INERTIA_FINDING,
    unit_finding(UNIT_FINDING.location, fixes=(UNSAFE,), severity=Severity.WARNING),
    robots=(ARM,),
)


def test_the_script_runs_and_the_policy_lets_nothing_else_run(tmp_path: Path) -> None:
    dom, logged = browse(page(tmp_path, MADE, PROBE), "--dump-dom")
    assert "3 of 3 shown" in dom
    assert "<title>kinlint: 3 findings</title>" in dom, "the policy let a foreign script run"
    assert any("Content Security Policy" in line for line in console(logged))


def test_it_is_quiet_by_itself(tmp_path: Path) -> None:
    _, logged = browse(page(tmp_path, MADE), "--dump-dom")
    assert console(logged) == []


def test_what_a_script_would_see(tmp_path: Path) -> None:
    """The policy is taken out, so that the probe may look."""
    file = page(tmp_path, MADE, PROBE)
    file.write_text(re.sub(r"<meta http-equiv[^>]*>", "", file.read_text("utf-8")), "utf-8")
    for size in ("1280,900", "420,900"):
        dom, _ = browse(file, "--dump-dom", f"--window-size={size}")
        (title,) = re.findall(r"<title>(\{.*?\})</title>", dom)
        said = json.loads(title)
        assert said["wide"], "the page scrolls sideways"
        assert (said["form"], said["copy"]) == (False, False)
        assert said["folded"] == [False] * 3


def test_an_address_unfolds_what_it_leads_to(tmp_path: Path) -> None:
    dom, _ = browse(page(tmp_path, MADE), "--dump-dom", fragment="#rule-UNI002")
    assert re.search(r'<details id="rule-UNI002"[^>]* open=""', dom)


def test_names_are_text_in_a_browser(tmp_path: Path) -> None:
    robot = standing(chain(*HOSTILE, close=True))
    found = [about(f"urn:l{index}", message=name) for index, name in enumerate(HOSTILE)]
    dom, logged = browse(page(tmp_path, picture(*found, robots=(robot,))), "--dump-dom")
    assert console(logged) == []
    assert "<script>alert" not in dom


@pytest.mark.parametrize("dark", [False, True])
def test_a_screenshot_has_colours(tmp_path: Path, *, dark: bool) -> None:
    shot = tmp_path / "shot.png"
    arguments = [f"--screenshot={shot}", "--window-size=900,1400", *["--force-dark-mode"] * dark]
    browse(page(tmp_path, MADE), *arguments)
    assert shot.read_bytes()[:8] == b"\x89PNG\r\n\x1a\n"
    assert shot.stat().st_size > 20_000


STANDING = standing(chain("base", "upper", "lower", "hand"), (0.1, 0.05, 0.3))
FIGURE = picture(about("urn:l1"), about("urn:j1"), about("urn:l3"), robots=(STANDING,))
TURNS = f"<script>{Path(__file__).with_name('turning_probe.js').read_text('utf-8')}</script>"


def places(ways: list[str]) -> list[float]:
    return [float(each) for way in ways for each in re.findall(r"-?[\d.]+", way)]


@pytest.mark.parametrize("size", ["1280,900", "420,900"])
def test_a_figure_turns_moves_and_zooms(tmp_path: Path, size: str) -> None:
    """By keyboard, mouse and wheel; its tags keep apart, and it returns to what is written."""
    file = page(tmp_path, FIGURE, TURNS)
    file.write_text(re.sub(r"<meta http-equiv[^>]*>", "", file.read_text("utf-8")), "utf-8")
    dom, logged = browse(file, "--dump-dom", f"--window-size={size}")
    assert console(logged) == []
    (title,) = re.findall(r"<title>(\{.*?\})</title>", dom)
    said = json.loads(title)
    assert said["reset"] != said["turned"]
    drawn = places(said["drawn"])
    assert drawn == pytest.approx(places(said["reset"]), abs=0.11)
    for each in ("turned", "moved", "zoomed", "dragged", "wheeled"):
        assert places(said[each]) != pytest.approx(drawn, abs=1.0), each
    assert not said["crossed"], "a tag lies over another or outside"
    assert said["tree"][0] != said["tree"][1]
    assert said["aimed"].startswith("robot0-figure-")


def test_a_large_robot_folds(tmp_path: Path) -> None:
    robot = standing(chain(*(f"link_{n}" for n in range(300))))
    made = picture(about("urn:l200"), robots=(robot,))
    probe = """<script>
    const seen = (each) => each.checkVisibility();
    const rows = () => [...document.querySelectorAll(".outline li")].filter(seen).length;
    const before = rows();
    document.querySelector(".outline .unfold").click();
    document.title = JSON.stringify([before, rows(), document.querySelector(".canvas") === null]);
    </script>"""
    file = page(tmp_path, made, probe)
    file.write_text(re.sub(r"<meta http-equiv[^>]*>", "", file.read_text("utf-8")), "utf-8")
    assert file.stat().st_size < 1_500_000
    dom, _ = browse(file, "--dump-dom")
    (title,) = re.findall(r"<title>(\[.*?\])</title>", dom)
    folded, unfolded, outlined = json.loads(title)
    assert folded < 20
    assert unfolded >= 300
    assert outlined


def test_a_picture_alone_is_sound(tmp_path: Path) -> None:
    file = tmp_path / "robot.svg"
    made = picture(about("urn:l1"), robots=(chain(*HOSTILE, close=True),))
    file.write_text("".join(pieces(made, "svg", Style(), frames=True)), "utf-8")
    dom, logged = browse(file, "--dump-dom")
    assert console(logged) == []
    assert dom.count("<ellipse") == len(HOSTILE)
    assert "parsererror" not in dom
