"""Measures what checking robots in a triple store costs, and a hundred times as many of them."""

from __future__ import annotations

import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from support import triple_store

from benchmarks.processes import KINLINT, PYTHON
from benchmarks.table import Row
from benchmarks.urdf_robot import urdf_chain
from kinlint.endpoint.connection import Endpoint
from kinlint.terms import literal_value

JOINTS = 6
"""Joints of a robot of 280 statements; 23 make a thousand."""
GROWN, TIMES = 120, 100
"""Most that so many times more robots may cost."""
MEMORY = 2**30
"""Most memory of a run, in bytes."""
WATCHED = """
import resource, subprocess, sys
subprocess.run(sys.argv[1:], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
used = resource.getrusage(resource.RUSAGE_CHILDREN)
print(used.ru_utime + used.ru_stime, used.ru_maxrss)
"""
"""Tells the CPU time and the memory of a command."""


@contextmanager
def served() -> Iterator[str]:
    """The address of an empty store on disk."""
    server = triple_store.program()
    if server is None:
        raise RuntimeError("Oxigraph's server is not installed; the extra 'test' brings it")
    with (
        tempfile.TemporaryDirectory() as directory,
        triple_store.served(server, "--location", directory) as url,
    ):
        yield url


def rows(url: str, robots: int, joints: int) -> Iterator[Row]:
    """Check *robots* of so many *joints*, and a hundred times as many, in the empty store at *url*.

    What either took is told while it runs: the larger one may take long.
    """
    made, costs = 0, []
    for count in (robots, TIMES * robots):
        with tempfile.TemporaryDirectory() as directory:
            for number in range(made, count):
                text = urdf_chain(joints).replace('"arm"', f'"arm{number:06}"')
                Path(directory, f"arm{number:06}.urdf").write_text(text, "utf-8")
            load = [KINLINT, "load", "--isolated", "--endpoint", url, directory]
            _tell(f"loading {count - made} robots", _cost(load))
        made = count
        check = [KINLINT, "check", "--isolated", "--jobs=1", "--output=json-lines"]
        costs.append(_cost([*check, "--endpoint", url]))
        _tell(f"checking {count} robots, {_statements(url)} statements", costs[-1])
    (few, small), (many, large) = costs
    titles = [
        f"`kinlint check --endpoint`, {n:,} robots of {joints} joints"
        for n in (TIMES * robots, robots)
    ]
    yield Row(f"{titles[0]}, CPU", titles[1], (many, few), target=GROWN)
    yield Row(f"{titles[0]}, memory", titles[1], (large, small), unit="B")


def _cost(command: Sequence[str]) -> tuple[float, int]:
    """Return the seconds of CPU and the bytes of memory that *command* takes."""
    told = subprocess.run([PYTHON, "-c", WATCHED, *command], stdout=subprocess.PIPE, check=True)
    seconds, memory = told.stdout.split()
    return float(seconds), int(memory) * (1 if sys.platform == "darwin" else 1024)


def _statements(url: str) -> int:
    query = "SELECT (COUNT(*) AS ?n) WHERE { GRAPH ?g { ?s ?p ?o } }"
    (row,) = Endpoint.from_user(url, None, {}, 3600).select(query)
    return int(literal_value(row["n"]))


def _tell(what: str, cost: tuple[float, int]) -> None:
    seconds, memory = cost
    sys.stderr.write(f"{what}: {seconds:.1f} s of CPU, {memory / 1e6:.0f} MB\n")
