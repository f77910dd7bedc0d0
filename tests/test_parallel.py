"""Several processes: what they report is what one reports."""

import gc
import json
import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from support.interrupts import accept_interrupts
from support.linting import book, source

from kinlint.cli.main import main
from kinlint.configuration.settings import Settings
from kinlint.document import Document
from kinlint.formats.dependencies.file_groups import group_sources
from kinlint.parallel import processes, shard
from kinlint.parallel.early_findings import counted
from kinlint.parallel.runner import ParallelRunner
from kinlint.parallel.shard import Job
from kinlint.reporters.fixability import fixable
from kinlint.text import SourceText

pytestmark = pytest.mark.slow

XMLNS = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
JOINT = '<joint name="j{0}" type="revolute"><parent link="base"/><child link="hed"/></joint>'
MEMBERS = '<link name="base"/>\n' + "\n".join(map(JOINT.format, range(3)))
WRONG = """<robot name="{0}"><link name="l">
<visual><geometry><sphere radius="1.3"/></geometry></visual><inertial><mass value="16"/>
<inertia ixx="0.087" iyy="0.763" izz="0.908" ixy="0.14" ixz="0.912" iyz="0.0012"/>
</inertial></link></robot>"""
FORMATS = ("full", "concise", "json", "json-lines", "sarif", "github")


@pytest.fixture
def robots(tmp_path, rules_cache, monkeypatch):
    """A directory of robots in several formats, some of which include each other."""
    monkeypatch.chdir(tmp_path)
    for number in range(5):
        (tmp_path / f"r{number}.urdf").write_text(f'<robot name="r{number}">{MEMBERS}</robot>')
    (tmp_path / "R4.sdf").write_text('<sdf version="1.9"><model name="R4"/></sdf>')
    part = f"<robot {XMLNS}><xacro:macro name='m' params='n'><lnik/></xacro:macro></robot>"
    (tmp_path / "part.xacro").write_text(part)
    for number in range(2):
        call = f'<xacro:include filename="part.xacro"/><xacro:m n="1"/>{MEMBERS}'
        (tmp_path / f"x{number}.xacro").write_text(
            f'<robot name="x{number}" {XMLNS}>{call}</robot>'
        )
    world = '<include><uri>inner.sdf</uri></include><link name="a"/><link name="a"/>'
    (tmp_path / "outer.sdf").write_text(f'<sdf version="1.9"><model name="o">{world}</model></sdf>')
    inner = '<model name="i"><lnik/></model>'
    (tmp_path / "inner.sdf").write_text(f'<sdf version="1.9">{inner}</sdf>')
    comment = "<!-- kinlint: ignore[UNI002] a unit -->"
    (tmp_path / "quiet.urdf").write_text(f'<robot name="q">{comment}<link name="a"/></robot>')
    return tmp_path


def _said(capsys, *arguments):
    capsys.readouterr()
    code = main(["--isolated", *arguments])
    out, err = capsys.readouterr()
    return code, *(re.sub(r"\d+\.\d+ s|\d{4}-\d\d-\d\dT[\d:.]+Z", "…", text) for text in (out, err))


def test_a_fix_does_not_depend_on_what_is_linted_beside(tmp_path, monkeypatch, capsys, rules_cache):
    """Numbers of computed nodes, which count in a whole share, order nothing by their digits."""
    monkeypatch.chdir(tmp_path)
    names = [f"r{number}" for number in range(8)]
    for name in names:
        Path(f"{name}.urdf").write_text(WRONG.format(name))
    told = ["--no-cache", "--select=INE002", "--output-format=json-lines"]
    beside = _said(capsys, *told, "--jobs=1", ".")[1].splitlines()
    alone = [
        line for each in names for line in _said(capsys, *told, f"{each}.urdf")[1].splitlines()
    ]
    assert "DELETE DATA" in alone[0]
    assert beside == alone


def test_one_process_keeps_no_document_of_the_models_before(
    tmp_path, monkeypatch, capsys, rules_cache
):
    """With whatever else makes memory grow with the number of files."""
    monkeypatch.chdir(tmp_path)
    for number in range(40):
        Path(f"r{number}.urdf").write_text(WRONG.format(f"r{number}"))
    lint, kept = shard.lint_shard, []

    def counting(*given):
        kept.append(sum(isinstance(each, Document) for each in gc.get_objects()))
        return lint(*given)

    monkeypatch.setattr(shard, "lint_shard", counting)
    gc.collect()
    gc.disable()
    try:
        _said(capsys, ".", "--no-cache", "--jobs=1", "--output-format=json-lines", "-q")
    finally:
        gc.enable()
    assert len(kept) > 3
    assert max(kept) == kept[0]


