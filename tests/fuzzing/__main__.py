"""`python tests/fuzzing`."""

from __future__ import annotations

import sys
from pathlib import Path

sys.path[0] = str(Path(__file__).resolve().parents[1])

from fuzzing.command import main  # noqa: E402  tests/ must be on the path first

sys.exit(main(sys.argv[1:]))
