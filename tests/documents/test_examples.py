"""What documents show, beside commands, is what happens."""

import re
import shutil
import sqlite3
import subprocess
import sys
import tomllib
from contextlib import closing
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from fenced import ROOT, blocks
from pictures import (
    HOME,
    REPORT,
    ROBOT,
    TERMINAL,
    digest_of,
    report,
    report_digest,
    terminal,
)

from kinlint.catalogue import rulebook
from kinlint.cli.main import main
from kinlint.rule_testing import rule_conformance

pytestmark = pytest.mark.slow

USING, CONFIGURING, REPORTING, SERVING = (
    f"linter/kinlint/{name}/README.md" for name in ("cli", "configuration", "reporters", "server")
)
ELSEWHERE = {
    ("README.md", "yaml"): "tests/ci",
    (REPORTING, "yaml"): "tests/ci",
    (SERVING, "lua"): "tests/server",
    (SERVING, "elisp"): "tests/server",
    (SERVING, "toml"): "tests/server",
    (SERVING, "json"): "tests/server",
    ("shapes/targets/README.md", "turtle"): "tests/targets",
}
"""Where other examples are tried: by their page, and their language or what they contain."""
HERE = {
    *(("CONTRIBUTING.md", language) for language in ("turtle", "json", "toml")),
    *((USING, language) for language in ("toml", "json", "xml", "text", "")),
    *((CONFIGURING, language) for language in ("toml", "json", "xml", "text", "")),
    *((REPORTING, language) for language in ("toml", "json", "xml", "text", "", "sql")),
    *(("README.md", language) for language in ("xml", "")),
    ("linter/README.md", "mermaid"),
}


def test_every_example_is_tried():
    """Commands all, by `test_commands`; a new kind of example needs a test."""
    for block in blocks():
        claimed = block.language == "sh" or (block.page, block.language) in {*HERE, *ELSEWHERE}
        assert claimed, f"{block}: no test tries this {block.language or 'text'}"


def test_the_picture_of_the_stages_names_packages():
    """Each stage is done where the picture says."""
    stages, _ = blocks("linter/README.md", language="mermaid")
    packages = re.findall(r"(\w+)/", stages.text)

    assert packages
    for package in packages:
        assert (ROOT / "linter/kinlint" / package).is_dir(), package


def test_the_picture_of_the_layers_is_that_of_the_contract():
    """Each arrow leads from a layer of the import contract to a lower one."""
    _, layers = blocks("linter/README.md", language="mermaid")
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["tool"]["importlinter"]
    contract = next(each for each in settings["contracts"] if each["type"] == "layers")
    rank = {
        name: number
        for number, layer in enumerate(contract["layers"])
        for name in layer.split(" | ")
    }
    arrows = [line.split(" --> ") for line in layers.text.splitlines() if "-->" in line]

    assert arrows
    for above, below in arrows:
        for lower in re.sub(r"base\[.*", "document", below).split(" & "):
            assert all(rank[upper.strip()] < rank[lower] for upper in above.split(" & ")), lower


def test_the_readme_opens_with_a_robot_and_what_is_found_in_it(capsys, monkeypatch):
    """The robot of `kinlint demo`, with all that is said of it."""
    monkeypatch.chdir(HOME)
    (robot,) = blocks("README.md", language="xml")
    shown = blocks("README.md", language="")[0].text

    code = main([ROBOT, "--output-format", "concise", "--isolated"])

    assert robot.text == (HOME / ROBOT).read_text("utf-8")
    assert (code, capsys.readouterr().out) == (1, shown)


def test_the_questions_to_the_database_have_answers(tmp_path, monkeypatch):
    """Between two runs of the same robot nothing is new."""
    monkeypatch.chdir(HOME)
    for name in ("before", "findings"):
        assert main([ROBOT, "--isolated", "--output", f"sqlite={tmp_path / name}.db"]) == 1
    (asked,) = blocks("linter/kinlint/reporters/README.md", language="sql")
    monkeypatch.chdir(tmp_path)
    with closing(sqlite3.connect("findings.db")) as database:
        answers = [database.execute(each).fetchall() for each in asked.text.split(";")]
        count = database.execute("SELECT count(*) FROM finding").fetchone()[0]

    most, families, _, new, _ = answers
    assert sum(row[2] for row in most) == count > 0
    assert families
    assert new == []


