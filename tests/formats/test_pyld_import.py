"""PyLD is imported without what it would load from a network with."""

import subprocess
import sys

import pytest

IMPORT = """\
import sys
{before}
from kinlint.formats.jsonld import pyld
slow = {{"requests", "aiohttp", "asyncio", "lxml.html", "urllib.request"}}
print(sorted(slow & sys.modules.keys()))
import pyld.jsonld
print(type(pyld.jsonld.get_document_loader()).__name__)
"""
CLIENT = "from urllib.request import getproxies\n\nclass Session:\n    pass\n"
"""A client as `requests` is: it imports what kinlint postpones."""


@pytest.fixture
def imported(tmp_path):
    """Imports PyLD where both clients are installed: the lines that are printed then."""
    for client in ("requests", "aiohttp"):
        (tmp_path / f"{client}.py").write_text(CLIENT, "utf-8")

    def run(before=""):
        code = f"sys.path.insert(0, {str(tmp_path)!r})\n{before}"
        done = subprocess.run(
            [sys.executable, "-c", IMPORT.format(before=code)],
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.returncode == 0, done.stderr
        return done.stdout.splitlines()

    return run


def test_a_client_that_is_installed_is_not_used(imported):
    """Nor are the slow modules imported."""
    assert imported() == ["[]", "function"]


def test_a_client_that_is_in_use_stays(imported):
    """As in a program that imports kinlint."""
    assert imported("import requests")[0] == "['requests', 'urllib.request']"
