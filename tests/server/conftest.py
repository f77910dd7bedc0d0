"""An editor for each test, under the profiles of three that count columns differently."""

import os
import sys
from pathlib import Path

import pytest
import pytest_asyncio

sys.path.insert(0, str(Path(__file__).parent))
from editor import PROFILES, Editor, started


@pytest.fixture(params=PROFILES)
def profile(request):
    """The client that the editor says that it is."""
    return request.param


@pytest_asyncio.fixture
async def stranger(profile, tmp_path, rules_cache):
    """An editor that did not say hello yet, in an empty folder."""
    here = tmp_path / "a folder, mit Ümläut"
    here.mkdir()
    client, capabilities = await started(profile, {**os.environ, "HOME": str(tmp_path)})
    editor = Editor(client, capabilities, here)
    yield editor
    if hasattr(editor, "said"):
        await client.shutdown_session()
    await client.stop()


@pytest_asyncio.fixture
async def editor(stranger):
    """An editor whose workspace is its folder."""
    return await stranger.begin()