def test_the_picture_of_the_terminal_is_fresh():
    """`python tests/documents/pictures.py` makes it."""
    assert TERMINAL.read_text("utf-8") == terminal()


def test_the_picture_of_the_report_is_fresh():
    """`python tests/documents/pictures.py` makes it, with the digest of the page that it shows."""
    picture = REPORT.read_bytes()
    assert picture.startswith(b"\x89PNG")
    assert len(picture) < 300_000
    assert digest_of(picture) == report_digest(report())


def test_the_digest_of_a_report_tells_what_its_picture_shows():
    page = report()
    assert report_digest(page.replace("upper_arm", "lower_arm")) != report_digest(page)
    assert report_digest(page.replace("--paper: #ffffff", "--paper: #fffffe")) != report_digest(
        page
    )
    assert report_digest(page.replace("<footer>", "<footer>1")) == report_digest(page)


def test_what_the_readme_says_of_check_urdf():
    """It names the missing link and nothing else; then all is well."""
    program = shutil.which("check_urdf", path=str(Path(sys.executable).parent))
    if program is None:
        pytest.skip("check_urdf (cmeel-urdfdom) is not installed")
    robot = (HOME / ROBOT).read_text("utf-8")

    def said(text, path):
        path.write_text(text, "utf-8")
        done = subprocess.run([program, path], capture_output=True, text=True, check=False)
        return done.stdout + done.stderr

    with TemporaryDirectory() as home:
        first = said(robot, Path(home, "arm.urdf"))
        second = said(robot.replace("fore_arm", "forearm"), Path(home, "arm.urdf"))

    assert "child link [fore_arm] of joint [elbow] not found" in first
    assert "Successfully Parsed XML" in second


def test_the_readme_installs_and_runs_with_one_command(tmp_path):
    """On a machine that has Python and a registry of packages."""
    command = blocks("README.md", language="sh")[0].commands[0]
    wanted = ("pyproject.toml", "README.md", "LICENSE", "linter", "rules", "shapes", "samples")
    for name in wanted:
        copied, source = tmp_path / name, ROOT / name
        shutil.copytree(source, copied) if source.is_dir() else shutil.copyfile(source, copied)

    line = command.replace("python3", sys.executable, 1)
    done = subprocess.run(
        ["bash", "-c", line], cwd=tmp_path, capture_output=True, text=True, timeout=600, check=False
    )

    if re.search("No matching distribution|NewConnectionError|Read timed out", done.stderr):
        pytest.skip("no registry of packages can be reached")
    assert (done.returncode, done.stdout) == (0, "All checks passed in 7 files.\n"), done.stderr


def test_the_shape_that_contributing_begins_with_finds_names(tmp_path, capsys):
    """Of joints that end in something else, at the name."""
    (tmp_path / "suffix.ttl").write_text(blocks("CONTRIBUTING.md", language="turtle")[0].text)
    shapes = str(tmp_path / "suffix.ttl")

    arguments = ["--shapes", shapes, "--select", "SHACL", "--output-format", "concise"]
    assert main([str(HOME / ROBOT), "--isolated", *arguments]) == 1

    shown = capsys.readouterr().out.splitlines()
    assert [line.rpartition("arm.urdf:")[2].partition(": ")[0] for line in shown[:2]] == [
        "15:16",
        "20:16",
    ]


def test_the_urdf_rule_of_contributing_is_a_rule(tmp_path):
    """It keeps all the promises that a rule has to keep, with no remark."""
    file = tmp_path / "joint-without-suffix.ttl"
    file.write_text(blocks("CONTRIBUTING.md", language="turtle")[1].text, "utf-8")
    book = rulebook.load([tmp_path])

    assert list(rule_conformance.failures(book.by_name["joint-without-suffix"], book)) == []


def test_the_rule_that_contributing_walks_through_is_a_rule(tmp_path):
    """It keeps all the promises that a rule has to keep."""
    file = tmp_path / "space-in-identifier.ttl"
    file.write_text(blocks("CONTRIBUTING.md", language="turtle")[2].text, "utf-8")
    book = rulebook.load([tmp_path])

    assert list(rule_conformance.failures(book.by_name["space-in-identifier"], book)) == []


def test_the_repair_that_contributing_shows_is_one_of_a_rule():
    """To the word."""
    repair = blocks("CONTRIBUTING.md", language="turtle")[3].text
    rule = (ROOT / "rules/limits/inverted-limit.ttl").read_text("utf-8")

    assert " ".join(repair.split()).removesuffix(" ;") in " ".join(rule.split())


