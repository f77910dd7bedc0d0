"""A directory of robots, and runs that remember."""

import pytest
from cache_runs import Runs


@pytest.fixture
def runs(tmp_path, rules_cache, monkeypatch, capsys):
    """Runs in a directory of their own, with the compiled catalogue and no report at first."""
    cache = tmp_path / "cache"
    cache.mkdir()
    for file in rules_cache.glob("catalogue-*.jsonl"):
        (cache / file.name).hardlink_to(file)
    monkeypatch.setenv("KINLINT_CACHE_DIR", str(cache))
    here = tmp_path / "here"
    here.mkdir()
    monkeypatch.chdir(here)
    return Runs(capsys, cache)


@pytest.fixture
def write(runs, tmp_path):
    """Make a file in the working directory."""

    def make(name, text):
        path = tmp_path / "here" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path

    return make
