"""Packages are found where users, workspaces and environments keep them, and nowhere else."""

import os

import pytest

from kinlint.files import packages
from kinlint.files.packages import Packages


def package(directory, name=None):
    directory.mkdir(parents=True, exist_ok=True)
    (directory / "package.xml").write_text(
        f"<?xml version='1.0'?>\n<!-- <name>no</name> -->\n<package>\n"
        f"  <name> {name or directory.name} </name>\n</package>"
    )
    return directory


def find(name, near, **how):
    return Packages(environment=how.pop("environment", {}), **how).find(name, near)


def test_what_the_user_says_comes_first(tmp_path):
    package(tmp_path / "arm")
    assert find("arm", tmp_path / "arm", given={"arm": tmp_path}) == tmp_path


def test_the_package_above_by_its_manifest(tmp_path):
    home = package(tmp_path / "checkout", "arm")
    assert find("arm", home / "urdf" / "parts") == home
    assert find("no", home / "urdf") is None


@pytest.mark.parametrize("text", ["", "<package><name>arm</name"])
def test_a_broken_manifest_stands_for_the_name_of_the_directory(tmp_path, text):
    (package(tmp_path / "src" / "arm") / "package.xml").write_text(text)
    near = tmp_path / "src" / "deep" / "down"
    assert find("arm", near, workspace=tmp_path) == tmp_path / "src" / "arm"


def test_the_directory_above_by_its_name(tmp_path):
    (tmp_path / "arm" / "urdf").mkdir(parents=True)
    assert find("arm", tmp_path / "arm" / "urdf") == tmp_path / "arm"


def test_a_package_beside(tmp_path):
    package(tmp_path / "src" / "arm")
    hand = package(tmp_path / "src" / "hand")
    assert find("hand", tmp_path / "src" / "arm" / "urdf") == hand


def test_a_directory_of_the_name_of_another_package_is_not_meant(tmp_path):
    package(tmp_path / "src" / "hand", "other")
    assert find("hand", package(tmp_path / "src" / "arm")) is None


def test_the_workspace_below_the_configuration(tmp_path):
    home = package(tmp_path / "libraries" / "hands" / "hand")
    near = tmp_path / "robots" / "cell" / "deep" / "down" / "below" / "all"
    assert find("hand", near) is None
    assert find("hand", near, workspace=tmp_path) == home


def test_the_repository_is_the_workspace_without_a_configuration(tmp_path):
    (tmp_path / ".git").mkdir()
    home = package(tmp_path / "libraries" / "hand")
    assert find("hand", tmp_path / "robots" / "cell") == home


@pytest.mark.parametrize("mark", packages.IGNORED)
def test_directories_that_build_tools_ignore(tmp_path, mark):
    home = package(tmp_path / "old" / "hand")
    assert find("hand", tmp_path / "arm", workspace=tmp_path) == home
    (tmp_path / "old" / mark).touch()
    assert find("hand", tmp_path / "arm", workspace=tmp_path) is None


def test_builds_and_packages_in_packages_are_not_searched(tmp_path):
    package(tmp_path / "build" / "hand")
    package(package(tmp_path / "arm") / "third_party" / "finger")
    assert find("hand", tmp_path / "x", workspace=tmp_path) is None
    assert find("finger", tmp_path / "x", workspace=tmp_path) is None


def test_links_do_not_make_a_search_endless(tmp_path):
    (tmp_path / "src").mkdir()
    (tmp_path / "src" / "loop").symlink_to(tmp_path, target_is_directory=True)
    assert find("hand", tmp_path, workspace=tmp_path) is None


def test_a_search_ends(tmp_path, monkeypatch):
    monkeypatch.setattr(packages, "DIRECTORIES", 3)
    for name in "abcdef":
        package(tmp_path / "src" / name)
    assert find("a", tmp_path / "x", workspace=tmp_path) == tmp_path / "src" / "a"
    assert find("f", tmp_path / "x", workspace=tmp_path) is None


def test_ros_package_path(tmp_path):
    hand, arm = package(tmp_path / "one" / "hand"), package(tmp_path / "arm")
    environment = {"ROS_PACKAGE_PATH": f"{tmp_path / 'one'}:{arm}:{tmp_path / 'nowhere'}"}
    assert find("hand", tmp_path / "x", environment=environment) == hand
    assert find("arm", tmp_path / "x" / "y", environment=environment) == arm


def test_ament_prefix_path(tmp_path):
    (tmp_path / "share" / "hand").mkdir(parents=True)
    environment = {"AMENT_PREFIX_PATH": str(tmp_path)}
    assert find("hand", tmp_path / "x", environment=environment) == tmp_path / "share" / "hand"


@pytest.mark.parametrize("name", ["", ".", "..", "a/b", "../x"])
def test_what_is_no_name_is_no_package(tmp_path, name):
    assert find(name, tmp_path, workspace=tmp_path) is None