@pytest.mark.parametrize(
    ("language", "name"),
    [("json", "vector-list.json"), ("turtle", "vector-list.ttl"), ("toml", "kinlint.toml")],
)
def test_the_extension_that_contributing_shows_is_that_of_the_sample(language, name):
    """Each of its three parts."""
    shown = blocks("CONTRIBUTING.md", language=language)[-1].text
    kept = (ROOT / "samples/vendor" / name).read_text("utf-8")

    for part in shown.split("\n\n"):
        assert " ".join(part.split()) in " ".join(kept.split())


CONFIGURATIONS = [
    block
    for block in blocks(USING, CONFIGURING, REPORTING, language="toml")
    if "tool.kinlint" in block.text
]


@pytest.mark.parametrize("shown", CONFIGURATIONS, ids=str)
def test_the_configuration_that_the_program_shows_is_accepted(shown, tmp_path, monkeypatch, capsys):
    """Every key of the example is known, and every value of its kind."""
    (tmp_path / "pyproject.toml").write_text(shown.text, "utf-8")
    for folder in ("rules", "shapes", "contexts"):
        (tmp_path / folder).mkdir()
    (tmp_path / "shapes/gripper.ttl").write_text("")
    (tmp_path / "contexts/gripper.json").write_text('{"@context": {}}')
    shutil.copyfile(ROOT / "samples/one-dof/chain.jsonld", tmp_path / "arm.jsonld")
    monkeypatch.chdir(tmp_path)
    if "baseline" in shown.text:
        assert main(["--partial", "arm.jsonld", "--write-baseline"]) == 0
        capsys.readouterr()

    code = main(["--partial", "--trust", "arm.jsonld"])

    assert (code, capsys.readouterr().err) == (0, "")


def test_an_excuse_is_a_statement_on_the_node(tmp_path, monkeypatch, capsys):
    """Both that the program shows silence the finding."""
    shown = next(one for one in blocks(USING, language="json") if "ignore" in one.text)
    model = (ROOT / "samples/broken/missing-unit.jsonld").read_text("utf-8")
    monkeypatch.chdir(tmp_path)
    excuses = re.findall(r'"kl:ignore": ("\w+"|\{[^}]*\})', shown.text)

    assert len(excuses) == 2
    for excuse in excuses:
        assert "UNI001" in excuse
        excused = re.sub(
            r'("@id": "[^"]*",)(\s*"@type": \[[^]]*"(?:Position|Vector|Joint)\w*Coordinate)',
            rf'\1 "kl:ignore": {excuse},\2',
            model,
        ).replace('"@context": [', '"@context": [ {"kl": "https://w3id.org/kinlint/ns#"},', 1)
        (tmp_path / "model.jsonld").write_text(excused, "utf-8")
        assert main(["model.jsonld", "--select", "UNI001", "--show-suppressed"]) == 0, excused
        assert "UNI001" in capsys.readouterr().out


def test_an_excuse_is_a_comment_in_xml(tmp_path, monkeypatch, capsys):
    """As the program shows it, above a root link that has an inertia."""
    (shown,) = blocks(USING, language="xml")
    (code,) = re.findall(r"ignore\[(\w+)\]", shown.text)
    inertia = '<inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>'
    link = f'<link name="base"><inertial><mass value="1"/>{inertia}</inertial></link>'
    text = '<robot name="arm">\n{}{}\n<link name="tip"/>{}</robot>\n'
    joint = '<joint name="j" type="fixed"><parent link="base"/><child link="tip"/></joint>'
    monkeypatch.chdir(tmp_path)

    for comment, expected in (("", 1), (shown.text, 0)):
        (tmp_path / "arm.urdf").write_text(text.format(comment, link, joint))
        assert main(["arm.urdf", "--select", code, "--fail-on", "info"]) == expected
        capsys.readouterr()


def test_the_fix_that_the_program_shows_is_what_is_shown(monkeypatch, capsys):
    """Below its finding, in a sample."""
    (shown,) = (one for one in blocks(USING, language="text") if "help: " in one.text)
    monkeypatch.chdir(ROOT / "samples" / "broken")

    main(["--isolated", "inverted-limit.jsonld"])

    assert shown.text in capsys.readouterr().out