def test_every_report_is_that_of_one_process(robots, capsys):
    """Byte by byte, but for times and the number of processes that was asked for."""
    for form in FORMATS:
        arguments = [".", "--output-format", form]
        one, many = (_said(capsys, *arguments, "-j", jobs) for jobs in ("1", "3"))

        assert one[0] == 1
        if form == "sarif":
            one, many = (_without_invocation(each) for each in (one, many))
        assert many == one


def _without_invocation(said):
    code, out, err = said
    log = json.loads(out)
    for run in log["runs"]:
        run.pop("invocations", None)
    return code, json.dumps(log), err


def test_a_composable_model_is_judged_whole(robots, capsys):
    """Names may join it with any other file."""
    (robots / "arm.jsonld").write_text('{"@context": {}, "@id": "x:a"}')
    one, many = (_said(capsys, ".", "-q", "-j", jobs) for jobs in ("1", "3"))

    assert many == one


def test_a_file_that_cannot_be_read_decides_for_all(robots, capsys):
    """Then no suppression is called unused, in whichever process it stands."""
    (robots / "bad.urdf").write_text("<robot name='r'>" + "<a>" * 300)
    one, many = (_said(capsys, ".", "--output-format", "concise", "-j", jobs) for jobs in "13")

    assert one[0] == 2
    assert many == one


def test_without_processes_one_does_it(robots, capsys, monkeypatch):
    """Some systems have no semaphores, or let nobody begin a process."""
    one = _said(capsys, ".", "-j", "1")

    def refuse(*_, **__):
        raise OSError("no more processes")

    monkeypatch.setattr("concurrent.futures.ProcessPoolExecutor", refuse)
    assert _said(capsys, ".", "-j", "3") == one


def test_a_process_that_dies_is_no_reason_to_fail(robots, capsys, monkeypatch):
    """One does it then."""
    one = _said(capsys, ".", "-j", "1")
    monkeypatch.setattr(processes, "_begin", _die)
    assert _said(capsys, ".", "-j", "3") == one


def _die(*_):
    os._exit(1)


@pytest.mark.parametrize("number", ["abc", "-1", "1.5", ""])
def test_a_number_of_processes_is_a_number(capsys, number):
    """Told in one line."""
    code, out, err = _said(capsys, ".", f"--jobs={number}")
    assert (code, out) == (2, "")
    assert "jobs" in err
    assert "Traceback" not in err


def test_as_many_as_there_are_processors(robots, capsys):
    """`-j 0` is a number of its own."""
    assert _said(capsys, ".", "-j", "0") == _said(capsys, ".", "-j", "1")


@pytest.mark.skipif(os.name == "nt", reason="signals of POSIX")
@pytest.mark.parametrize(("number", "code"), [(signal.SIGINT, 130), (signal.SIGKILL, -9)])
def test_who_ends_the_run_ends_all_of_it(robots, capsys, number, code):
    """No traceback, and nobody who goes on alone."""
    many = "".join(f'<link name="l{n}"/>' + JOINT.format(f"oint{n}") for n in range(4000))
    for each in range(4):
        (robots / f"long{each}.urdf").write_text(f'<robot name="long{each}">{many}</robot>')
    command = [sys.executable, "-m", "kinlint", ".", "-j", "3", "-q", "--isolated"]
    run = subprocess.Popen(
        command,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        start_new_session=True,
        preexec_fn=accept_interrupts,  # noqa: PLW1509  no other thread runs then
    )
    children = Path(f"/proc/{run.pid}/task/{run.pid}/children")
    if not children.exists():
        run.kill()
        run.communicate()
        pytest.skip("no /proc that lists the children of a process")
    begun = []
    while len(begun) < 2 and run.poll() is None:
        time.sleep(0.05)
        begun = children.read_text().split()
    time.sleep(0.3)
    os.kill(run.pid, number)
    _, err = run.communicate(timeout=600)

    assert run.returncode == code
    assert err == b""
    end = time.monotonic() + 240
    while (left := [*filter(_runs, begun)]) and time.monotonic() < end:
        time.sleep(0.1)
    assert not left


def _runs(process):
    """Tell whether a process goes on; one that ended may wait for a parent to ask for its code."""
    try:
        state = Path(f"/proc/{process}/stat").read_text("ascii")
    except (FileNotFoundError, ProcessLookupError):
        return False
    return state.rpartition(")")[2].split()[0] not in "ZX"


