"""What changed since a revision of git, and what files held then."""

import pytest
from gitting import commit, git, needs_git

from kinlint.errors import UsageError
from kinlint.files.pathname import real
from kinlint.files.revision import Repository
from kinlint.project.revision_checkout import checkout

pytestmark = needs_git


@pytest.fixture
def tree(tmp_path):
    """A repository with a commit."""
    top = real(tmp_path) / "a tree, ü"
    top.mkdir()
    git(top, "init", "--quiet")
    for name, text in (
        ("a.urdf", "a\n" * 9),
        ("b ü,: 𝄞.urdf", "b\n" * 9),
        ("sub/c.urdf", "c\n" * 9),
    ):
        (top / name).parent.mkdir(exist_ok=True)
        (top / name).write_text(text, "utf-8")
    (top / ".gitignore").write_text("*.log\nout/\n", "utf-8")
    commit(top)
    return top


def at(tree, name="HEAD"):
    return Repository.from_directory(tree).revision(name)


def test_nothing_changed(tree):
    """A tree as it was committed; also as seen from below its top."""
    revision = at(tree / "sub")
    assert revision.repository.top == tree
    assert (dict(revision.changed), revision.deleted) == ({}, frozenset())


def test_changed_new_and_deleted(tree):
    """Whether git was told of it or not; what it ignores is nothing."""
    (tree / "a.urdf").write_text("other\n", "utf-8")
    (tree / "b ü,: 𝄞.urdf").write_text("other\n", "utf-8")
    (tree / "new é.urdf").write_text("new\n", "utf-8")
    (tree / "told.urdf").write_text("told\n", "utf-8")
    (tree / "x.log").write_text("log\n", "utf-8")
    git(tree, "add", "told.urdf")
    (tree / "sub/c.urdf").unlink()

    revision = at(tree)
    assert dict(revision.changed) == {
        tree / "a.urdf": tree / "a.urdf",
        tree / "b ü,: 𝄞.urdf": tree / "b ü,: 𝄞.urdf",
        tree / "new é.urdf": None,
        tree / "told.urdf": None,
    }
    assert revision.deleted == {tree / "sub/c.urdf"}


@pytest.mark.parametrize("told", [False, True])
def test_renamed(tree, told):
    """Also by a plain `mv`; neither the index nor the working tree is touched."""
    (tree / "a.urdf").rename(tree / "sub/ä a.urdf")
    if told:
        git(tree, "add", "--all")
    index = (tree / ".git/index").read_bytes()

    revision = at(tree)
    assert dict(revision.changed) == {tree / "sub/ä a.urdf": tree / "a.urdf"}
    assert revision.deleted == frozenset()
    assert (tree / ".git/index").read_bytes() == index


def test_text_at_a_revision(tree):
    """In the order that was asked for; what was not there is left out."""
    (tree / "a.urdf").write_text("other\n", "utf-8")
    names = ["sub/c.urdf", "nothing", "a.urdf", "b ü,: 𝄞.urdf"]
    read = at(tree).read(tree / name for name in names)
    assert [(path.name, data[:1]) for path, data in read.items()] == [
        ("c.urdf", b"c"),
        ("a.urdf", b"a"),
        ("b ü,: 𝄞.urdf", b"b"),
    ]


def test_merge_base(tree):
    """Where the branch began, whatever happened to the other one since."""
    base = git(tree, "rev-parse", "HEAD")
    git(tree, "checkout", "--quiet", "-b", "mine")
    (tree / "mine.urdf").write_text("mine\n", "utf-8")
    commit(tree)
    git(tree, "checkout", "--quiet", "main")
    (tree / "a.urdf").write_text("theirs\n", "utf-8")
    commit(tree)
    git(tree, "checkout", "--quiet", "mine")

    revision = Repository.from_directory(tree).merge_base("main")
    assert revision.commit == base
    assert dict(revision.changed) == {tree / "mine.urdf": None}

    git(tree, "checkout", "--quiet", "--orphan", "apart")
    commit(tree)
    with pytest.raises(UsageError, match="'main' and HEAD have no commit in common"):
        Repository.from_directory(tree).merge_base("main")


@pytest.mark.parametrize(
    "name", ["nothing", "-x", "--all", "", "HEAD:a.urdf", "HEAD..HEAD", "a\0b"]
)
def test_unknown_revisions(tree, name):
    """None of them is an option, or anything but one commit."""
    with pytest.raises(UsageError, match="unknown revision"):
        at(tree, name)


