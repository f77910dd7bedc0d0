"""The command `python tests/fuzzing`: hours of mutated files, and what kinlint failed at."""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from collections.abc import Sequence
from itertools import count
from time import monotonic

from fuzzing.corpus import SUFFIXES
from fuzzing.trial import fault, made

EVERY = 1000


def main(arguments: Sequence[str]) -> int:
    """Fuzz as *arguments* ask for; 1 if anything failed."""
    parser = argparse.ArgumentParser(prog="python tests/fuzzing", description=__doc__)
    parser.add_argument("--hours", type=float, default=1 / 60, help="how long (default: a minute)")
    parser.add_argument("--format", choices=SUFFIXES, action="append", help="only this format")
    parser.add_argument("--seed", type=int, default=0, help="the first number")
    parser.add_argument("--only", action="store_true", help="this seed and no other, with its text")
    options = parser.parse_args(arguments)
    forms = options.format or list(SUFFIXES)
    if options.only:
        for form in forms:
            given = made(form, options.seed)
            sys.stdout.buffer.write(given.content)
            sys.stderr.write(f"{given.name}: {fault(given) or 'answered'}\n")
        return 0
    import resource  # noqa: PLC0415  not on every system

    until, tried, failed = monotonic() + 3600 * options.hours, 0, Counter[str]()
    for seed in count(options.seed):
        for form in forms:
            found = fault(made(form, seed))
            tried += 1
            if found is not None:
                last = found.rstrip().rpartition("\n")[2]
                failed[last] += 1
                if failed[last] == 1:
                    sys.stdout.write(f"{form} {seed}: {found}\n")
            if tried % EVERY == 0:
                memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024
                sys.stdout.write(f"{tried} inputs, {failed.total()} faults, {memory} MB\n")
            sys.stdout.flush()
        if monotonic() > until:
            break
    sys.stdout.write(f"{tried} inputs from seed {options.seed}, {failed.total()} faults\n")
    return 1 if failed else 0