@pytest.mark.parametrize(
    ("texts", "together"),
    [
        ({"a.urdf": '<robot name="a"/>', "b.urdf": '<robot name="b"/>'}, []),
        ({"a.urdf": '<robot name="Arm"/>', "b.sdf": "<sdf><model name='arm'/></sdf>"}, ["ab"]),
        ({"a.urdf": '<robot name="a"/>', "b.srdf": '<robot name="b"/>'}, ["ab"]),
        (
            {
                "a.xacro": f'<robot name="a" {XMLNS}><xacro:include filename="d/b.xacro"/></robot>',
                "d/b.xacro": f"<robot {XMLNS}/>",
                "c.xacro": f'<robot name="c" {XMLNS}/>',
            },
            ["ab"],
        ),
        (
            {
                "a.sdf": "<sdf><model name='a'><include><uri>model://x</uri></include></model></sdf>",
                "x/model.sdf": "<sdf><model name='b'/></sdf>",
                "c.sdf": "<sdf><model name='c'/></sdf>",
            },
            ["am"],
        ),
        (
            {
                name: f'<robot name="{name}" {XMLNS}><xacro:include filename="z.xacro"/></robot>'
                for name in ("a.xacro", "b.xacro")
            },
            ["ab"],
        ),
        (
            {
                "a.xacro": f'<robot name="$(arg n)" {XMLNS}/>',
                "b.urdf": '<robot name="b"/>',
            },
            ["ab"],
        ),
        (
            {
                "a.urdf": '<robot name="x"/>',
                "b.xml": '<mujoco model="X"/>',
                "c.xml": '<mujoco model="y"/>',
            },
            ["ab"],
        ),
        ({"a.urdf": '<robot name="x"/>', "b.xml": '<mujoco model="y"/>'}, ["ab"]),
        (
            {
                "p/a.urdf": '<robot name="x"/>',
                "p/A.usda": "#usda 1.0",
                "q/a.usda": "#usda 1.0",
            },
            ["aA"],
        ),
    ],
)
def test_what_is_judged_together(texts, together):
    """Robots of one name, files that include each other or the same, and what may be either."""
    groups = list(group_sources([SourceText(name, text) for name, text in texts.items()]))
    joined = ["".join(each.name.split("/")[-1][0] for each in group) for group in groups]

    assert sum(map(len, groups)) == len(texts)
    assert [one for one in joined if len(one) > 1] == together


def test_the_samples(capsys, monkeypatch, rules_cache):
    """What the project itself has, of all formats."""
    monkeypatch.chdir(Path(__file__).parents[1])
    arguments = ["samples/urdf", "samples/sdf", "--output-format", "concise"]
    assert _said(capsys, *arguments, "-j", "2") == _said(capsys, *arguments, "-j", "1")


@pytest.mark.parametrize("cached", [False, True])
def test_models_that_include_others_share_the_work_unless_it_is_recorded(
    cached, tmp_path, monkeypatch, capsys, rules_cache
):
    """A fault of what both include is told once."""
    (tmp_path / "lamps.xml").write_text(
        '<mujocoinclude><light nmae="sun"/><geom size="0.1" tpye="box"/></mujocoinclude>'
    )
    for name in "ab":
        (tmp_path / f"{name}.xml").write_text(
            f'<mujoco model="{name}"><worldbody><include file="lamps.xml"/>'
            f'<body><geom size="0.1" mas{name}="1"/></body></worldbody></mujoco>'
        )
    monkeypatch.chdir(tmp_path)
    shares: list[int] = []
    lint = shard.lint_shard

    def counting(share, *others):
        shares.append(len(share))
        return lint(share, *others)

    monkeypatch.setattr(shard, "lint_shard", counting)
    options = ["a.xml", "b.xml", "--output-format", "concise", "--quiet"]
    _, out, _ = _said(capsys, *options, *([] if cached else ["--no-cache"]))
    alone = [_said(capsys, name, *options[2:], "--no-cache")[1] for name in ("a.xml", "b.xml")]

    assert shares[0] == (1 if cached else 2)
    assert set(out.splitlines()) == {line for text in alone for line in text.splitlines()}
    assert out.count("lamps.xml") == 2


def test_what_is_told_is_counted_without_its_texts():
    """A summary says the same of it, and no text is kept for it."""
    job = Job(Settings(), book(), fixing=True)
    whole = ParallelRunner(job).report([source(WRONG.format("r"), "r.urdf")], ())
    few = counted(whole)
    assert fixable(few.findings) == fixable(whole.findings) != (0, 0)
    assert [each.rule.code for each in few.findings] == [each.rule.code for each in whole.findings]
    assert not any(each.edits or each.update for one in few.findings for each in one.fixes)
    assert not any(one.location.source.text for one in few.findings)
    assert few.unfixed == ()
