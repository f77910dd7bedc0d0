"""Whatever happens to files and to the cache, a run says what a run without it says.

`KINLINT_EDITS=300 pytest -m slow tests/cache/test_random_edits.py` makes so many edits.
"""

import os
from random import Random

import pytest
from fuzzing.mutation import mutated
from support.fixable_files import FILES

pytestmark = pytest.mark.slow
EDITS = int(os.environ.get("KINLINT_EDITS", "20"))
FORMS = ("json", "concise")


def spoil(path, random):
    """Cut, change or empty an entry, or give it another time."""
    data = path.read_bytes()
    at = random.randrange(len(data) or 1)
    way = random.randrange(6)
    if way == 0:
        path.write_bytes(data[:at])
    elif way == 1:
        path.write_bytes(data[:at] + bytes([random.randrange(256)]) + data[at + 1 :])
    elif way == 2:
        path.write_bytes(b"")
    elif way == 3:
        other = random.choice(sorted(path.parent.iterdir()))
        path.write_bytes(other.read_bytes())
    else:
        moment = random.choice([0, 1, 4e9])
        os.utime(path, (moment, moment))


def test_no_report_is_stale(runs, write):
    """After random edits, with entries that are damaged, swapped, from the past or the future."""
    random = Random(1)  # noqa: S311
    names = {f"{form}.{form}": text.encode() for form, text in FILES.items()}
    for name, text in names.items():
        write(name, text)
    for number in range(EDITS):
        name, (_, other) = random.choice(sorted(names)), random.choice(sorted(names.items()))
        moment = random.choice([1e9, 2e9, None])
        path = write(name, random.choice([mutated(names[name], other, random), names[name]]))
        if moment is not None:
            os.utime(path, (moment, moment))
        if runs.reports.exists():
            for entry in sorted(runs.reports.iterdir()):
                if random.random() < 0.2:
                    spoil(entry, random)
        form = random.choice(FORMS)

        assert runs.said(*sorted(names), form=form) == runs.said(
            *sorted(names), "--no-cache", form=form
        ), number
