from __future__ import annotations

from dataclasses import replace

import pytest
from reported import BOTH, DISPLAY, INERTIA_FINDING, RULES, SAFE, UNSAFE, here, report, unit_finding

from kinlint.errors import SourceError
from kinlint.finding import Fix
from kinlint.report import Report
from kinlint.reporters.applied_fixes import listing, verdict
from kinlint.reporters.summary import summary
from kinlint.reporters.terminal_style import Style
from kinlint.rule import Severity

UNREAD = SourceError("bad.jsonld", "no JSON")
WARNING = unit_finding(here("x", 0, 1))
ERROR = replace(WARNING, severity=Severity.ERROR)


def said(made: Report, *, verbose: bool = False) -> str:
    return "".join(summary(made, Style(), verbose=verbose))


def test_findings_are_counted_by_severity_and_file() -> None:
    made = report(
        ERROR,
        unit_finding(here("x", name="b.jsonld"), severity=Severity.ERROR),
        WARNING,
        files=tuple("abcdefg"),
        triples=1204,
        seconds=0.42,
        suppressed=(WARNING,),
        baseline=3,
    )
    assert said(made) == (
        "Found 3 findings (2 errors, 1 warning) in 2 of 7 files; 1 suppressed; 3 in the baseline.\n"
    )
    assert "in 2 of 7 files (7 files, 1,204 triples, 0.4 s);" in said(made, verbose=True)


def test_hidden_findings_are_counted_with_the_option_that_shows_them() -> None:
    info = replace(WARNING, severity=Severity.INFO, fixes=(SAFE,))
    made = report(ERROR, WARNING, info, info, files=("a", "b"))
    assert said(made.shown_from(Severity.WARNING)) == (
        "Found 2 findings (1 error, 1 warning) in 1 of 2 files; 2 infos not shown (--show info).\n"
    )
    assert said(made.shown_from(Severity.ERROR)).endswith(
        "; 1 warning and 2 infos not shown (--show info).\n"
    )
    assert said(report(WARNING).shown_from(Severity.ERROR)) == (
        "No errors in 1 file; 1 warning not shown (--show warning).\n"
    )
    assert said(report(info).shown_from(Severity.WARNING)).startswith("No errors or warnings in 1 ")
    assert said(report(info, fixed=(ERROR,)).shown_from(Severity.WARNING)).startswith(
        "Found 2 findings (1 error, 1 info): 1 fixed, 1 remaining; 1 can be fixed with --fix [*]; 1"
    )


def test_three_severities_make_a_list() -> None:
    info = replace(WARNING, severity=Severity.INFO)
    made = report(ERROR, WARNING, info, triples=1)
    assert said(made) == "Found 3 findings (1 error, 1 warning, 1 info) in 1 file.\n"


def test_little_time_is_told_more_exactly() -> None:
    assert "0.02 s)" in said(replace(BOTH, seconds=0.021), verbose=True)


def test_a_clean_run_says_so_and_how_much_was_checked_if_asked() -> None:
    made = Report(files=("a", "b"), rules=RULES, triples=1204, applied=16, seconds=0.4)
    assert said(made) == "All checks passed in 2 files.\n"
    assert said(made, verbose=True) == (
        "All checks passed (2 files, 1,204 triples, 0.4 s, 16 rules applied).\n"
    )


def test_what_is_shown_though_suppressed_is_no_finding() -> None:
    silent = replace(WARNING, suppressed="known")
    assert said(report(silent)) == "All checks passed in 1 file; 1 suppressed.\n"
    assert said(report(ERROR, silent)).endswith("in 1 file; 1 suppressed.\n")