def test_a_slip_of_a_name(tree):
    """Branches are known."""
    with pytest.raises(UsageError, match="unknown revision 'mian', did you mean 'main'"):
        at(tree, "mian")


def test_a_shallow_clone_says_so(tree, tmp_path):
    """What is missing was not fetched, and that is what to do."""
    (tree / "a.urdf").write_text("other\n", "utf-8")
    commit(tree)
    git(tmp_path, "clone", "--quiet", "--depth=1", tree.as_uri(), "clone")
    with pytest.raises(UsageError, match="unknown revision 'HEAD~1'; the clone is shallow"):
        at(tmp_path / "clone", "HEAD~1")


def test_a_second_working_tree(tree, tmp_path):
    """It has its own top, and shares the commits."""
    other = real(tmp_path) / "other"
    git(tree, "worktree", "add", "--quiet", "-b", "other", str(other))
    (other / "a.urdf").write_text("other\n", "utf-8")
    revision = at(other, "main")
    assert revision.repository.top == other
    assert dict(revision.changed) == {other / "a.urdf": other / "a.urdf"}


def test_submodules_are_left_out(tree, tmp_path):
    """What lies in them has a history of its own; it is there in a snapshot as it is now."""
    module = tmp_path / "module"
    module.mkdir()
    git(module, "init", "--quiet")
    (module / "m.urdf").write_text("m\n", "utf-8")
    commit(module)
    git(tree, "submodule", "--quiet", "add", module.as_uri(), "module")
    commit(tree)
    (tree / "module/m.urdf").write_text("other\n", "utf-8")

    revision = at(tree)
    assert (dict(revision.changed), revision.deleted) == ({}, frozenset())
    with checkout(revision) as root:
        assert (root / "module/m.urdf").read_text("utf-8") == "other\n"


def test_no_repository(tmp_path):
    """A sentence, not a traceback."""
    with pytest.raises(UsageError, match="not a git repository"):
        Repository.from_directory(tmp_path)


def test_a_bare_repository(tmp_path):
    """It has no working tree to compare to."""
    git(tmp_path, "init", "--quiet", "--bare", "bare.git")
    with pytest.raises(UsageError, match="no revision is known"):
        Repository.from_directory(tmp_path / "bare.git")


def test_no_git(tree, monkeypatch):
    """Who has none is told."""
    monkeypatch.setenv("PATH", "")
    with pytest.raises(UsageError, match="git is not installed"):
        Repository.from_directory(tree)


def test_a_snapshot_has_the_files_of_the_revision(tree):
    """As they were, without new ones, meshes empty, and what is ignored as it is now."""
    (tree / "arm.STL").write_bytes(b"solid")
    commit(tree)
    (tree / "a.urdf").write_text("other\n", "utf-8")
    (tree / "new.urdf").write_text("new\n", "utf-8")
    (tree / "sub/c.urdf").unlink()
    (tree / "arm.STL").unlink()
    (tree / "out").mkdir()
    (tree / "out/made.urdf").write_text("made\n", "utf-8")

    with checkout(at(tree)) as root:
        assert (root / "a.urdf").read_text("utf-8") == "a\n" * 9
        assert (root / "sub/c.urdf").read_text("utf-8") == "c\n" * 9
        assert (root / "arm.STL").read_bytes() == b""
        assert (root / "out/made.urdf").read_text("utf-8") == "made\n"
        assert not (root / "new.urdf").exists()
    assert not root.exists()
    assert (tree / "out/made.urdf").exists()


def test_what_git_lfs_keeps_comes_from_its_store(tree):
    """If it is there; nothing is fetched."""
    oid = "4d7a214614ab2935c943f9e0ff69d22eadbb8f32b1258daaa5e2ca24d17e2393"
    size = f"version https://git-lfs.github.com/spec/v1\noid sha256:{oid}\nsize 5\n"
    (tree / "a.urdf").write_text(size, "utf-8")
    commit(tree)
    (tree / "a.urdf").write_text("other\n", "utf-8")
    with checkout(at(tree)) as root:
        assert (root / "a.urdf").read_text("utf-8") == size
    kept = tree / ".git/lfs/objects" / oid[:2] / oid[2:4] / oid
    kept.parent.mkdir(parents=True)
    kept.write_text("12345", "utf-8")
    with checkout(at(tree)) as root:
        assert (root / "a.urdf").read_text("utf-8") == "12345"
