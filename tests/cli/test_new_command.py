"""`kinlint new`: a rule file that keeps its promises once it is filled in."""

import pytest

FILLED = {
    '"TODO: the fault in a few words, lower case"': '"space in an identifier"',
    "TODO: what breaks, in the robot, the simulator or the controller, in two sentences or more.": (
        "Simulators and scene formats allow no spaces in names.  Each rewrites them in its own"
        " way, and what a script asks for by name is not there any more."
    ),
    "<https://example.org/> ;  # TODO: what the rule rests on": "<https://example.org/why> ;",
    "  # TODO: what it is about": "",
    "TODO: what is wrong with '{$this}'.": "'{$this}' has a space in its name.",
    "# TODO: what a ": "# ",
    "FILTER (false)": 'FILTER (CONTAINS(STR($this), "%20"))',
}


FORMS = {
    "jsonld": ("ex:TODO: the fault", "ex:left%20elbow"),
    "turtle": ("ex:elbow|]  # TODO: the fault", "ex:left%20elbow|]"),
    "usd": ('elbow"|]  # TODO: the fault', 'left_elbow"|]'),
    **dict.fromkeys(
        ("urdf", "xacro", "srdf", "sdf", "mjcf", "collada", "yaml"),
        ("TODO: the fault|]", "left elbow|]"),
    ),
}
"""What stands for the fault in the bad example of each format, and what is written for it."""


@pytest.mark.slow
@pytest.mark.parametrize("form", FORMS)
def test_a_rule_that_waits_to_be_filled_in_fails(kinlint, form):
    """Each place is told by its line, and nothing else is."""
    code, out, _ = kinlint("new", "limits/limit-of-glass", "--format", form, "--code", "ACME001")
    assert (code, "rules/limits/limit-of-glass.ttl: ACME001" in out) == (0, True)
    code, out, _ = kinlint("test-rules", "rules")
    told = out.splitlines()[:-1]
    assert code == 1
    assert len(told) == 7
    assert all("limit-of-glass: line " in line and "TODO:" in line for line in told)


@pytest.mark.slow
@pytest.mark.parametrize("form", FORMS)
def test_filled_in_it_keeps_its_promises(kinlint, here, form):
    """In each format, as a rule of one's own."""
    kinlint("new", "gripper/space-in-name", "--code", "GRP001", "--format", form)
    path = here / "rules/gripper/space-in-name.ttl"
    text = path.read_text("utf-8")
    old, new = FORMS[form]
    assert old in text
    text = text.replace(old, new)
    if "at:name []" in text:
        text = text.replace("at:name []", "at:name ?name").replace("STR($this)", "?name")
    for old, new in FILLED.items():
        assert old in text
        text = text.replace(old, new)
    if "at:name" in text:
        fault = "_" if form == "usd" else " "
        text = text.replace('CONTAINS(STR($this), "%20")', f'CONTAINS(?name, "{fault}")')
    path.write_text(text, "utf-8")
    code, out, _ = kinlint("test-rules", "rules")
    assert (code, out) == (0, "1 rule with 1 example: all keep their promises.\n")
    assert kinlint("new", "gripper/another-fault")[1].startswith(
        "rules/gripper/another-fault.ttl: GRP002"
    )


@pytest.mark.slow
def test_a_code_of_kinlint_is_not_given_away(kinlint, write):
    """Outside of its own rules, codes begin with what the configuration or the option says."""
    code, _, err = kinlint("new", "limits/limit-of-glass")
    assert (code, "codes in LIM are kinlint's own" in err) == (2, True)
    write("kinlint.toml", 'code-prefix = "ACME"\n')
    assert "ACME001" in kinlint("new", "limits/limit-of-glass")[1]
    assert "ACME002" in kinlint("new", "gripping/loose")[1]
    write("kinlint.toml", 'code-prefix = "acme"\n')
    assert "code-prefix: 'acme' is not one to eight capitals" in kinlint("new", "limits/x")[2]


def test_a_family_of_ones_own_has_a_prefix_of_its_own(kinlint, here):
    """Which its other rules share."""
    for name, code in (("hand-held", "GRI001"), ("held-twice", "GRI002")):
        code_and_out = kinlint("new", f"gripping/{name}")[:2]
        path = f"rules/gripping/{name}.ttl"
        said = f"{path}: {code}. Replace each TODO, then run: kinlint test-rules {path}\n"
        assert code_and_out == (0, said)


def test_it_overwrites_nothing(kinlint, here):
    """And takes no name or code that is taken."""
    again = ("new", "glass/limit-of-glass", "--directory", "my rules ü")
    assert kinlint(*again)[0] == 0
    path = here / "my rules ü/glass/limit-of-glass.ttl"
    before = path.read_bytes()
    assert "is there already" in kinlint(*again)[2]
    assert "is there already" in kinlint("new", "glass/limit-of-glass.ttl", *again[2:])[2]
    assert path.read_bytes() == before
    assert "called inverted-limit already" in kinlint("new", "limits/inverted-limit")[2]
    assert "LIM001 is that of" in kinlint("new", "limits/x", "--code", "LIM001")[2]


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ([], "expected one FAMILY/NAME"),
        (["limits"], "expected FAMILY/NAME, such as limits/inverted-limit, got 'limits'"),
        (["limits/a", "limits/b"], "expected one FAMILY/NAME"),
        (["limit/x"], "no family is called 'limit', did you mean 'limits'?"),
        (["unique/x"], "codes in UNI are of another family; --code begins one of your own"),
        (["limits/BadLimit"], "is not words of lower case with hyphens, such as 'bad-limit'"),
        (["limits/../x"], "is not words of lower case"),
        (["limits/x", "--code", "lim1"], "'lim1' is not one to eight capitals"),
        (["limits/x", "--format", "sdff"], "is not one of jsonld, turtle, urdf"),
    ],
)
def test_mistakes(kinlint, here, arguments, said):
    """Exit code 2, and no file."""
    code, _, err = kinlint("new", *arguments)
    assert (code, said in err) == (2, True), err
    assert not (here / "rules").exists()
