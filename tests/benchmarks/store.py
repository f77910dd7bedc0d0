"""Measures what checking robots in a triple store costs, and a hundred times as many of them."""

from __future__ import annotations

import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import AbstractContextManager
from pathlib import Path

from support import triple_store

from benchmarks.processes import KINLINT, PYTHON
from benchmarks.table import Row
from benchmarks.urdf_robot import urdf_chain

JOINTS = 6
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


def served() -> AbstractContextManager[str]:
    """An empty store, as the tests use."""
    server = triple_store.program()
    if server is None:
        raise RuntimeError("Oxigraph's server is not installed; the extra 'test' brings it")
    return triple_store.served(server)


def rows(url: str, robots: int) -> Iterator[Row]:
    """Check *robots*, and a hundred times as many, in the empty store at *url*."""
    made, costs = 0, []
    for count in (robots, TIMES * robots):
        with tempfile.TemporaryDirectory() as directory:
            for number in range(made, count):
                text = urdf_chain(JOINTS).replace('"arm"', f'"arm{number:06}"')
                Path(directory, f"arm{number:06}.urdf").write_text(text, "utf-8")
            load = [KINLINT, "load", "--isolated", "--endpoint", url, directory]
            subprocess.run(load, check=True, stdout=subprocess.DEVNULL)
        made = count
        costs.append(_cost(url))
    (few, small), (many, large) = costs
    titles = [f"`kinlint check --endpoint`, {n} robots" for n in (TIMES * robots, robots)]
    yield Row(f"{titles[0]}, CPU", titles[1], (many, few), target=GROWN)
    yield Row(f"{titles[0]}, memory", titles[1], (large, small), unit="B")


def _cost(url: str) -> tuple[float, int]:
    """Return the seconds of CPU and the bytes of memory that a check takes."""
    check = [KINLINT, "check", "--isolated", "--jobs=1", "--output=json-lines", "--endpoint", url]
    told = subprocess.run([PYTHON, "-c", WATCHED, *check], stdout=subprocess.PIPE, check=True)
    seconds, memory = told.stdout.split()
    return float(seconds), int(memory) * (1 if sys.platform == "darwin" else 1024)
