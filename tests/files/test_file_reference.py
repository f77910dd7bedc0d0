"""Whether files that a model names are there: told from packages and directories that are not."""

import os

import pytest

from kinlint.files.file_exists import AbsentDirectory, Missing, References, UnknownPackage
from kinlint.files.packages import Packages


@pytest.fixture
def fault(tmp_path):
    """Looks a reference up beside files; `pkg` is a package that lies elsewhere."""

    def look(written, *files, near="robot"):
        for each in ("robot/arm.urdf", "pkg/package.xml", *files):
            path = tmp_path / each
            path.parent.mkdir(parents=True, exist_ok=True)
            path.touch()
        packages = Packages({"pkg": tmp_path / "pkg"}, environment={})
        return References(packages).fault(written, tmp_path / near)

    return look


@pytest.mark.parametrize(
    ("written", "file"),
    [
        ("meshes/a.stl", "robot/meshes/a.stl"),
        ("./a.stl", "robot/a.stl"),
        ("../pkg/a.stl", "pkg/a.stl"),
        ("package://pkg/meshes/a.stl", "pkg/meshes/a.stl"),
        ("package://pkg//a.stl", "pkg/a.stl"),
        ("model://pkg/a%20b.stl", "pkg/a b.stl"),
    ],
)
def test_what_is_there_has_no_fault(fault, written, file):
    """From the file on, or in a package."""
    assert fault(written, file) is None


@pytest.mark.parametrize(
    "written",
    [
        "",
        "/nowhere/a.stl",
        "file:///nowhere/a.stl",
        "https://example.org/a.stl",
        "C:\\a.stl",
        "${dir}/a.stl",
        "package://pkg/$(arg x).stl",
        "~/a.stl",
    ],
)
def test_what_leads_elsewhere_is_left_alone(fault, written):
    """Other rules judge what is written so."""
    assert fault(written) is None


@pytest.mark.parametrize(
    ("written", "file", "meant"),
    [
        ("meshes/a.stl", "robot/meshes/A.STL", "meshes/A.STL"),
        ("Meshes/a.stl", "robot/meshes/a.stl", "meshes/a.stl"),
        ("package://pkg/Meshes/a.stl", "pkg/meshes/a.stl", "package://pkg/meshes/a.stl"),
        ("../Meshes/a.stl", "meshes/a.stl", "../meshes/a.stl"),
    ],
)
def test_case_matters(fault, written, file, meant):
    """Even where the file system would not mind."""
    assert fault(written, file) == Missing(meant)


def test_a_file_of_that_name_elsewhere_is_meant(fault):
    """If there is only one."""
    assert fault("mesh/a.stl", "robot/meshes/a.stl") == Missing("meshes/a.stl")
    assert fault("shapes/a.stl", "robot/other/a.stl") == AbsentDirectory("shapes")


def test_a_name_nearby_is_meant(fault):
    """In the directory where it should be."""
    assert fault("meshes/bse.stl", "robot/meshes/base.stl") == Missing("meshes/base.stl")


def test_one_of_several_files_is_missing(fault):
    """Meshes are there, but not this one."""
    assert fault("meshes/wheel.dae", "robot/meshes/123456789.stl") == Missing()


@pytest.mark.parametrize(
    ("written", "files", "absent"),
    [
        ("meshes/visual/a.stl", (), "meshes"),
        ("meshes/visual/a.stl", ("robot/meshes/readme.md",), "meshes/visual"),
        ("meshes/a.stl", ("robot/meshes/readme.md", "robot/meshes/wood.png"), "meshes"),
        ("a.stl", (), "."),
        ("package://pkg/meshes/a.stl", (), "package://pkg/meshes"),
        ("package://pkg/a.stl", (), "package://pkg"),
    ],
)
def test_a_checkout_without_meshes_has_no_directory(fault, written, files, absent):
    """Then nobody can say whether the file would be there."""
    assert fault(written, *files) == AbsentDirectory(absent)


def test_packages_may_be_unknown(fault):
    """Which is told of the package, not of its files."""
    assert fault("package://other/a.stl") == UnknownPackage("other")
    assert fault("model://other/a.stl") == UnknownPackage("other")


def test_a_package_may_be_above_the_file(fault, tmp_path):
    """By the name of its manifest."""
    (tmp_path / "robot").mkdir()
    (tmp_path / "robot" / "package.xml").write_text("<package><name>arm</name></package>")

    assert (
        fault("package://arm/a.stl", "robot/urdf/x.urdf", "robot/a.stl", near="robot/urdf") is None
    )


def test_directories_are_read_once(fault, tmp_path, monkeypatch):
    """However many files refer to them."""
    read = []
    scandir = os.scandir
    monkeypatch.setattr(os, "scandir", lambda path: read.append(path) or scandir(path))
    (tmp_path / "meshes").mkdir()
    (tmp_path / "meshes" / "a.stl").touch()
    references = References(Packages(environment={}))
    for number in range(9):
        references.fault(f"meshes/{number}.stl", tmp_path)
        references.fault("meshes/a.stl", tmp_path)

    assert len(read) == len(set(read))