@pytest.mark.parametrize(
    ("made", "expected"),
    [
        (Report(), "No files were checked."),
        (Report(errors=(UNREAD,)), "1 file could not be read."),
        (
            Report(files=("x.jsonld",), errors=(UNREAD,)),
            "1 file could not be read; no findings in the others.",
        ),
        (Report(files=("x.jsonld",)), "Nothing was checked: no rule is selected."),
        (
            Report(files=("x.jsonld",), unapplied=("x.jsonld",), rules=RULES),
            "x.jsonld: 0 rules applied: no known vocabulary\nNothing was checked: no rule applies.",
        ),
        (
            Report(files=("x.jsonld", "y.jsonld"), unapplied=("x.jsonld",), rules=RULES),
            "x.jsonld: 0 rules applied: no known vocabulary\nAll checks passed in 2 files.",
        ),
        (
            Report(files=("x.yaml",), unapplied=("x.yaml",), rules=RULES),
            (
                "x.yaml: 0 rules applied: it names no joint, link, frame or planning group\n"
                "Nothing was checked: no rule applies."
            ),
        ),
    ],
)
def test_a_run_without_findings_never_passes_silently(made: Report, expected: str) -> None:
    assert said(made) == expected + "\n"


@pytest.mark.parametrize(
    ("fixes", "unsafe", "expected"),
    [
        ([], None, "in 1 file; "),
        ([SAFE], None, "; 1 can be fixed with --fix [*]; "),
        (
            [SAFE, UNSAFE, UNSAFE],
            None,
            "; 1 can be fixed with --fix [*], 2 more with --fix --unsafe-fixes [*!]; ",
        ),
        ([UNSAFE], None, "; 1 can be fixed with --fix --unsafe-fixes [*!]; "),
        ([SAFE, UNSAFE], True, "; 2 can be fixed with --fix [*]; "),
        ([SAFE, UNSAFE], False, "; 1 can be fixed with --fix [*]; "),
        ([UNSAFE], False, "1 file; "),
        ([DISPLAY], None, "1 file; "),
    ],
)
def test_the_line_tells_what_can_be_fixed(
    fixes: list[Fix],
    unsafe: bool | None,  # noqa: FBT001
    expected: str,
) -> None:
    """Unsafe fixes are not even hinted at where the configuration says no to them."""
    findings = [replace(INERTIA_FINDING, fixes=(one,)) for one in fixes]
    silent = replace(INERTIA_FINDING, fixes=(SAFE,), suppressed="known")
    made = report(*findings, silent, unsafe=unsafe)
    assert said(made).endswith(f"{expected}1 suppressed.\n")


MENDED = report(
    ERROR,
    fixed=(
        replace(INERTIA_FINDING, fixes=(SAFE,)),
        unit_finding(here("x", name="a.jsonld")),
        unit_finding(here("x", name="a.jsonld")),
        replace(ERROR, location=here("x", name="a.jsonld"), rule=RULES[0]),
    ),
)


def test_a_run_that_fixes_tells_what_it_fixed_and_what_is_left() -> None:
    assert said(MENDED) == "Found 5 findings (3 errors, 2 warnings): 4 fixed, 1 remaining.\n"
    assert said(replace(MENDED, findings=())) == (
        "Found 4 findings (2 errors, 2 warnings): 4 fixed, 0 remaining.\n"
    )


def test_what_was_fixed_is_listed_by_file_and_rule() -> None:
    assert "".join(listing(MENDED, Style())) == (
        """\
Fixed 2 errors and 2 warnings:
- models/dynamics.jsonld:
    1 x INE007 (inertia-seen-by-foreign-frame)
- a.jsonld:
    2 x UNI002 (unit-quantity-mismatch)
    1 x INE007 (inertia-seen-by-foreign-frame)

"""
    )
    assert "".join(listing(MENDED, Style(), would=True)).startswith("Would fix 2 errors and ")
    assert "".join(listing(report(ERROR), Style())) == ""


def test_a_run_that_only_fixes_says_how_much() -> None:
    left = report(replace(ERROR, fixes=(UNSAFE,)), fixed=MENDED.fixed)
    assert "".join(verdict(left)) == (
        "Fixed 2 errors and 2 warnings (1 more with `--unsafe-fixes`).\n"
    )
    assert "".join(verdict(replace(left, unsafe=False))) == "Fixed 2 errors and 2 warnings.\n"
    assert "".join(verdict(report(ERROR), would=True)) == "Would fix nothing.\n"
    assert "".join(verdict(replace(left, fixed=()))) == (
        "Fixed nothing (1 fixable with `--unsafe-fixes`).\n"
    )
