"""`python -m kinlint`."""

import sys

from kinlint.cli.main import main

sys.exit(main())
