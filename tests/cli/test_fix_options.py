"""The options about fixes, and what a run that fixed says where."""

import json
import sys
from dataclasses import replace

import pytest
from pipeline import RULES

from kinlint.cli import fix_files
from kinlint.cli.check_options import parser
from kinlint.cli.overrides import overrides
from kinlint.cli.report_outputs import Outputs
from kinlint.finding import Finding, Fix, TextEdit
from kinlint.report import Report
from kinlint.rule import Applicability, Severity
from kinlint.text import Location, SourceText, Span

SOURCE = SourceText("arm.jsonld", '{"@id": "x"}')
PLACE = Location(SOURCE, Span(1, 6))
SAFE = Fix("Do it", Applicability.SAFE, (TextEdit(PLACE, '"id"'),), "")
UNSAFE = replace(SAFE, applicability=Applicability.UNSAFE, why="It guesses.")


def finding(rule, fix):
    return Finding(rule, rule.severity, rule.messages[0], PLACE, "", "_:b", fixes=(fix,))


MENDED = Report(
    findings=(finding(RULES[0], UNSAFE),),
    fixed=(finding(RULES[1], SAFE),),
    files=("arm.jsonld",),
    rules=RULES,
)


def test_without_options_nothing_is_fixed():
    """And what unsafe fixes could do is hinted at."""
    options = parser().read([])

    flags = ("fix", "fix_only", "diff", "show_fixes", "exit_non_zero_on_fix")
    assert not any(getattr(options, name) for name in flags)
    assert (options.unsafe_fixes, options.fixable, options.unfixable) == (None, None, None)


def test_options_come_on_top_of_the_configuration():
    """Selectors as for rules, and yes or no for unsafe fixes."""
    said = overrides(parser().read(["--fixable", "UNI,AP3", "--unfixable=LD", "--unsafe-fixes"]))

    (choice,) = said.choices
    assert (choice.fixable, choice.unfixable) == (("UNI", "AP3"), ("LD",))
    assert said.unsafe_fixes is True
    assert overrides(parser().read(["--no-unsafe-fixes"])).unsafe_fixes is False


@pytest.mark.parametrize("option", ["--fixable", "--unfixable"])
def test_a_selector_that_names_nothing_is_a_mistake(kinlint, model, option):
    """With a suggestion, and no report."""
    code, out, err = kinlint(option, "missing-unt")

    assert (code, out) == (2, "")
    assert "unknown rule selector 'missing-unt', did you mean 'missing-unit'?" in err


def test_settings_show_whose_fixes_are_wanted_and_trusted(kinlint, pipeline, write):
    """Beside what each rule counts as."""
    write("a.jsonld")
    write(
        "kinlint.toml",
        'unfixable = ["LD"]\nextend-unsafe-fixes = ["UNI001"]\nextend-safe-fixes = ["UNI002"]',
    )
    _, out, _ = kinlint("--show-settings")

    assert "unsafe-fixes = hint\n" in out
    assert "UNI001 missing-unit: warning, fixes unsafe\n" in out
    assert "UNI002 unit-quantity-mismatch: error, fixes safe\n" in out
    assert "LD001 dropped-term: error, not fixed\n" in out
    assert "unsafe-fixes = true\n" in kinlint("--show-settings", "--unsafe-fixes")[1]


def said(capsys, out=None, **settings):
    """Standard output and error."""
    Outputs("concise", **settings).emit(MENDED, out)
    return tuple(capsys.readouterr())


LEFT = "arm.jsonld:1:2: warning: [*!] missing-unit is at fault. [UNI001]\n"
LISTED = "Fixed 1 error:\n- arm.jsonld:\n    1 x UNI002 (unit-quantity-mismatch)\n\n"
HINT = "1 can be fixed with --fix --unsafe-fixes [*!]"
FOUND = f"Found 2 findings (1 error, 1 warning): 1 fixed, 1 remaining; {HINT}.\n"
ONLY = "Fixed 1 error (1 more with `--unsafe-fixes`).\n"


