"""Fixes of what is written in files that others include."""

import io
import sys
from pathlib import Path

import pytest
from mending import book, repair

from kinlint.cli import fix_files
from kinlint.cli.main import main
from kinlint.configuration.settings import Settings
from kinlint.fixes import writable
from kinlint.fixes.rounds import fix_in_rounds, lint_texts
from kinlint.formats.decoding import decode
from kinlint.project.discovery import Input
from kinlint.rule import Applicability

ROBOT = """<?xml version="1.0"?>
<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="{included}"/>
  <link name="base"/>
  <xacro:finger side="left" length="0.1"/>
  <xacro:finger side="right" length="0.2"/>
</robot>
"""
MACROS = """<?xml version="1.0"?>\r
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">\r
  <xacro:macro name="finger" params="side length">\r
    <link name="${side}_finger"/>   <!-- stays -->\r
    <joint name="${side}" type="prismatic">\r
      <parent link="base"/><child link="${side}_finger"/>\r
      <limit lower="2.60" upper="-1" effort="1" velocity="1"/>\r
    </joint>\r
  </xacro:macro>\r
</robot>\r
"""
ALL = """<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="macros.xacro"/>
</robot>
"""
SWAPPED = MACROS.replace('lower="2.60" upper="-1"', 'lower="-1" upper="2.60"')
LIMITS = {
    "target": "sh:targetObjectsOf urdf:limit",
    "select": """SELECT $this (at:lower AS ?path) ?value ?upper WHERE {
        $this at:lower ?value ; at:upper ?upper . FILTER (?value > ?upper) }""",
}
SWAP = """DELETE { $this at:lower $value ; at:upper ?upper }
    INSERT { $this at:lower ?upper ; at:upper $value } WHERE {}"""
WORLD = """<sdf version="1.9">
  <world name="w">
    <include><uri>part</uri><name>one</name></include>
    <include><uri>part/model.sdf</uri><name>two</name></include>
  </world>
</sdf>
"""
PART = """<sdf version="1.9">
  <model name="part">
    <link name="l"><inertial><mass>-1.50</mass></inertial></link>
  </model>
</sdf>
"""


@pytest.fixture
def limits(tmp_path):
    """A rule with a repair of limits the wrong way round."""
    return rules_in(tmp_path, {**LIMITS, "repairs": [repair(SWAP)]})


@pytest.fixture
def here(tmp_path, monkeypatch):
    """The directory of work."""
    directory = tmp_path / "work"
    directory.mkdir()
    monkeypatch.chdir(directory)
    return directory


def rules_in(directory, *rules):
    (directory / "rules").mkdir(exist_ok=True)
    return book(directory / "rules", *rules)


def put(**files):
    """Writes files; their names have `__` for a dot."""
    for name, text in files.items():
        path = Path(name.replace("__", "."))
        path.parent.mkdir(exist_ok=True)
        path.write_bytes(text.encode())


def sources(*names):
    return [decode(name, Path(name).read_bytes()) for name in names]


def fix(rules, *names, streamed=()):
    """Mends the files of *names* on disk; the report of what is left, and the files written."""
    texts = sources(*names)
    outcome = fix_in_rounds(texts, (), Settings(), rules, Applicability.SAFE, None, streamed)
    report = fix_files.write_fixes(outcome, [Input(name, Path(name).absolute()) for name in names])
    return report, [before.name for before, _ in outcome.changed]


def refused(rules, *names):
    """The findings in the files of *names*, and why they are not fixed."""
    offers = lint_texts(sources(*names), (), Settings(), rules)
    assert not any(finding.fixes for finding in offers.report.findings)
    return len(offers.report.findings), [why for _, _, why in offers.report.unfixed]


def test_a_macro_that_is_used_twice_is_mended_once(here, limits):
    """In the file that it stands in, every other byte as it was."""
    put(arm__xacro=ROBOT.format(included="macros.xacro"), macros__xacro=MACROS)
    (finding,) = lint_texts(sources("arm.xacro"), (), Settings(), limits).report.findings
    (offer,) = finding.fixes
    assert [(edit.location.source.name, edit.text) for edit in offer.edits] == [
        ("macros.xacro", "-1"),
        ("macros.xacro", "2.60"),
    ]
    (here / "macros.xacro").chmod(0o640)

    report, changed = fix(limits, "arm.xacro")

    assert (changed, report.findings, report.errors) == (["macros.xacro"], (), ())
    assert len(report.fixed) == 1
    assert (here / "macros.xacro").read_bytes() == SWAPPED.encode()
    assert (here / "macros.xacro").stat().st_mode & 0o777 == 0o640
    assert fix(limits, "arm.xacro")[1] == []


