"""A runner to lint robots."""

import shutil

import pytest
from workflow import Runner


@pytest.fixture
def runner(tmp_path, rules_cache):
    """A runner with an empty workspace."""
    if shutil.which("bash") is None:
        pytest.skip("there is no bash")
    return Runner(tmp_path, rules_cache)
