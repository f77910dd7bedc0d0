"""Files that others name are read only in their project and in packages that they can name."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.linting import lint

from kinlint.files.bounded_read import Unreadable
from kinlint.files.packages import Packages
from kinlint.files.project_reach import ProjectReach
from kinlint.formats.xacro.included_files import TABLES
from kinlint.project.discovery import Search

SECRET = "hunter2"  # noqa: S105  nobody's
XACRO = '<robot name="a" xmlns:xacro="http://www.ros.org/wiki/xacro">{}</robot>'
TWICE = '<link name="l_{0}"/><link name="l_{0}"/>'


@pytest.fixture
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A home directory with a clone in which the linter runs, and secrets beside it."""
    for name in ("clone/.git", "clone/urdf", "secret", "robots/arm"):
        (tmp_path / name).mkdir(parents=True)
    (tmp_path / "robots/arm/package.xml").write_text("<package><name>arm</name></package>")
    (tmp_path / "robots/arm/arm.yaml").write_text("password: public")
    for suffix in TABLES:
        (tmp_path / f"secret/pass{suffix}").write_text(f'{{"password": "{SECRET}"}}')
    (tmp_path / "secret/pass.xacro").write_text(
        XACRO.format(f'<xacro:property name="password" value="{SECRET}"/>')
    )
    (tmp_path / "secret/robot.urdf").write_text(f'<robot name="r">{TWICE.format(SECRET)}</robot>')
    (tmp_path / "clone/link.yaml").symlink_to(tmp_path / "secret/pass.yaml")
    (tmp_path / "clone/directory").symlink_to(tmp_path / "secret")
    (tmp_path / "clone/robot.urdf").symlink_to(tmp_path / "secret/robot.urdf")
    monkeypatch.chdir(tmp_path / "clone")
    return tmp_path


TABLE = """<xacro:property name="d" value="${load_yaml('PATH')}"/>""" + TWICE.format(
    "${d['password']}"
)
INCLUDE = '<xacro:include filename="PATH"/>' + TWICE.format("${password}")
TRICKS = [
    TABLE.replace("PATH", "{home}/secret/pass.yaml"),
    TABLE.replace("PATH", "../../secret/pass.yml"),
    TABLE.replace("PATH", "../../secret/pass.json"),
    TABLE.replace("PATH", "../link.yaml"),
    TABLE.replace("PATH", "../directory/pass.yaml"),
    TABLE.replace("PATH", "../urdf/../../secret/pass.yaml"),
    TABLE.replace("PATH", "$(find secret)/pass.yaml"),
    TABLE.replace("PATH", "package://secret/pass.yaml"),
    TABLE.replace("PATH", "package://arm/../../secret/pass.yaml"),
    TABLE.replace("PATH", "$(find robots)/../secret/pass.yaml"),
    TABLE.replace("PATH", "$(find clone)/../secret/pass.yaml"),
    TABLE.replace("PATH", "$(dirname)/../../secret/pass.yaml"),
    INCLUDE.replace("PATH", "{home}/secret/pass.xacro"),
    INCLUDE.replace("PATH", "../../secret/pass.xacro"),
    INCLUDE.replace("PATH", "../directory/pass.xacro"),
    INCLUDE.replace("PATH", "../../secret/*.xacro"),
    INCLUDE.replace("PATH", "$(find secret)/pass.xacro"),
]


def messages(text: str, file: Path) -> str:
    """Return all that is said of *text* in *file*."""
    return " ".join(each.message for each in lint(text, str(file)).findings)


@pytest.mark.parametrize("trick", TRICKS)
def test_no_xacro_file_reads_beyond_the_project(home: Path, trick: str) -> None:
    robot = home / "clone/urdf/arm.urdf.xacro"
    said = messages(XACRO.format(trick.replace("{home}", str(home))), robot)
    assert SECRET not in said


def test_what_lies_in_the_project_is_read(home: Path) -> None:
    (home / "clone/pass.yaml").write_text("password: public")
    text = XACRO.format(TABLE.replace("PATH", "../pass.yaml"))
    assert "l_public" in messages(text, home / "clone/urdf/arm.urdf.xacro")


def test_no_glob_lists_what_is_outside(home: Path) -> None:
    robot = home / "clone/arm.urdf.xacro"
    text = XACRO.format('<xacro:include filename="../secret/*"/>')
    assert "pass" not in messages(text, robot)


def test_links_out_of_the_project_are_not_found(home: Path) -> None:
    """A file that is named is read, wherever it lies; a file rather than a link to it."""
    (home / "clone/own.urdf").symlink_to(home / "clone/urdf/real.urdf")
    (home / "clone/urdf/real.urdf").write_text("<robot/>")
    for given, own in ((".", "urdf/real.urdf"), ("*.urdf", "own.urdf")):
        found = Search(lambda _: ()).find([given])
        assert own in {each.name for each in found.inputs}
        assert "robot.urdf" not in {each.name for each in found.inputs}
    (named,) = Search(lambda _: ()).find(["robot.urdf"]).inputs
    assert named.name == "robot.urdf"


def reaches(path: Path, near: Path, packages: Packages) -> bool:
    try:
        ProjectReach(near, packages).require(path)
    except Unreadable:
        return False
    return True


def test_packages_that_can_be_named_are_within_reach(home: Path) -> None:
    near, arm = home / "clone/urdf/a.xacro", home / "robots/arm/arm.yaml"
    secret = home / "secret/pass.yaml"
    assert not reaches(arm, near, Packages(environment={}))
    for found in (
        Packages({"arm": home / "robots/arm"}, environment={}),
        Packages(environment={"ROS_PACKAGE_PATH": str(home / "robots")}),
    ):
        assert reaches(arm, near, found)
        assert not reaches(secret, near, found)
    assert reaches(secret, near, Packages(environment={}, linted=(home,)))


def test_a_submodule_belongs_to_the_repository_around_it(home: Path) -> None:
    module = home / "clone/module"
    module.mkdir()
    (module / ".git").write_text("gitdir: ../.git/modules/module")
    assert reaches(home / "clone/urdf/a.xacro", module / "b.xacro", Packages(environment={}))
    assert not reaches(home / "secret/pass.yaml", module / "b.xacro", Packages(environment={}))


def test_where_nothing_marks_a_project_it_is_what_lies_around(
    home: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir("/")
    near = home / "robots/a/urdf/a.xacro"
    assert reaches(home / "robots/a/meshes/b.yaml", near, Packages(environment={}))
    monkeypatch.setenv("HOME", str(home / "robots"))
    assert not reaches(home / "robots/b.yaml", near, Packages(environment={}))