def test_files_that_are_linted_themselves_are_mended_once(here, limits):
    """Whichever comes first, and of however many robots they are a part."""
    robot = ROBOT.format(included="macros.xacro")
    for names in (("arm.xacro", "macros.xacro", "b.xacro"), ("macros.xacro", "b.xacro")):
        put(arm__xacro=robot, macros__xacro=MACROS, b__xacro=robot.replace('"arm"', '"b"'))
        report, changed = fix(limits, *names)
        assert (changed, report.findings, report.errors) == (["macros.xacro"], (), ())
        assert (here / "macros.xacro").read_bytes() == SWAPPED.encode()


def test_a_text_stays_that_only_some_of_its_uses_want_to_change(here, tmp_path):
    """Since the others would change with it."""
    left = 'FILTER (?value > ?upper && CONTAINS(STR($this), "left")) }'
    select = LIMITS["select"].replace("FILTER (?value > ?upper) }", left)
    rules = rules_in(tmp_path, {**LIMITS, "select": select, "repairs": [repair(SWAP)]})
    put(arm__xacro=ROBOT.format(included="macros.xacro"), macros__xacro=MACROS)

    assert refused(rules, "arm.xacro") == (1, ["the text stands for several elements"])


def test_a_text_stays_that_another_robot_uses_as_it_is(here, tmp_path):
    """The robot of another file, in which nothing is at fault."""
    arm = 'FILTER (?value > ?upper && CONTAINS(STR($this), "arm.xacro")) }'
    select = LIMITS["select"].replace("FILTER (?value > ?upper) }", arm)
    rules = rules_in(tmp_path, {**LIMITS, "select": select, "repairs": [repair(SWAP)]})
    robot = ROBOT.format(included="macros.xacro")
    put(arm__xacro=robot, macros__xacro=MACROS)
    put(more__xacro=robot.replace('"macros', '"all'), all__xacro=ALL)

    assert refused(rules, "arm.xacro", "more.xacro") == (1, ["the text would say something else"])
    assert fix(rules, "arm.xacro")[1] == ["macros.xacro"]


def test_new_elements_in_a_macro_come_once(here, tmp_path):
    """And so do elements and attributes that go."""
    put(arm__xacro=ROBOT.format(included="macros.xacro"), macros__xacro=MACROS)
    insert = 'INSERT { $this urdf:axis _:a . _:a at:xyz "1 0 0" } WHERE {}'
    select = "SELECT $this WHERE { $this urdf:limit ?l . FILTER NOT EXISTS { $this urdf:axis ?a } }"
    joints = {"target": "sh:targetObjectsOf urdf:joint", "select": select}
    rules = rules_in(tmp_path, {**joints, "repairs": [repair(insert)]})
    fix(rules, "arm.xacro")
    axis = '      <axis xyz="1 0 0"/>\r\n    </joint>'
    assert (here / "macros.xacro").read_bytes().decode() == MACROS.replace("    </joint>", axis)

    select = "SELECT $this ?a WHERE { $this urdf:axis ?a }"
    delete = "DELETE { $this urdf:axis ?a } WHERE {}"
    rules = rules_in(tmp_path, {**joints, "select": select, "repairs": [repair(delete)]})
    fix(rules, "arm.xacro")
    assert (here / "macros.xacro").read_bytes().decode() == MACROS


def test_a_model_that_is_included_twice_is_mended_once(here, tmp_path):
    """By a directory without a manifest or by a file, both the same."""
    put(**{"world__sdf": WORLD, "part/model__sdf": PART})
    select = "SELECT $this ?m WHERE { $this src:text ?t . BIND (ABS(?t) AS ?m) FILTER (?t < 0) }"
    update = "DELETE { $this src:text ?t } INSERT { $this src:text ?m } WHERE { $this src:text ?t }"
    masses = {"target": "sh:targetObjectsOf sdf:mass", "select": select}
    rules = rules_in(tmp_path, {**masses, "repairs": [repair(update)]})

    report, changed = fix(rules, "world.sdf")

    assert (changed, report.findings) == (["part/model.sdf"], ())
    assert (here / "part/model.sdf").read_text() == PART.replace("-1.50", "1.50")


