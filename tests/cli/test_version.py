"""`kinlint version --verbose`: what to tell in a report of an error."""

import subprocess
import sys
from pathlib import Path

import pytest

from kinlint import __version__


def test_the_version(kinlint):
    """In a line of its own."""
    assert kinlint("version")[1] == f"kinlint {__version__}\n"


@pytest.mark.parametrize("option", ["-v", "--verbose"])
def test_what_it_runs_on(kinlint, here, monkeypatch, option):
    """Versions, hash and places; the home directory is not told."""
    monkeypatch.setenv("HOME", str(here))
    monkeypatch.setenv("KINLINT_CACHE_DIR", str(here / "cache"))
    code, out, _ = kinlint("version", option)
    facts = dict(line.split(": ", 1) for line in out.splitlines()[1:])
    assert code == 0
    assert set(facts) >= {"python", "platform", "pyoxigraph", "rdflib", "pyshacl", "owlrl", "pyld"}
    assert set(facts) >= {"rich", "pygls", "xacro", "rules", "shapes", "configuration"}
    assert facts["cache"].strip() == str(Path("~/cache"))
    assert facts["configuration"].strip() == "none here"
    assert "hash" in facts["rules"]
    assert str(here) not in out
    (here / "kinlint.toml").write_text("partial = true\n", "utf-8")
    assert "configuration: ~/kinlint.toml\n" in kinlint("version", option)[1]


def test_it_imports_nothing_heavy():
    """The versions come from what is installed, not from what is loaded."""
    program = (
        "import sys; from kinlint.cli.main import main; main(['version', '-v']);"
        "print([each for each in ('rdflib', 'pyshacl', 'owlrl', 'pyld', 'rich', 'pygls', 'xacro')"
        " if each in sys.modules])"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    assert done.stdout.splitlines()[-1] == "[]"