def test_a_run_that_fixed_says_what_is_left_and_what_it_did(capsys):
    """In this order: what is left, what was fixed if that is asked for, how much of each."""
    assert said(capsys) == (LEFT + FOUND, "")
    assert said(capsys, show_fixes=True) == (LEFT + LISTED + FOUND, "")
    assert said(capsys, show_fixes=True, quiet=True) == (LEFT + LISTED, "")
    assert said(capsys, show_fixes=True, silent=True) == ("", "")


def test_a_run_that_only_fixes_says_nothing_of_what_is_left(capsys):
    """But how much more it could have done."""
    assert said(capsys, only_fixes=True) == (ONLY, "")
    assert said(capsys, only_fixes=True, show_fixes=True) == (LISTED + ONLY, "")
    assert said(capsys, only_fixes=True, would=True)[0].startswith("Would fix 1 error")
    assert said(capsys, only_fixes=True, quiet=True) == ("", "")


def test_reports_make_way_for_what_was_fixed(capsys):
    """With a model from standard input, that goes to standard output."""
    assert said(capsys, sys.stderr) == ("", LEFT + FOUND)


def test_machine_formats_tell_on_standard_error_what_was_fixed(capsys):
    """Unless they are there themselves."""
    outputs = Outputs("json", show_fixes=True)
    outputs.emit(MENDED)
    out, err = capsys.readouterr()
    assert [one["code"] for one in json.loads(out)] == ["UNI001"]
    assert err == LISTED + FOUND

    outputs.emit(MENDED, sys.stderr)
    out, err = capsys.readouterr()
    assert (out, json.loads(err)[0]["code"]) == ("", "UNI001")

    replace(outputs, only_fixes=True).emit(MENDED)
    out, err = capsys.readouterr()
    assert (json.loads(out), err) == ([], LISTED + ONLY)


def test_files_get_what_standard_output_gets(capsys, here):
    """Copies in a format for people conclude like the report itself."""
    Outputs("json", copies=(("concise", here / "c.txt"),), show_fixes=True, quiet=True).emit(MENDED)
    assert (here / "c.txt").read_text("utf-8") == LEFT + LISTED
    Outputs("concise", path=here / "d.txt", only_fixes=True).emit(MENDED)
    assert (here / "d.txt").read_text("utf-8") == ONLY


def test_only_some_outputs_need_fixes(here):
    """Annotations have no place for them, and a silent run tells nothing."""
    sarif = (("sarif", here / "out.sarif"),)

    assert Outputs("full").tells_fixes
    assert not Outputs("github").tells_fixes
    assert Outputs("github", statistics=True).tells_fixes
    assert Outputs("github", copies=sarif).tells_fixes
    assert not Outputs("full", silent=True).tells_fixes
    assert Outputs("full", silent=True, copies=sarif).tells_fixes
    assert Outputs("full", silent=True, path=here / "out.txt").tells_fixes


def test_only_what_is_shown_needs_fixes(here):
    """A summary counts what can be fixed of that; tables and machines are told everything."""
    shown = {"show": Severity.WARNING}

    assert Outputs("full", **shown).fixes_from is Severity.WARNING
    assert Outputs("full", **shown, quiet=True).fixes_from is Severity.WARNING
    assert Outputs("full", **shown, statistics=True).fixes_from is Severity.INFO
    assert Outputs("full", **shown, verbose=True).fixes_from is Severity.INFO
    assert Outputs("full", **shown, copies=(("sarif", here / "s"),)).fixes_from is Severity.INFO


def test_a_patch_has_the_byte_order_mark_of_its_file(capsys):
    """Or it would not fit the first line; a terminal has no use for it."""
    before = SourceText("arm.urdf", "<a/>\n", bom=True)
    changed = [(before, replace(before, text="<b/>\n"))]

    fix_files.print_diffs(changed, "never")
    assert capsys.readouterr().out.endswith("-\ufeff<a/>\n+\ufeff<b/>\n")
    fix_files.print_diffs(changed, "always")
    assert "<a/>\x1b[0m\n" in capsys.readouterr().out
