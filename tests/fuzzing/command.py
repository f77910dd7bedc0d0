"""The command `python tests/fuzzing`: hours of mutated files, and what kinlint failed at."""

from __future__ import annotations

import argparse
import gc
import sys
from collections import Counter
from collections.abc import Sequence
from itertools import count
from pathlib import Path
from time import monotonic

from fuzzing.corpus import SUFFIXES
from fuzzing.expansion import difference
from fuzzing.expansion import made as made_for_expansion
from fuzzing.trial import Input, fault, made, reduced
from kinlint.formats.options import ReadOptions

TOGETHER = 40
"""Inputs that are linted as one model, which costs little more than one of them."""
EVERY = 100
"""Models after which a line is written."""


def main(arguments: Sequence[str]) -> int:
    """Fuzz as *arguments* ask for; 1 if anything failed."""
    parser = argparse.ArgumentParser(prog="python tests/fuzzing", description=__doc__)
    parser.add_argument("--hours", type=float, default=1 / 60, help="how long (default: a minute)")
    parser.add_argument("--format", choices=SUFFIXES, action="append", help="only this format")
    parser.add_argument("--seed", type=int, default=0, help="the first number")
    parser.add_argument("--only", type=int, nargs="+", help="these as one model, with their texts")
    parser.add_argument("--expansion", type=int, metavar="N", help="compare N expansions instead")
    options = parser.parse_args(arguments)
    if options.expansion:
        return _expansions(range(options.seed, options.seed + options.expansion))
    forms = options.format or list(SUFFIXES)
    if options.only:
        for form in forms:
            given = [made(form, seed) for seed in options.only]
            sys.stdout.buffer.write(b"\n".join(each.content for each in given))
            sys.stderr.write(f"{form}: {fault(*given) or 'answered'}\n")
        return 0
    return _fuzz(forms, options.seed, monotonic() + 3600 * options.hours)


def _fuzz(forms: Sequence[str], first: int, until: float) -> int:
    """Lint the inputs from the number *first*: all in models, and the first of each by itself."""
    tried, failed = 0, Counter[str]()
    for model in count():
        start = first + model * TOGETHER
        for form in forms:
            given = [made(form, seed) for seed in range(start, start + TOGETHER)]
            for some in (given[:1], given):
                found = fault(*some)
                if found is not None:
                    _tell(found, some, failed)
            tried += TOGETHER
        if model % EVERY == 0:
            sys.stdout.write(f"{tried} inputs, {failed.total()} faults, {_memory()} MB\n")
        sys.stdout.flush()
        if monotonic() > until:
            break
    sys.stdout.write(f"{tried} inputs from seed {first}, {failed.total()} faults\n")
    return 1 if failed else 0


def _tell(found: str, given: Sequence[Input], failed: Counter[str]) -> None:
    """Write what *given* led to, and which of them do, if it is new."""
    lines = found.rstrip().splitlines()
    where = next((line for line in reversed(lines) if line.startswith("  File ")), "")
    kind = where + lines[-1].partition(":")[0]
    failed[kind] += 1
    if failed[kind] == 1:
        few = reduced(given)
        seeds = " ".join(str(each.seed) for each in few)
        sys.stdout.write(f"{few[0].form} {seeds}: {fault(*few) or found}\n")


def _memory() -> int:
    """Return the resident memory of this process in MB, or 0 where the system does not tell."""
    try:
        pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[1])
    except OSError:
        return 0
    return pages * 4096 // 2**20


def _expansions(seeds: Sequence[int]) -> int:
    """Compare both ways of expanding JSON-LD; 1 if any text is read in two ways."""
    differing, options = 0, ReadOptions()
    for tried, seed in enumerate(seeds, 1):
        found = difference(made_for_expansion(seed), options)
        if found is not None:
            differing += 1
            sys.stdout.write(f"{seed}: {found[:1000]}\n")
        if tried % EVERY == 0:
            options = ReadOptions()
            gc.collect()  # Readers count what they made as old, whether it is garbage or not.
        if tried % (100 * EVERY) == 0:
            sys.stdout.write(f"{tried} texts, {differing} differences\n")
        sys.stdout.flush()
    sys.stdout.write(f"{len(seeds)} texts from seed {seeds[0]}, {differing} differences\n")
    return 1 if differing else 0
