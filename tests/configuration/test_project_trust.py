"""Projects that the user trusts, and what others may not bring."""

from __future__ import annotations

import pytest

from kinlint.configuration.config_file import Configs
from kinlint.configuration.project_trust import ProjectTrust, untrusted_message
from kinlint.configuration.user_configuration import user_file
from kinlint.errors import ConfigError

CONFIG = 'rules = ["rules"]\nshapes = ["s.ttl"]\nxacro-env = ["TOKEN"]\nignore = ["UNI"]\n'


@pytest.fixture
def project(tmp_path):
    directory = tmp_path / "project"
    directory.mkdir()
    (directory / "kinlint.toml").write_text(CONFIG, "utf-8")
    return directory


@pytest.fixture
def user(tmp_path, monkeypatch):
    """Write the user's own configuration; its environment."""
    environment = {"XDG_CONFIG_HOME": str(tmp_path / "config"), "APPDATA": str(tmp_path / "config")}
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    monkeypatch.setenv("HOME", str(tmp_path))

    def write(text):
        path = user_file(environment)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, "utf-8")
        return environment

    return write


def nearest(directory, trust):
    return Configs(restrict=trust.restricted, may_extend=trust.may_extend).nearest(directory)


def test_a_project_brings_no_rules_by_itself(project, user):
    config = nearest(project, ProjectTrust.from_user(user("")))
    assert (config.rules, config.shapes, config.xacro_env) == (None, None, None)
    assert config.choices[0].ignore == ("UNI",)
    said = untrusted_message(config)
    assert "rules and shapes and xacro-env left out" in said
    assert "--trust" in said


@pytest.mark.parametrize("trusted", [".", "..", "../../project"])
def test_the_user_may_trust_directories(project, user, trusted):
    """Relative ones are relative to the user's configuration."""
    text = (
        f"trusted = ['{(project / trusted).resolve()}']"
        if trusted != "../../project"
        else ("trusted = ['../../project']")
    )
    config = nearest(project, ProjectTrust.from_user(user(text)))
    assert config.rules == (project / "rules",)
    assert config.xacro_env == ("TOKEN",)
    assert config.untrusted == ()


def test_the_home_directory_may_be_named(project, user):
    config = nearest(project, ProjectTrust.from_user(user("trusted = ['~/project']")))
    assert config.untrusted == ()


def test_a_directory_beside_is_not_trusted(project, user):
    text = f"trusted = ['{project}-other']"
    assert nearest(project, ProjectTrust.from_user(user(text))).untrusted


def test_everything_may_be_trusted_for_one_run(project, user):
    config = nearest(project, ProjectTrust.from_user(user(""), everything=True))
    assert config.shapes == (project / "s.ttl",)


@pytest.mark.parametrize("text", ["trusted = 1", "trusted = [1]", "rules = []", "trusted = ["])
def test_a_wrong_user_configuration_is_an_error(user, text):
    environment = user(text)
    with pytest.raises(ConfigError, match=r"config\.toml"):
        ProjectTrust.from_user(environment)


def test_paths_lead_out_of_trusted_projects_only(project, user):
    """Those to ROS packages always may."""
    for name in ("secret", "arm", "project/.git", "project/own"):
        (project.parent / name).mkdir()
    (project.parent / "arm/package.xml").write_text("<package><name>arm</name></package>")
    (project / "link").symlink_to(project.parent / "secret")
    (project / "kinlint.toml").write_text(
        """
        baseline = "../secret/b.json"
        [packages]
        a = "../secret"
        b = "link"
        c = "~"
        arm = "../arm"
        own = "own"
        [extra-contexts]
        "https://example.org/a" = "../secret/a.json"
        "https://example.org/b" = "own/b.json"
        [srdf]
        "*.srdf" = "../secret/a.urdf"
        """
    )
    config = nearest(project, ProjectTrust.from_user(user("")))
    assert [name for name, _ in config.packages] == ["arm", "own"]
    assert list(config.extra_contexts) == ["https://example.org/b"]
    assert (config.srdf, config.baseline) == ((), None)
    said = untrusted_message(config)
    assert "packages outside of it and extra-contexts outside of it and srdf" in said
    trusted = nearest(project, ProjectTrust(everything=True))
    assert (len(trusted.packages), len(trusted.srdf)) == (5, 1)
    assert trusted.baseline


def test_what_lies_elsewhere_is_not_extended(project, user, tmp_path):
    """Not even read: a message would tell its keys. In a trusted project it counts."""
    (tmp_path / "secret.toml").write_text('password = "hunter2"\n', "utf-8")
    (project / "kinlint.toml").write_text('extend = "../secret.toml"\nignore = ["UNI"]\n', "utf-8")
    config = nearest(project, ProjectTrust.from_user(user("")))
    assert config.choices[0].ignore == ("UNI",)
    assert "extend outside of it left out" in untrusted_message(config)
    with pytest.raises(ConfigError, match="password"):
        nearest(project, ProjectTrust(everything=True))
    (tmp_path / "secret.toml").write_text('select = ["ALL"]\n', "utf-8")
    assert nearest(project, ProjectTrust(directories=(tmp_path,))).choices[0].select == ("ALL",)


def test_links_lead_elsewhere_too(project, user, tmp_path):
    """A link in the project to a file outside of it, and a file of the project that extends one."""
    (tmp_path / "secret.toml").write_text('password = "hunter2"\n', "utf-8")
    (project / "base.toml").symlink_to(tmp_path / "secret.toml")
    (project / "middle.toml").write_text('extend = "base.toml"\nignore = ["LD"]\n', "utf-8")
    (project / "kinlint.toml").write_text('extend = "middle.toml"\n', "utf-8")
    config = nearest(project, ProjectTrust.from_user(user("")))
    assert config.choices[0].ignore == ("LD",)
    assert config.untrusted == ("extend",)
