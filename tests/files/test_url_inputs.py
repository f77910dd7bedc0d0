"""Files by URL are checked as those of a directory are, in the one process and by workers."""

from __future__ import annotations

import os
import re
import zipfile
from pathlib import Path

import pytest

from kinlint.cli.main import main

SAMPLES = Path(__file__).parents[2] / "samples"
MACRO = """<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
<xacro:macro name="arm"><link name="base"/><link name="tip"/>
<joint name="j" type="revolute"><parent link="base"/><child link="tip"/>
<limit lower="2" upper="1" effort="1" velocity="1"/></joint></xacro:macro></robot>"""
ROBOT = """<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
<xacro:include filename="$(find arm)/macros/arm.xacro"/><xacro:arm/></robot>"""
MESHES = """<robot name="m"><link name="a"><visual><geometry>
<mesh filename="package://arm/meshes/{0}.stl"/></geometry></visual></link></robot>"""
ROBOTS = '<robot name="{0}"><link name="a"/><joint name="j"/></robot>'
INCLUDING = """<robot name="a" xmlns:xacro="http://www.ros.org/wiki/xacro">
<xacro:include filename="{0}"/><link name="b"/></robot>"""
CONFIGURATION = '[tool.kinlint]\nselect = ["SRC"]\nrules = ["evil"]\n'


@pytest.fixture
def tree(tmp_path):
    """A package with an include, a mesh that is there, one that is not, and a configuration."""
    files = {
        "arm/package.xml": "<package><name>arm</name></package>",
        "arm/macros/arm.xacro": MACRO,
        "arm/urdf/arm.urdf.xacro": ROBOT,
        "arm/urdf/there.urdf": MESHES.format("there").replace('"m"', '"there"'),
        "arm/urdf/lost.urdf": MESHES.format("lost").replace('"m"', '"lost"'),
        "arm/meshes/there.stl": "solid a\nendsolid a\n",
        "arm/pyproject.toml": CONFIGURATION,
        "arm/build/old.urdf": "<robot/>",
    }
    for number in range(9):
        name = f"r{number}"
        files[f"{name}/{name}.urdf"] = (
            f'<robot name="{name}"><link name="a"/><joint name="j"/></robot>'
        )
    for name, text in files.items():
        path = tmp_path / "bucket" / "robots" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return tmp_path / "bucket"


def said(capsys, *arguments: str) -> list[str]:
    capsys.readouterr()
    main([*arguments, "--isolated", "--no-cache", "--output", "json-lines"])
    told = capsys.readouterr()
    assert "error:" not in told.err
    return told.out.splitlines()


@pytest.fixture
def expected(tree, capsys, monkeypatch, rules_cache):
    """The findings in the files themselves; the working directory is not above them."""
    found = said(capsys, str(tree / "robots"))
    (tree.parent / "elsewhere").mkdir()
    monkeypatch.chdir(tree.parent / "elsewhere")
    assert any("GEO001" in each for each in found)
    assert any("LIM001" in each and "macros/arm.xacro" in each for each in found)
    return found


def alike(lines: list[str], start: str) -> list[str]:
    """Return findings without the place that their files have in common, and without fixes."""
    every = [re.sub(r'"fix": .*?, "iri"', '"iri"', each.replace(start, "")) for each in lines]
    return sorted(re.sub(r'"iri": .*', "", each) for each in every)


def archive(tree: Path) -> Path:
    made = tree.parent / "robots.zip"
    with zipfile.ZipFile(made, "w") as stream:
        for path in sorted(tree.rglob("*.*")):
            stream.write(path, path.relative_to(tree))
    return made


@pytest.mark.slow
@pytest.mark.parametrize("form", ["zip://robots::{0}", "zip://{0}/robots", "zip://{0}"])
def test_members_of_an_archive(form, tree, expected, capsys):
    """Includes, packages and meshes are found in it; its configuration does not count."""
    pytest.importorskip("fsspec")
    found = said(capsys, form.format(archive(tree)))

    assert alike(found, f"zip://{tree.parent}/robots.zip!/") == alike(expected, f"{tree}/")


