"""`kinlint contexts` lists what is known, and adds a copy of what is not."""

from __future__ import annotations

import json
import threading
from collections.abc import Iterator
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest

from kinlint.cli import contexts_command

GRIPPER = "https://example.org/contexts/gripper.json"
CONTEXT = json.dumps({"@context": {"opening": "https://example.org/gripper#opening"}})
MODEL = json.dumps(
    {
        "@context": [GRIPPER, "https://w3id.org/kinlint/composable.json"],
        "@id": "https://example.org/arm#gripper",
        "@type": "RigidBody",
        "opening": 0.1,
    }
)


class Silent(SimpleHTTPRequestHandler):
    """A server that prints nothing."""

    def log_message(self, *_: object) -> None:
        """Print nothing."""


@pytest.fixture
def limit(monkeypatch: pytest.MonkeyPatch) -> int:
    """The size of the largest context that is added, a small one."""
    monkeypatch.setattr(contexts_command, "LARGEST", 1000)
    return 1000


@pytest.fixture
def address(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """The address of a server with `gripper.json` and `broken.json`."""
    top = tmp_path_factory.mktemp("served")
    (top / "gripper.json").write_text(CONTEXT)
    (top / "broken.json").write_text('{"@context": {"opening": {"@id": 1}}}')
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(Silent, directory=str(top)))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    yield f"http://127.0.0.1:{server.server_port}"
    server.shutdown()
    server.server_close()


@pytest.mark.parametrize("command", ["contexts", "version"])
def test_an_untrusted_project_extends_nothing_elsewhere(kinlint, write, tmp_path, command) -> None:
    """Messages would tell the keys of that file."""
    (tmp_path.parent / "secret.toml").write_text('password = "open sesame"\n', "utf-8")
    write("kinlint.toml", 'extend = "../secret.toml"\n')
    code, out, err = kinlint(command)
    assert code == 0
    assert "password" not in out + err


def test_what_is_known_is_listed(kinlint) -> None:
    """With the home of each; several releases are one."""
    code, out, _ = kinlint("contexts")
    homes = dict(line.split(maxsplit=1) for line in out.splitlines())
    assert code == 0
    assert homes["https://comp-rob2b.github.io/metamodels/qudt.json"] == "release ba7e601"
    assert homes["https://hbrs-sesame.github.io/metamodels/floor-plan/state.json"] == "hbrs-sesame"
    assert homes["https://secorolab.github.io/metamodels/floor-plan/state.json"] == "secorolab"
    assert homes["https://w3id.org/kinlint/kinematics.json"] == "kinlint"


@pytest.mark.parametrize(
    ("config", "before", "after"),
    [
        ("kinlint.toml", None, "[extra-contexts]\n{}\n"),
        ("kinlint.toml", 'select = ["LD"]', 'select = ["LD"]\n\n[extra-contexts]\n{}\n'),
        (
            "kinlint.toml",
            '[extra-contexts]\n"x:y" = "y.json"\n',
            '[extra-contexts]\n{}\n"x:y" = "y.json"\n',
        ),
        (
            "pyproject.toml",
            '[tool.kinlint]\nselect = ["LD"]\n',
            '[tool.kinlint]\nselect = ["LD"]\n\n[tool.kinlint.extra-contexts]\n{}\n',
        ),
    ],
)
def test_a_file_is_added(kinlint, write, here, config, before, after) -> None:  # noqa: PLR0913, PLR0917
    """A copy and an entry, after which models that name it are read whole."""
    write("g.json", CONTEXT)
    if before is not None:
        write(config, before)
        write("y.json", CONTEXT)
    entry = f'"{GRIPPER}" = "contexts/example.org/contexts/gripper.json"'

    code, out, _ = kinlint("contexts", "add", "g.json", "--for", GRIPPER)

    assert code == 0
    assert "contexts/example.org/contexts/gripper.json" in out
    assert (here / config).read_text() == after.format(entry)
    assert (here / "contexts/example.org/contexts/gripper.json").read_text() == CONTEXT
    write("model.jsonld", MODEL)
    assert "LD014" not in kinlint("model.jsonld", "--output-format", "concise")[1]
    assert kinlint("contexts", "add", "g.json", "--for", GRIPPER)[0] == 0
    assert (here / config).read_text() == after.format(entry)


@pytest.mark.slow
def test_an_address_is_downloaded(kinlint, address, here) -> None:
    """Because it is given; it answers by that address."""
    assert kinlint("contexts", "add", f"{address}/gripper.json")[0] == 0
    (copy,) = Path(here).glob("contexts/*/gripper.json")
    assert copy.read_text() == CONTEXT
    assert f"{address}/gripper.json" in kinlint("contexts")[1]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("arguments", "cause"),
    [
        (("add", "gone.json", "--for", GRIPPER), "No such file"),
        (("add", "g.json"), "say by which IRI"),
        (("add", "broken.json", "--for", GRIPPER), "not a context: @context @id value"),
        (("add", "list.json", "--for", GRIPPER), "it has no '@context'"),
        (("add", "text.json", "--for", GRIPPER), "not JSON"),
        (("add", "large.json", "--for", GRIPPER), "more than"),
        (("add", "file:///etc/hostname", "--for", GRIPPER), "No such file"),
        (("remove", "g.json"), "kinlint contexts add FILE-OR-URL adds one"),
        (("add", "{address}/gone.json"), "gone.json: "),
        (("add", "{address}/broken.json"), "not a context"),
    ],
)
def test_what_cannot_be_added(kinlint, write, address, limit, arguments, cause) -> None:  # noqa: PLR0913, PLR0917
    """Nothing is written."""
    write("g.json", CONTEXT)
    write("broken.json", '{"@context": {"opening": {"@id": 1}}}')
    write("list.json", "[]")
    write("text.json", "opening")
    write("large.json", CONTEXT + " " * limit)

    code, _, err = kinlint("contexts", *(each.format(address=address) for each in arguments))

    assert code == 2
    assert cause in err
    assert not Path("kinlint.toml").exists()
    assert not Path("contexts").exists()


@pytest.mark.parametrize("config", ['[extra-contexts]\n"%s" = "../other.json"\n', "", "list"])
def test_nothing_is_written_outside_of_the_project(kinlint, here, config, monkeypatch) -> None:
    """Neither where a configuration says so, nor by a link."""
    outside = here / "outside"
    (project := here / "project").mkdir()
    outside.mkdir()
    (project / "contexts").symlink_to(outside)
    (project.parent / "other.json").write_text("{}")
    text = 'extra-contexts = ["../outside"]\n' if config == "list" else config
    (project / "kinlint.toml").write_text(text % GRIPPER if "%s" in text else text)
    (project / "gripper.json").write_text(CONTEXT)
    monkeypatch.chdir(project)
    code, _, said = kinlint("contexts", "add", "gripper.json", "--for", GRIPPER)
    assert code == 2
    assert "is outside of the project" in said
    assert (project.parent / "other.json").read_text() == "{}"
    assert not list(outside.iterdir())
