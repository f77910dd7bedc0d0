"""The benchmark's command line: measures, and prints a table with the command that made it."""

from __future__ import annotations

import argparse
import platform
import shlex
import sys
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from importlib.metadata import version
from pathlib import Path

from benchmarks import cluster, editing, reading, store
from benchmarks.fleet import Fleet
from benchmarks.growth.measurement import GROWTH_HEADING, measured
from benchmarks.keystrokes import Keystrokes
from benchmarks.processes import Workplace
from benchmarks.proving import Proving
from benchmarks.stages import stages
from benchmarks.starting import Starting
from benchmarks.table import Row, markdown
from kinlint.catalogue import rulebook
from kinlint.catalogue.rulebook import Rulebook

SIZES = (7, 70, 700)
PACKAGES = ("pyoxigraph", "pyld", "pyshacl", "rdflib", "owlrl")


def main(arguments: Sequence[str]) -> int:
    """Measure and print; 1 if a target was missed."""
    options = _parser().parse_args(arguments)
    catalogue = rulebook.load()
    if options.growth is not None:
        return _growth(arguments, options, catalogue)
    rows = []
    for row in _rows(options, catalogue):
        sys.stderr.write(f"measured: {row.ours}\n")
        rows.append(row)
    joints = 70 if options.quick else 700
    typed = options.keystrokes is not None
    few = (options.fleet, options.store, options.starting, options.reading, typed, options.proofs)
    parts = [] if any(few) else [_shares(joints, stages(joints, catalogue, options.runs)), ""]
    lines = [*markdown(rows), "", *parts, _made(arguments, catalogue)]
    sys.stdout.writelines(f"{line}\n" for line in lines)
    return int(not all(row.met for row in rows))


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python tests/benchmarks", description=__doc__)
    parser.add_argument(
        "--joints",
        type=int,
        choices=SIZES,
        default=70,
        help="the longest chain that pySHACL checks: 70 takes it half an hour, 700 days",
    )
    parser.add_argument(
        "--quick", action="store_true", help="only chains of 7, 70 and 700, of 7 for pySHACL"
    )
    parser.add_argument(
        "--fleet", type=Path, metavar="DIR", help="only the robots below DIR, in one run"
    )
    parser.add_argument(
        "--mjcf", type=Path, metavar="DIR", help="with --fleet: the models below DIR, per megabyte"
    )
    parser.add_argument(
        "--starting", action="store_true", help="only runs on small files, and recalled ones"
    )
    parser.add_argument("--reading", action="store_true", help="only reading JSON-LD")
    parser.add_argument(
        "--keystrokes",
        nargs="?",
        const="",
        metavar="TEXT",
        help="only typing, alone and through the server, where the title contains TEXT",
    )
    parser.add_argument(
        "--proofs",
        nargs="?",
        type=Path,
        const=Path(),
        metavar="DIR",
        help="only what proofs of fixes cost, of the robots below DIR too",
    )
    parser.add_argument(
        "--growth",
        nargs="?",
        const="",
        metavar="TEXT",
        help="only growth with the size of a file, of the inputs whose title contains TEXT",
    )
    parser.add_argument("--fixes", action="store_true", help="growth of runs that prove fixes")
    parser.add_argument(
        "--store", type=int, metavar="N", help="only N robots in a triple store, and 100 N of them"
    )
    parser.add_argument(
        "--store-joints",
        type=int,
        metavar="N",
        default=store.JOINTS,
        help="joints of those robots: 6 make 280 statements, 23 a thousand",
    )
    parser.add_argument(
        "--cluster",
        type=int,
        metavar="N",
        help="with --fleet: N files made of the robots below DIR, on a cluster that loses a worker",
    )
    parser.add_argument("--runs", type=int, default=5, help="of which medians are taken")
    return parser


@contextmanager
def _workplace() -> Iterator[Workplace]:
    """An empty directory to run kinlint in, which has run before."""
    with tempfile.TemporaryDirectory() as directory:
        place = Workplace(Path(directory))
        place.warm()
        yield place


def _rows(options: argparse.Namespace, catalogue: Rulebook) -> Iterator[Row]:
    if options.fleet:
        yield from _fleet(options)
        return
    if options.store:
        with store.served() as url:
            yield from store.rows(url, options.store, options.store_joints)
        return
    if options.reading:
        yield from reading.rows(options.runs)
        return
    if options.starting:
        with _workplace() as place:
            yield from Starting(place).rows(4 * options.runs)
        return
    if options.keystrokes is not None:
        with _workplace() as place:
            yield from Keystrokes(place).rows(4 * options.runs, options.keystrokes)
            yield from editing.rows(place, options.runs, options.keystrokes)
        return
    if options.proofs:
        fleet = None if options.proofs == Path() else options.proofs.absolute()
        with _workplace() as place:
            yield from Proving(place, fleet).rows(options.runs, quick=options.quick)
        return
    with _workplace() as place:
        yield from place.rows(options.runs, quick=options.quick)
        yield from Starting(place).rows(4 * options.runs)
        yield from Proving(place).rows(options.runs, quick=options.quick)
        yield from Keystrokes(place).rows(4 * options.runs)
        yield from editing.rows(place, options.runs)
    yield from reading.rows(options.runs)
    from benchmarks.checking import compared  # noqa: PLC0415  rdflib weighs on what is timed

    for joints in SIZES:
        if joints <= (SIZES[0] if options.quick else options.joints):
            seconds = compared(joints, catalogue, options.runs)
            target = 1000 if joints == SIZES[-1] else None
            yield Row(f"checking {joints} joints", "pySHACL", seconds, "faster", target)


def _fleet(options: argparse.Namespace) -> Iterator[Row]:
    if options.cluster:
        return cluster.rows(options.fleet, options.cluster)
    if options.mjcf:
        return Fleet(options.fleet).compared_by_size(options.mjcf, options.runs)
    return Fleet(options.fleet).rows(options.runs)


def _growth(arguments: Sequence[str], options: argparse.Namespace, catalogue: Rulebook) -> int:
    """Measure and print growth; 1 if anything grows too fast."""
    met = True
    sys.stdout.write(f"{GROWTH_HEADING}\n")
    for row in measured(options.growth, catalogue, fixing=options.fixes):
        sys.stdout.write(f"{row.line}\n")
        sys.stdout.flush()
        met = met and row.met
    sys.stdout.write(f"\n{_made(arguments, catalogue)}\n")
    return int(not met)


def _shares(joints: int, seconds: Mapping[str, float]) -> str:
    total = sum(seconds.values())
    shares = ", ".join(f"{name} {took / total:.0%}" for name, took in seconds.items())
    return f"Where the time goes at {joints} joints: {shares}."


def _made(arguments: Sequence[str], catalogue: Rulebook) -> str:
    command = shlex.join(["python", "tests/benchmarks", *arguments])
    used = ", ".join(f"{name} {version(name)}" for name in PACKAGES)
    return (
        f"Made by `{command}`: {len(catalogue.rules)} rules,"
        f" {len(catalogue.constraints)} constraints; Python {platform.python_version()}, {used}."
    )
