"""Runs of the command that may remember: what they say, and what they remembered."""

from __future__ import annotations

import re

from kinlint.cli.main import main

TIMES = re.compile(r"\d+\.\d+ s|\d{4}-\d\d-\d\dT[\d:.]+Z")
RECALLED = re.compile(r"recalled: (\d+)")


class Runs:
    """Runs with a cache of their own."""

    def __init__(self, capsys, cache):
        self.capsys, self.cache = capsys, cache
        self.reports = cache / "reports"

    def said(self, *arguments, form="json"):
        """The exit code and all that is said; how many files were recalled is apart."""
        self.capsys.readouterr()
        code = main([*map(str, arguments), "--isolated", "--output-format", form])
        out, err = self.capsys.readouterr()
        return code, TIMES.sub("…", out), TIMES.sub("…", err)

    def recalled(self, *arguments, configured=False):
        """How many files a run recalls."""
        self.capsys.readouterr()
        isolated = [] if configured else ["--isolated"]
        main([*map(str, arguments), *isolated, "-v", "--output-format", "json"])
        match = RECALLED.search(self.capsys.readouterr().err)
        return int(match[1])

    def fresh(self, *arguments, form="json"):
        """What is said by a run that remembers nothing, and leaves no memory."""
        hidden = self.reports.with_name("hidden")
        if self.reports.exists():
            self.reports.rename(hidden)
        self.reports.touch()
        try:
            return self.said(*arguments, form=form)
        finally:
            self.reports.unlink()
            if hidden.exists():
                hidden.rename(self.reports)