@pytest.fixture
def bucket(tree, monkeypatch):
    """The address of a bucket with the tree on the loopback interface."""
    server = pytest.importorskip("moto.server", reason="moto is not installed; the extra 'test' is")
    pytest.importorskip("s3fs", reason="s3fs is not installed; the extra 'test' brings it")
    client = pytest.importorskip("boto3").client
    served = server.ThreadedMotoServer(ip_address="127.0.0.1", port=0, verbose=False)
    served.start()
    host, port = served.get_host_and_port()
    address = f"http://{host}:{port}"
    for name, value in {
        "AWS_ENDPOINT_URL": address,
        "AWS_ACCESS_KEY_ID": "somebody",
        "AWS_SECRET_ACCESS_KEY": "secret",
        "AWS_DEFAULT_REGION": "us-east-1",
    }.items():
        monkeypatch.setenv(name, value)
    store = client("s3", endpoint_url=address)
    store.create_bucket(Bucket="bucket")
    for path in tree.rglob("*.*"):
        store.put_object(
            Bucket="bucket", Key=path.relative_to(tree).as_posix(), Body=path.read_bytes()
        )
    yield "s3://bucket/"
    served.stop()


@pytest.mark.slow
def test_files_in_a_bucket(bucket, tree, expected, capsys):
    """By one process, by several, and by the workers of a cluster, which have no files."""
    distributed = pytest.importorskip("distributed")
    whole = f"{bucket}robots"
    found = said(capsys, whole)

    assert alike(found, bucket) == alike(expected, f"{tree}/")
    assert said(capsys, whole, "--jobs", "2") == found
    with distributed.LocalCluster(n_workers=2, dashboard_address=":0") as cluster:
        place = cluster.scheduler_address.replace("tcp://", "dask://")
        assert said(capsys, whole, "--executor", place) == found
    some = said(capsys, f"{bucket}robots/**/*.{{urdf,xyz}}", "--jobs", "2")
    assert [each for each in found if '.urdf", "code' in each] == some


def test_nothing_is_written_by_url(tree, capsys):
    pytest.importorskip("fsspec")

    assert main([f"zip://{archive(tree)}", "--fix", "--isolated"]) == 2
    assert "--fix is not for files by URL" in capsys.readouterr().err


@pytest.mark.slow
@pytest.mark.parametrize(
    ("address", "cause"),
    [
        ("nonsense://robots/a.urdf", "Protocol not known"),
        ("zip://robots/none.zip", "No such file"),
        ("zip://missing/**::{0}", "no file matches"),
    ],
)
def test_what_an_address_lacks_is_told(address, cause, tree, capsys):
    pytest.importorskip("fsspec")
    code = main([address.format(archive(tree)), "--isolated"])
    told = capsys.readouterr()

    assert cause.lower() in (told.out + told.err).lower(), (code, told)


def test_a_model_names_no_other_address(tmp_path, monkeypatch, capsys):
    """What a file includes by URL, or elsewhere on this machine, is not read."""
    pytest.importorskip("fsspec")
    secret = tmp_path / "secret.xacro"
    secret.write_text('<robot><link name="secret"/></robot>')
    made = tmp_path / "r.zip"
    with zipfile.ZipFile(made, "w") as stream:
        stream.writestr("a.xacro", INCLUDING.format("s3://other/x.xacro"))
        stream.writestr("b.xacro", INCLUDING.format(secret))
        stream.writestr("c.xacro", INCLUDING.format("../" * 12 + os.fspath(secret)[1:]))
    (tmp_path / "here").mkdir()
    monkeypatch.chdir(tmp_path / "here")
    main([f"zip://{made}", "--isolated", "--no-cache", "--output", "concise"])

    assert capsys.readouterr().out.count("SRC018") == 3
