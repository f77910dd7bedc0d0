"""`kinlint graph`: formats, destinations, and what it says where there is nothing to draw."""

from __future__ import annotations

import io
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest

from kinlint.cli.main import main

LINKS = '<link name="a"/><link name="b"/>'
JOINT = '<joint name="j" type="fixed"><parent link="a"/><child link="{}"/></joint>'
ROBOT = f'<robot name="arm">{LINKS}{JOINT.format("b")}</robot>'
BROKEN = f'<robot name="arm">{LINKS}{JOINT.format("bb")}</robot>'
TREE = "arm: 2 links, 1 joint\na\n└─ j (fixed) → b\n"


@pytest.fixture
def robot(tmp_path, rules_cache, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "arm.urdf").write_text(ROBOT, "utf-8")
    (tmp_path / "broken.urdf").write_text(BROKEN, "utf-8")
    return tmp_path


def graph(capsys, *arguments: str) -> tuple[int, str, str]:
    capsys.readouterr()
    code = main(["graph", *arguments])
    return (code, *capsys.readouterr())


def test_a_tree_of_text_is_the_default(robot, capsys):
    assert graph(capsys, "arm.urdf") == (0, TREE, "")


def test_findings_change_the_picture_and_not_the_exit_code(robot, capsys):
    code, out, err = graph(capsys, "broken.urdf")
    assert (code, err) == (0, "")
    assert "[✖ TOP001]" in out
    assert "bb (not described)" in out
    code, out, _ = graph(capsys, "broken.urdf", "--no-findings")
    assert (code, "TOP001" in out) == (0, False)
    code, out, _ = graph(capsys, "broken.urdf", "--ignore", "TOP001")
    assert (code, "TOP001" in out) == (0, False)


@pytest.mark.parametrize(
    ("name", "first"),
    [
        ("arm.svg", "<svg"),
        ("arm.mmd", "flowchart TB"),
        ("arm.dot", "digraph"),
        ("arm.gv", "digraph"),
        ("arm.txt", "arm: 2 links"),
    ],
)
def test_the_name_of_the_output_file_says_the_format(robot, capsys, name, first):
    assert graph(capsys, "arm.urdf", "-o", name) == (0, "", "")
    assert Path(name).read_text("utf-8").startswith(first)


def test_the_option_says_it_first(robot, capsys):
    graph(capsys, "arm.urdf", "-o", "arm.dot", "--output-format", "svg")
    assert Path("arm.dot").read_text("utf-8").startswith("<svg")


def test_a_page_has_the_robot_and_its_findings(robot, capsys):
    graph(capsys, "arm.urdf", "-o", "arm.html")
    page = Path("arm.html").read_text("utf-8")
    assert page.startswith("<!DOCTYPE html>")
    assert 'class="robot"' in page
    assert 'id="findings"' in page


def test_svg_has_a_stick_figure_where_joints_are_placed(robot, capsys):
    placed = ROBOT.replace('<child link="b"/>', '<child link="b"/><origin xyz="0 0 1"/>')
    assert placed != ROBOT
    (robot / "placed.urdf").write_text(placed, "utf-8")
    for name, shown in (("arm", 0), ("placed", 1)):
        graph(capsys, f"{name}.urdf", "-o", f"{name}.svg")
        picture = Path(f"{name}.svg").read_text("utf-8")
        assert picture.count('class="stick"') == shown
        ET.fromstring(picture)  # noqa: S314  it is our own


def test_standard_input_has_a_name(robot, capsys, monkeypatch):
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(ROBOT.encode())))
    assert graph(capsys, "-", "--stdin-filename", "x.urdf") == (0, TREE, "")


def test_several_robots_are_drawn_below_each_other(robot, capsys):
    (robot / "arm two.urdf").write_text(ROBOT.replace("arm", "leg"), "utf-8")
    _, out, _ = graph(capsys, "arm.urdf", "arm two.urdf")
    assert sorted(line for line in out.splitlines() if ":" in line) == [
        *("arm: 2 links, 1 joint", "leg: 2 links, 1 joint"),
    ]


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["nothing.urdf"], "nothing.urdf: no such file or directory"),
        (["empty.urdf"], "empty.urdf: it describes no link and no joint"),
        (["empty.urdf", "empty2.urdf"], "no robot to draw in 2 files: no link and no joint"),
        (["torn.urdf"], "torn.urdf:"),
        (["cut.urdf"], "cut.urdf: it describes no link and no joint (SRC019: "),
        (["empty"], "no robot found in 'empty'"),
        ([], "name the file of a robot to draw, or - for standard input"),
        (["arm.urdf", "--output-format", "png"], "--output-format"),
        (["arm.urdf", "-o", "arm.png"], "-o: no format is called '.png'; --output-format svg|"),
        (
            ["arm.urdf", "-o", "arm.urdf", "--output-format", "svg"],
            "-o: arm.urdf is read in this run, and would be lost",
        ),
        (["arm.urdf", "-o", "no/arm.svg"], "cannot write"),
        (["arm.urdf", "--select", "XYZ9"], "XYZ9"),
    ],
)
def test_what_cannot_be_drawn_is_an_error(robot, capsys, arguments, said):
    for name in ("empty.urdf", "empty2.urdf"):
        (robot / name).write_text('<robot name="x"/>', "utf-8")
    (robot / "torn.urdf").write_text("<!DOCTYPE robot><robot", "utf-8")
    (robot / "cut.urdf").write_text('<robot name="x"><link name="a"', "utf-8")
    (robot / "empty").mkdir()
    code, out, err = graph(capsys, *arguments)
    assert (code, out) == (2, "")
    assert err.startswith("kinlint: error: ")
    assert said in err
    assert err.count("\n") == 1


def test_nothing_is_written_where_nothing_is_drawn(robot, capsys):
    (robot / "empty.urdf").write_text('<robot name="x"/>', "utf-8")
    assert graph(capsys, "empty.urdf", "-o", "x.svg")[0] == 2
    assert not Path("x.svg").exists()


@pytest.mark.slow
def test_the_html_report_goes_to_standard_output_or_a_file(robot, capsys):
    assert main(["broken.urdf", "--output-format", "html"]) == 1
    out, err = capsys.readouterr()
    assert out.startswith("<!DOCTYPE html>")
    assert "Found" in err
    assert main(["broken.urdf", "-q", "--html-output", "r.html", "-j", "1"]) == 1
    assert Path("r.html").read_text("utf-8") == out


@pytest.mark.slow
def test_several_processes_draw_what_one_draws(robot, capsys):
    for number in range(4):
        text = ROBOT.replace("arm", f"arm{number}")
        (robot / f"r{number}.urdf").write_text(text, "utf-8")
    pages = []
    for jobs in ("1", "3"):
        main([".", "--output-format", "html", "-q", "-j", jobs, "--isolated"])
        pages.append(capsys.readouterr().out)
    assert pages[0] == pages[1]
    assert pages[0].count("<svg") == 6


def test_fixed_robots_are_drawn_as_they_are_left(robot, capsys):
    code = main(["broken.urdf", "--fix", "--unsafe-fixes", "--output-format", "html", "-q"])
    page = capsys.readouterr().out
    assert code in {0, 1}
    assert "<svg" in page
    if "<h3>Fixed</h3>" in page:
        assert "TOP001</a>" not in page
