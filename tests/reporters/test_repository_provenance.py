from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from reported import here, report, unit_finding

from kinlint.reporters.sarif.sarif_log import log
from kinlint.reporters.sarif.version_control import provenance, repository_top

REVISION = "d6084ce76a87f74ef24dcbfa0aa1708d15cf0bdc"
CONFIG = '[core]\n\tbare = false\n[remote "origin"]\n\turl = {}\n\tfetch = +refs/*\n'


def checkout(top: Path, url: str = "https://github.com/a/b.git") -> Path:
    git = top / ".git"
    (git / "refs" / "heads").mkdir(parents=True)
    (git / "config").write_text(CONFIG.format(url))
    (git / "HEAD").write_text("ref: refs/heads/main\n")
    (git / "refs" / "heads" / "main").write_text(f"{REVISION}\n")
    return git


@pytest.mark.parametrize(
    "url",
    [
        "https://github.com/a/b.git",
        "https://user:secret@github.com/a/b",
        "git@github.com:a/b.git",
        "ssh://git@github.com:22/a/b.git",
    ],
)
def test_the_repository_is_named_without_credentials(tmp_path: Path, url: str) -> None:
    checkout(tmp_path, url)
    assert provenance(str(tmp_path)) == {
        "repositoryUri": "https://github.com/a/b",
        "revisionId": REVISION,
        "branch": "main",
        "mappedTo": {"uriBaseId": "SRCROOT"},
    }


def test_packed_detached_and_unborn_heads_are_read(tmp_path: Path) -> None:
    git = checkout(tmp_path)
    (git / "refs" / "heads" / "main").unlink()
    unborn = provenance(str(tmp_path))
    assert unborn is not None
    assert "revisionId" not in unborn
    (git / "packed-refs").write_text(f"# pack-refs\n{REVISION} refs/heads/main\n")
    packed = provenance(str(tmp_path))
    assert packed is not None
    assert packed["revisionId"] == REVISION
    (git / "HEAD").write_text(f"{REVISION}\n")
    detached = provenance(str(tmp_path))
    assert detached is not None
    assert detached["revisionId"] == REVISION
    assert "branch" not in detached


def test_a_linked_working_tree_shares_the_configuration(tmp_path: Path) -> None:
    git = checkout(tmp_path / "main")
    own = git / "worktrees" / "other"
    own.mkdir(parents=True)
    (own / "commondir").write_text("../..\n")
    (own / "HEAD").write_text(f"{REVISION}\n")
    (tmp_path / "other").mkdir()
    (tmp_path / "other" / ".git").write_text(f"gitdir: {own}\n")
    found = provenance(str(tmp_path / "other"))
    assert found is not None
    assert found["repositoryUri"] == "https://github.com/a/b"


@pytest.mark.parametrize("url", ["/home/me/robots.git", "../b", ""])
def test_a_repository_on_no_server_is_called_by_its_directory(tmp_path: Path, url: str) -> None:
    top = tmp_path / "my robots"
    checkout(top, url)
    found = provenance(str(top))
    assert found is not None
    assert found["repositoryUri"] == "urn:kinlint:repository:my%20robots"
    assert found["revisionId"] == REVISION


def test_any_remote_on_a_server_will_do(tmp_path: Path) -> None:
    git = checkout(tmp_path, "../b")
    with (git / "config").open("a") as stream:
        stream.write('[remote "upstream"]\n\turl = https://github.com/c/d.git\n')
    found = provenance(str(tmp_path))
    assert found is not None
    assert found["repositoryUri"] == "https://github.com/c/d"


def test_an_unreadable_repository_is_none(tmp_path: Path) -> None:
    (tmp_path / ".git").mkdir()
    assert provenance(str(tmp_path)) is None


def test_uris_start_at_the_top_of_the_repository(tmp_path: Path) -> None:
    checkout(tmp_path)
    root = tmp_path / "robots"
    root.mkdir()
    assert repository_top(str(root)) == str(tmp_path)
    made = replace(report(unit_finding(here("x", 0, 1, name="arm.jsonld"))), root=str(root))
    (run,) = log(made)["runs"]
    place = run["results"][0]["locations"][0]["physicalLocation"]["artifactLocation"]
    assert place == {"uri": "robots/arm.jsonld", "uriBaseId": "SRCROOT"}
    assert run["versionControlProvenance"][0]["revisionId"] == REVISION


def test_files_of_two_places_have_no_common_provenance(tmp_path: Path) -> None:
    top = tmp_path / "top"
    checkout(top)
    findings = [unit_finding(here("x", 0, 1, name=name)) for name in ("a.jsonld", "../b.jsonld")]
    (run,) = log(replace(report(*findings), root=str(top)))["runs"]
    assert "versionControlProvenance" not in run
