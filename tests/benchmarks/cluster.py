"""Lints a fleet on a Dask cluster of this machine that loses a worker, against one process.

The files are real robots with changed masses, each of another name. Each is to be judged once, as
one process judges it, and the memory of the run is not to grow with their number.
"""

from __future__ import annotations

import filecmp
import json
import os
import random
import re
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from threading import Thread

from benchmarks.processes import KINLINT, PYTHON
from benchmarks.table import Row, memory

GROWN = 1.3
"""Most memory that a run over four times the files may take."""
LARGEST = 30_000
"""Bytes of the largest robot that is multiplied."""
MASS = re.compile(r'<mass value="([\d.]+)"')
ROBOT = re.compile(r'<robot\b([^>]*?)name="[^"]*"')
WATCHED = """
import resource, subprocess, sys
with open(sys.argv[1], "w") as out:
    subprocess.run(sys.argv[2:], stdout=out)
print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss * 1024)
"""


def multiplied(robots: Path, directory: Path, count: int) -> None:
    """Write *count* files below *directory*: the URDFs below *robots*, with changed masses."""
    chance = random.Random(21)  # noqa: S311  repeatable
    texts = []
    for path in sorted(robots.rglob("*.urdf")):
        text = path.read_text("utf-8", "replace")
        if len(text) < LARGEST and ROBOT.search(text) and "xacro" not in text:
            texts.append(text)
    for number in range(count):
        name = f"robot{number:06}"
        text = ROBOT.sub(rf'<robot\1name="{name}"', texts[number % len(texts)], count=1)
        place = directory / f"{number // 1000:03}" / f"{name}.urdf"
        place.parent.mkdir(exist_ok=True)
        place.write_text(
            MASS.sub(
                lambda found: f'<mass value="{float(found[1]) * chance.uniform(0.5, 2):.6g}"', text
            ),
            "utf-8",
        )


def rows(robots: Path, count: int) -> Iterator[Row]:
    """Lint *count* files, and a quarter of them, on two workers, and all by one process."""
    from distributed import LocalCluster  # noqa: PLC0415  few benchmarks

    with tempfile.TemporaryDirectory() as made:
        few, many = Path(made, "few"), Path(made, "many")
        for place, number in ((few, count // 4), (many, count)):
            place.mkdir()
            multiplied(robots, place, number)
        alone, single, _ = _run(many, Path(made, "one"))
        with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=":0") as cluster:
            address = cluster.scheduler_address.replace("tcp://", "dask://")
            _, _, small = _run(few, Path(made, "small"), "--executor", address)
            victim = next(iter(cluster.workers.values())).pid
            killer = Thread(target=_kill, args=(victim, alone / 4), daemon=True)
            killer.start()
            took, found, large = _run(many, Path(made, "all"), "--executor", address)
            killer.join()
            pids = [os.getpid(), *(each.pid for each in cluster.workers.values())]
            sys.stderr.write(f"scheduler and workers: {', '.join(map(_peak, pids))}\n")
        if not filecmp.cmp(found, single, shallow=False):
            raise RuntimeError("the cluster finds something else than one process")
        with found.open(encoding="utf-8") as lines:
            files = len({json.loads(each)["filename"] for each in lines})
    title = f"{count} files on two workers, one of them killed ({files} with findings)"
    yield Row(title, "one process", (took, alone), "faster")
    yield Row(f"{title}, memory here", f"{count // 4} files", (large, small), "ratio", GROWN, "B")


def _kill(victim: int, seconds: float) -> None:
    time.sleep(seconds)
    os.kill(victim, signal.SIGKILL)


def _peak(pid: int) -> str:
    """Return the most memory that the process *pid* has had."""
    status = Path(f"/proc/{pid}/status")
    peak = re.search(r"VmHWM:\s*(\d+)", status.read_text()) if status.exists() else None
    return memory(int(peak[1]) * 1024) if peak else "unknown"


def _run(directory: Path, out: Path, *more: str) -> tuple[float, Path, int]:
    """Return the seconds of a run, the file of its findings, and the bytes of memory it took."""
    lint = [KINLINT, ".", "--isolated", "--no-cache", "--quiet", "--output=json-lines", *more]
    began = time.perf_counter()
    command = [PYTHON, "-c", WATCHED, str(out), *lint]
    told = subprocess.run(command, cwd=directory, stdout=subprocess.PIPE, check=True)
    seconds = time.perf_counter() - began
    used = int(told.stdout)
    sys.stderr.write(f"{directory.name}: {seconds:.1f} s, {memory(used)} {' '.join(more)}\n")
    return seconds, out, used