def test_uris(tmp_path):
    home, models = package(tmp_path / "arm"), tmp_path / "models"
    (models / "table").mkdir(parents=True)
    found = Packages(environment={"GZ_SIM_RESOURCE_PATH": str(models)})
    near = home / "urdf"
    assert found.resolve("package://arm/meshes/a%20b.stl", near) == home / "meshes" / "a b.stl"
    assert found.resolve("package://hand/a.stl", near) is None
    assert found.resolve("model://table/model.sdf", near) == models / "table" / "model.sdf"
    assert found.resolve("package://table/model.sdf", near) is None
    assert found.resolve("meshes/a.stl", near) is None
    assert found.resolve("https://example.org/a.stl", near) is None


def test_the_search_ends_whatever_links_and_pipes_lie_in_the_way(tmp_path):
    """A link to itself, one to the directory above, and a manifest that nobody ever writes."""
    arm = tmp_path / "arm"
    (arm / "urdf").mkdir(parents=True)
    (arm / "self").symlink_to("self")
    (arm / "up").symlink_to("..")
    (tmp_path / "pipe").mkdir()
    os.mkfifo(tmp_path / "pipe" / "package.xml")
    (arm / "package.xml").write_text("<package><name>arm_description</name></package>")
    packages = Packages(workspace=tmp_path, environment={"ROS_PACKAGE_PATH": str(arm / "up")})
    assert packages.find("arm_description", arm / "urdf") == arm
    assert packages.find("hand", arm / "urdf") is None
    assert packages.find("..", arm / "urdf") is None
    assert packages.resolve("package://../../etc/passwd", arm) is None


def test_what_is_linted_comes_before_the_repository(tmp_path):
    """And that in the order in which it was named."""
    one, two = package(tmp_path / "one" / "hand"), package(tmp_path / "two" / "hand")
    (tmp_path / "three" / ".git").mkdir(parents=True)
    three = package(tmp_path / "three" / "lib" / "hand")
    near = tmp_path / "three" / "robots" / "cell"
    assert find("hand", near) == three
    assert find("hand", near, linted=(tmp_path / "two", tmp_path / "one")) == two
    assert find("hand", near, linted=(tmp_path / "one",)) == one


@pytest.mark.parametrize("space", packages.SPACES)
def test_the_workspace_of_a_build_tool(tmp_path, space):
    """It has `src` beside what is built; several repositories may lie in it.

    Before anything is built, a package is known to lie in one by `src` above it; not by its own.
    """
    hand = package(tmp_path / "ws" / "src" / "hands" / "hand")
    near = package(tmp_path / "ws" / "src" / "arms" / "arm") / "urdf"
    loose = tmp_path / "ws" / "src" / "loose"
    inside = package(tmp_path / "alone") / "src" / "arms"
    package(tmp_path / "alone" / "src" / "hands" / "hand")
    assert find("hand", near) == hand
    assert find("hand", loose / "urdf") is None
    assert find("hand", inside) is None
    (tmp_path / "ws" / space).mkdir()
    assert find("hand", near) == hand
    assert find("hand", loose / "urdf") == hand
    assert find("hand", tmp_path / "x") is None


@pytest.mark.parametrize(
    "place", ["install/share/hand", "install/hand/share/hand", "devel/share/hand"]
)
def test_the_install_space_of_the_workspace(tmp_path, place):
    """For packages whose source is not there."""
    near = tmp_path / "src" / "arm" / "urdf"
    near.mkdir(parents=True)
    home = package(tmp_path / place)
    assert find("hand", near) == home


def test_the_order_of_the_environment(tmp_path):
    """Ament, then rospack, then CMake; a prefix of CMake has a manifest, or says its sources."""
    ament, cmake = tmp_path / "ament", tmp_path / "cmake"
    environment = {
        "AMENT_PREFIX_PATH": str(ament),
        "ROS_PACKAGE_PATH": str(tmp_path / "ros"),
        "CMAKE_PREFIX_PATH": str(cmake),
    }
    near = tmp_path / "x"
    (cmake / "share" / "hand").mkdir(parents=True)
    assert find("hand", near, environment=environment) is None
    (cmake / ".catkin").write_text(f"{tmp_path / 'sources'}")
    source = package(tmp_path / "sources" / "hand")
    assert find("hand", near, environment=environment) == source
    installed = package(cmake / "share" / "hand")
    assert find("hand", near, environment=environment) == installed
    ros = package(tmp_path / "ros" / "hand")
    assert find("hand", near, environment=environment) == ros
    (ament / "share" / "hand").mkdir(parents=True)
    assert find("hand", near, environment=environment) == ament / "share" / "hand"


def test_how_a_package_was_found_is_told(tmp_path):
    """In words, for `-v`."""
    home = package(tmp_path / "ros" / "hand")
    found = Packages(environment={"ROS_PACKAGE_PATH": str(tmp_path / "ros")})
    assert found.locate("hand", tmp_path / "x") == (home, "by ROS_PACKAGE_PATH")
    assert found.locate("foot", tmp_path / "x") is None
