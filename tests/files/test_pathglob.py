"""Patterns match paths as shells and git do."""

from pathlib import Path

import pytest

from kinlint.files.pathglob import Glob

ROOT = Path("/work [1]/robot")


@pytest.mark.parametrize(
    ("pattern", "path", "matches"),
    [
        ("arm.jsonld", "models/arm.jsonld", True),
        ("*.jsonld", "models/deep/arm.jsonld", True),
        ("models/*.jsonld", "models/arm.jsonld", True),
        ("models/*.jsonld", "models/deep/arm.jsonld", False),
        ("models/**/*.jsonld", "models/arm.jsonld", True),
        ("models/**/*.jsonld", "models/very/deep/arm.jsonld", True),
        ("./models/*.jsonld", "models/arm.jsonld", True),
        ("models", "models/arm.jsonld", True),
        ("models/", "models/arm.jsonld", True),
        ("models/deep", "models/deep/arm.jsonld", True),
        ("models/**", "models/deep/arm.jsonld", True),
        ("model?", "models/arm.jsonld", True),
        ("[!a]*.jsonld", "arm.jsonld", False),
        ("[a-c]rm.jsonld", "arm.jsonld", True),
        ("*.{jsonld,json}", "arm.json", True),
        ("*.{jsonld,json}", "arm.ttl", False),
        ("../robot/models/*", "models/arm.jsonld", True),
        ("/work [1]/robot/*", "arm.jsonld", False),
        ("/work [[]1[]]/robot/*", "arm.jsonld", True),
        ("!*.jsonld", "arm.jsonld", False),
        ("!*.jsonld", "arm.json", True),
        ("arm.jsonl", "arm.jsonld", False),
        ("a.m", "arm", False),
        ("[", "[", True),
        ("{", "{", True),
    ],
)
def test_what_a_pattern_covers(pattern, path, matches):
    """Names at any depth, paths from the root, directories with all they hold."""
    assert Glob(ROOT, pattern).covers(ROOT / path) is matches


def test_directories_above_the_root_are_not_looked_at():
    """A project may lie below a directory that is called like something to pass over."""
    assert not Glob(ROOT, "work*").covers(ROOT / "arm.jsonld")
    assert Glob(ROOT, "arm.*").covers(Path("/elsewhere/arm.jsonld"))


def test_matching_is_about_the_path_itself():
    """`matches` leaves out the directories above."""
    assert not Glob(ROOT, "models").matches(ROOT / "models" / "arm.jsonld")
    assert Glob(ROOT, "models").matches(ROOT / "models")


@pytest.mark.parametrize("pattern", ["[z-a]", "a[z-a]b", "[", "[]", "[!]", "[^]", "[[]", "[\\]"])
def test_a_class_that_is_none_means_itself(tmp_path, pattern):
    """No pattern is an error."""
    glob = Glob(tmp_path, pattern)

    assert glob.covers(tmp_path / pattern) or pattern in {"[[]", "[\\]"}
    assert not glob.covers(tmp_path / "zz")