def test_files_of_others_stay(here, limits):
    """Those that lie neither below what is linted nor where kinlint runs."""
    (here.parent / ".git").mkdir()
    put(arm__xacro=ROBOT.format(included="../other/macros.xacro"))
    put(**{"../other/macros__xacro": MACROS})
    reason = "it is written in ../other/macros.xacro, which is not among the linted files"

    assert refused(limits, "arm.xacro") == (1, [reason])

    put(**{"../other/arm__xacro": ROBOT.format(included="macros.xacro")})
    assert fix(limits, "../other/arm.xacro")[1] == ["../other/macros.xacro"]
    assert Path("../other/macros.xacro").read_bytes() == SWAPPED.encode()


def test_installed_files_stay(here, limits, monkeypatch):
    """Wherever kinlint runs."""
    put(arm__xacro=ROBOT.format(included="install/macros.xacro"))
    put(**{"install/macros__xacro": MACROS})
    assert fix(limits, "arm.xacro")[1] == []
    monkeypatch.setattr(writable, "SYSTEM", (here / "ros",))
    put(**{"arm__xacro": ROBOT.format(included="ros/macros.xacro"), "ros/macros__xacro": MACROS})
    assert fix(limits, "arm.xacro")[1] == []


def test_files_that_may_not_be_written_stay(here, limits):
    """And the reason is told."""
    put(arm__xacro=ROBOT.format(included="macros.xacro"), macros__xacro=MACROS)
    (here / "macros.xacro").chmod(0o444)

    reason = "it is written in macros.xacro, which cannot be written to"
    assert refused(limits, "arm.xacro") == (1, [reason])


def test_a_file_that_changed_meanwhile_stays(here, limits):
    """It is an error, and nothing counts as fixed."""
    put(arm__xacro=ROBOT.format(included="macros.xacro"), macros__xacro=MACROS)
    outcome = fix_in_rounds(sources("arm.xacro"), (), Settings(), limits, Applicability.SAFE)
    put(macros__xacro=MACROS.replace("stays", "new"))

    report = fix_files.write_fixes(outcome, [Input("arm.xacro", here / "arm.xacro")])

    assert [str(error) for error in report.errors] == [
        "macros.xacro: not fixed: the file has changed since it was read"
    ]
    assert report.fixed == ()
    assert b"new" in (here / "macros.xacro").read_bytes()


def test_what_standard_input_includes_stays(here, limits):
    """Since nobody knows whether the text that comes will ever be that of the file."""
    put(arm__xacro=ROBOT.format(included="macros.xacro"), macros__xacro=MACROS)

    assert fix(limits, "arm.xacro", streamed={"arm.xacro"})[1] == []


def test_the_command_mends_what_is_included(here, rules_cache, capsys):
    """Prints the difference under the name of that file, and writes it."""
    put(arm__xacro=ROBOT.format(included="macros.xacro"), macros__xacro=MACROS)
    ours = ("arm.xacro", "--select", "LIM001", "--unsafe-fixes")

    assert main([*ours, "--diff"]) == 1
    assert "--- macros.xacro" in capsys.readouterr().out
    assert (here / "macros.xacro").read_bytes() == MACROS.encode()
    assert main([*ours, "--fix"]) == 0
    assert (here / "macros.xacro").read_bytes() == SWAPPED.encode()


@pytest.mark.parametrize("mark", [b"", b"\xef\xbb\xbf"])
def test_bytes_of_no_encoding_come_out_as_they_came(here, rules_cache, mark, monkeypatch):
    """What cannot be written back is not touched."""
    data = mark + b'<?xml version="1.0"?><robot name="caf\xe9"><link name="base"/></robot>\r\n'
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(data)))
    written = io.BytesIO()
    monkeypatch.setattr(sys, "stdout", io.TextIOWrapper(written))

    main(["-", "--stdin-filename", "arm.urdf", "--fix"])

    sys.stdout.flush()
    assert written.getvalue() == data
