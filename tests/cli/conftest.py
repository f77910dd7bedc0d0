"""A working directory of its own, and a pipeline that finds what a test says."""

import pipeline as pipelines
import pytest

from kinlint.cli.main import main

MODEL = '{"@context": "https://example.org/c.json"}'


@pytest.fixture(autouse=True)
def here(tmp_path, rules_cache, monkeypatch):
    """An empty working directory, and no settings from outside."""
    monkeypatch.chdir(tmp_path)
    for name in ("OUTPUT_FORMAT", "OUTPUT_FILE", "TRACEBACK"):
        monkeypatch.delenv(f"KINLINT_{name}", raising=False)
    for name in ("NO_COLOR", "FORCE_COLOR", "CLICOLOR_FORCE"):
        monkeypatch.delenv(name, raising=False)
    return tmp_path


@pytest.fixture
def pipeline(monkeypatch):
    """What the command drives, and what it finds."""
    return pipelines.install(monkeypatch)


@pytest.fixture
def write(here):
    """Make a file, a small model unless told otherwise."""

    def make(name, text=MODEL):
        path = here / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, "utf-8")
        return path

    return make


@pytest.fixture
def kinlint(capsys):
    """Run the command: its exit code, standard output and standard error."""

    def run(*arguments):
        capsys.readouterr()
        code = main([str(argument) for argument in arguments])
        return (code, *capsys.readouterr())

    return run


@pytest.fixture
def model(pipeline, write):
    """The pipeline, with a file to feed it."""
    write("arm.jsonld")
    return pipeline
