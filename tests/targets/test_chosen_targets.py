"""Targets are consumers with versions; what each makes of a feature is data."""

import re

import pytest
from support.linting import book, findings

from kinlint import resources
from kinlint.catalogue.rulebook import load
from kinlint.cli.main import main
from kinlint.configuration.settings import Choice, FileSettings
from kinlint.engine.compiler.shapes_compiler import compile_shapes
from kinlint.engine.evaluate import check
from kinlint.engine.store import Store
from kinlint.errors import UsageError
from kinlint.rule import Severity
from kinlint.targets.chosen_target import Target, chosen_targets, read_target
from kinlint.targets.consumer_files import consumer_table, read_consumers
from kinlint.targets.portability import Portability
from kinlint.targets.version_range import VersionRange, read_version

DATA = resources.data("shapes") / "targets"


@pytest.mark.parametrize(
    ("text", "expected"),
    [("drake", Target("drake")), ("mujoco@3.3", Target("mujoco", (3, 3)))],
)
def test_a_target_is_a_name_and_a_version(text, expected):
    """Without a version, the newest is meant."""
    assert read_target(text) == expected
    assert expected.text == text


@pytest.mark.parametrize("text", ["mujoco@", "mujoco@x", "mujoco@3.", "mujoco@٣", "a@1@2"])
def test_what_is_no_version_is_an_error(text):
    """It is told with what was expected."""
    with pytest.raises(UsageError, match="expected a version"):
        read_target(text)


@pytest.mark.parametrize(
    ("versions", "version", "expected"),
    [
        (VersionRange(), "1", True),
        (VersionRange("3.13"), "3.12.9", False),
        (VersionRange("3.13"), "3.13.0", True),
        (VersionRange("", "3.13"), "3.9", True),
        (VersionRange("", "3.13"), "3.13", False),
        (VersionRange("3", "4"), "3.99", True),
    ],
)
def test_versions_compare_by_their_numbers(versions, version, expected):
    """3.9 is before 3.13, and 3.13.0 is 3.13."""
    assert versions.has(read_version(version)) == expected


def test_the_newest_version_is_after_all_others():
    """What ended does not hold for it."""
    assert VersionRange("3.13").has(None)
    assert not VersionRange("", "3.13").has(None)


def test_a_version_that_no_release_is_near_is_an_error(capsys):
    """The known ones are told; later ones that may come are taken for the newest."""
    assert main(["targets", "urdfdom@60"]) == 2
    assert "known versions of urdfdom are 4.0.1, 6.0.0" in capsys.readouterr().err
    assert main(["targets", "urdfdom@7.1"]) == 0


def test_a_name_may_stand_for_several_consumers():
    """What holds for one of them is told of each."""
    assert chosen_targets(["gazebo"]) == (Target("gazebo-classic"), Target("gazebo-sim"))


def test_a_version_of_several_is_of_those_that_have_it():
    """Gazebo 11 is Classic, 8 is Sim, and 9 is both."""
    told = {
        text: [one.name for one in chosen_targets([f"gazebo@{text}"])] for text in ["8", "9", "11"]
    }
    assert told["11"] == ["gazebo-classic"]
    assert told["8"] == ["gazebo-sim"]
    assert told["9"] == ["gazebo-classic", "gazebo-sim"]


def test_what_is_a_special_case_is_told_as_that_alone():
    """A link without shapes has no mass by its shapes."""
    bare = ROBOT.replace("<joint", "<link name='tip'/><joint").replace(
        '<mimic joint="right"/>', "<parent link='palm'/><child link='tip'/><axis xyz='0 0 1'/>"
    )
    told = findings(bare, rules=load(), default=FileSettings(targets=("mujoco",)))
    assert [each.feature for each in told if each.rule.code == "INE004"] == ["bare-moving-link"]


def test_who_reads_a_feature_reads_its_special_cases():
    """So the special case can be reported alone."""
    table = consumer_table()
    special = [each for each in table.features.values() if each.narrows]
    for consumer in table.consumers.values():
        cells = {cell.feature for cell in consumer.cells}
        assert {each.name for each in special if each.narrows in cells} <= cells


def test_a_consumer_that_reads_by_another_does_as_that_one_does():
    """But for what it does itself."""
    table = consumer_table()
    own = table.cell("pinocchio", (4, 1), "mimic")
    inherited = table.cell("pinocchio", (4, 1), "missing-limit")
    before = table.cell("pinocchio", (3, 4), "quaternion")

    assert own.behaviour.name == "ignored-silently"
    assert inherited.behaviour.name == "refused"
    assert before.behaviour.name == "refused"
    assert before.versions == VersionRange("", "4.0")


def test_a_feature_that_somebody_departs_from_has_advice():
    """So a finding tells what to write; rules that report it are those of the catalogue."""
    table = consumer_table()
    departed = {
        cell.feature
        for consumer in table.consumers.values()
        for cell in consumer.cells
        if cell.severity is not None
    }
    assert [name for name in sorted(departed) if not table.features[name].alternatives] == []
    told = {rule for each in table.features.values() for rule in each.told_by}
    assert told <= book().by_name.keys()


BALL = """<sdf version="1.9"><model name="m"><link name="a"/><link name="b"/>
<joint name="hip" type="ball"><parent>a</parent><child>b</child></joint></model></sdf>"""
BALLS = """<mujoco model="m"><worldbody><body name="a"><joint name="j"/>
<geom type="ellipsoid" size="1 2 3"/></body></worldbody></mujoco>"""
STAGE = """#usda 1.0
(
    defaultPrim = "a"
    metersPerUnit = 0.01
    upAxis = "Z"
)
def Xform "a" {}
"""


@pytest.mark.parametrize(
    ("name", "text", "target", "expected"),
    [
        ("a.sdf", BALL, "pybullet", ("error", "Write three revolute joints in a row.")),
        ("a.xml", BALLS, "pybullet", ("warning", "Write it as a mesh.")),
        ("a.usda", STAGE, "newton", ("warning", "with metersPerUnit = 1.")),
        ("a.sdf", BALL, "drake", None),
        ("a.sdf", BALL, None, None),
    ],
)
def test_features_that_no_rule_knows_are_told_too(name, text, target, expected):
    """The table says what the target does, how bad that is, and what to write instead."""
    default = FileSettings(targets=(target,) if target else ())
    told = [each for each in findings({name: text}, default=default) if each.rule.code == "POR018"]
    told = [each for each in told if each.feature != "sdf-link-without-inertial"]
    assert len(told) == (expected is not None)
    for each in told:
        assert (each.severity.label, each.message.endswith(expected[1])) == (expected[0], True)


def test_a_defect_is_told_once():
    """Its own rule says what targets make of it."""
    heavy = ROBOT.replace(
        '<link name="palm"/>',
        '<link name="palm"><inertial><mass value="-1"/>'
        '<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>',
    )
    told = findings(heavy, default=FileSettings(targets=("mujoco",)))
    (one,) = (each for each in told if each.feature == "negative-mass")
    assert one.rule.code == "INE003"
    assert "In MuJoCo, the file is rejected, as what moves needs a mass." in one.message


def test_files_of_consumers_say_what_they_must():
    """They conform to their shape: each cell names a known feature and behaviour, and evidence."""
    store = Store()
    store.load_vocabulary(sorted(DATA.rglob("*.ttl")))
    shapes = compile_shapes([DATA / "vocabulary" / "consumer-shape.ttl"])

    assert [(each.focus, each.path) for each in check(store, shapes)] == []


def test_cells_of_a_feature_do_not_overlap():
    """One version of a consumer does one thing."""
    for consumer in consumer_table().consumers.values():
        bounds = {bound for cell in consumer.cells for bound in cell.versions if bound}
        for version in (*map(read_version, bounds), (0,), None):
            found = [cell.feature for cell in consumer.cells if cell.versions.has(version)]
            assert len(found) == len(set(found)), (consumer.name, version)


def test_adding_a_consumer_is_adding_a_file(tmp_path):
    """Nothing else names the consumers; the example is that of the documentation."""
    (example,) = re.findall(
        r"^```turtle\n(.*?)^```$", (DATA / "README.md").read_text("utf-8"), re.MULTILINE | re.DOTALL
    )
    (tmp_path / "acme.ttl").write_text(example, "utf-8")
    for file in (*DATA.glob("*.ttl"), *(DATA / "vocabulary").iterdir()):
        (tmp_path / file.name).write_bytes(file.read_bytes())

    table = read_consumers(tmp_path)

    assert table.cell("acme", read_version("1.4"), "mimic").outcome == "the coupling is lost"


def test_sentences_tell_who_does_what_and_what_all_read_alike():
    """With the versions that do so, and an alternative that the targets agree about."""
    both = Portability.of("quaternion", chosen_targets(["mujoco", "drake"]))

    assert both.sentences == (
        "In MuJoCo, there is no rotation; in Drake, there is no rotation; only the version is "
        "warned of. Write the orientation as 'rpy'."
    )
    assert Portability.of("mimic", chosen_targets(["mujoco"])).sentences == ""
    assert Portability.of("mimic", chosen_targets(["mujoco@3.3"])).sentences == (
        "In MuJoCo before 3.13, the coupling is dropped silently. Couple the joints where the "
        "robot is loaded."
    )


def test_an_alternative_that_a_target_departs_from_is_no_advice():
    """Equal limits are not written as a fixed joint for one that merges links."""
    assert Portability.of("equal-limits", chosen_targets(["mujoco"])).advice == ""
    assert Portability.of("equal-limits", chosen_targets(["drake"])).advice != ""


def test_assumptions_are_told_where_they_contradict_each_other():
    """One target assumes what it likes."""
    feature = "root-not-joined-to-world"
    assert not Portability.of(feature, chosen_targets(["drake"])).departures
    assert not Portability.of(feature, chosen_targets(["drake", "pybullet"])).departures
    assert len(Portability.of(feature, chosen_targets(["drake", "mujoco"])).departures) == 2


RULE = """
@prefix feature: <https://w3id.org/kinlint/feature#> .
@prefix kl:   <https://w3id.org/kinlint/ns#> .
@prefix sh:   <http://www.w3.org/ns/shacl#> .
@prefix urdf: <https://w3id.org/kinlint/urdf#> .
<https://w3id.org/kinlint/rules/follower> a kl:Rule, sh:NodeShape ; kl:code "ZZZ001" ;
    kl:format "urdf" ; sh:severity sh:Info ; sh:targetObjectsOf urdf:mimic ;
    sh:sparql
        [ sh:message "Chosen." ; kl:feature feature:mimic ; kl:speaksOf kl:chosenTargets ;
          sh:select "SELECT $this WHERE { ?joint <https://w3id.org/kinlint/urdf#mimic> $this }" ] ,
        [ sh:message "All." ; kl:feature feature:mimic ; kl:speaksOf kl:allConsumers ;
          sh:select "SELECT $this WHERE { ?joint <https://w3id.org/kinlint/urdf#mimic> $this }" ] ,
        [ sh:message "Plain." ; kl:feature feature:mimic ;
          sh:select "SELECT $this WHERE { ?joint <https://w3id.org/kinlint/urdf#mimic> $this }" ] ,
        [ sh:message "Old." ; kl:target "mujoco" ;
          sh:select '''SELECT $this ("3.9" AS ?targetUntil)
            WHERE { ?joint <https://w3id.org/kinlint/urdf#mimic> $this }''' ] .
"""
ROBOT = """<robot name="hand"><link name="palm"/>
<joint name="left" type="prismatic"><mimic joint="right"/></joint></robot>"""


@pytest.mark.parametrize(
    ("targets", "expected"),
    [
        ((), {"All.": "info", "Plain.": "info"}),
        (("drake",), {"Plain.": "info"}),
        (("mujoco",), {"Plain.": "info"}),
        (("mujoco@3.10",), {"Chosen.": "warning", "All.": "warning", "Plain.": "warning"}),
        (
            ("mujoco@3.3",),
            {"Chosen.": "warning", "All.": "warning", "Plain.": "warning", "Old.": "info"},
        ),
        (("kdl", "mujoco"), {"Chosen.": "warning", "All.": "warning", "Plain.": "warning"}),
    ],
)
def test_rules_read_the_table(tmp_path, targets, expected):
    """A constraint that finds a feature speaks of the targets that depart from it."""
    (tmp_path / "follower.ttl").write_text(RULE, "utf-8")

    found = findings(ROBOT, rules=load((tmp_path,)), default=FileSettings(targets=targets))

    told = {each.message: each.severity.label for each in found if each.rule.code == "ZZZ001"}
    assert {message.split(" In ")[0]: said for message, said in told.items()} == expected


def test_the_message_ends_in_what_targets_do(tmp_path):
    """A template and arguments of it make the same."""
    (tmp_path / "follower.ttl").write_text(RULE, "utf-8")
    default = FileSettings(targets=("kdl", "mujoco"))

    found = findings(ROBOT, rules=load((tmp_path,)), default=default)

    (told,) = (each for each in found if each.template.startswith("Chosen."))
    assert told.message == (
        "Chosen. In KDL, the coupling is ignored silently; in MuJoCo from 3.13 on, it becomes an "
        "equality. Couple the joints where the robot is loaded."
    )
    assert told.arguments[-1] in told.message


@pytest.mark.slow
def test_a_severity_of_the_configuration_counts_most(tmp_path):
    """Whatever targets make of it."""
    (tmp_path / "follower.ttl").write_text(RULE, "utf-8")
    choice = Choice(severity=(("ZZZ001", Severity.ERROR),))
    default = FileSettings((choice,), targets=("kdl",))

    found = findings(ROBOT, rules=load((tmp_path,)), default=default)

    assert {each.severity for each in found if each.rule.code == "ZZZ001"} == {Severity.ERROR}


def test_the_command_lists_consumers(capsys):
    """One a line."""
    assert main(["targets"]) == 0
    listed = [line.split()[0] for line in capsys.readouterr().out.splitlines()]
    assert listed == sorted(path.stem for path in DATA.glob("*.ttl"))


def test_the_command_tells_what_is_known_of_one(capsys):
    """With the evidence of each cell."""
    assert main(["targets", "mujoco@3.3"]) == 0
    told = capsys.readouterr().out
    assert "ignored silently before 3.13: the coupling is dropped silently" in told
    assert "measured with 3.3.7, 3.12.0" in told
    assert "https://github.com/google-deepmind/mujoco/issues/3527" in told
    assert "it becomes an equality" not in told


def test_the_command_suggests(capsys):
    """A slip is no error without help."""
    assert main(["targets", "mujco"]) == 2
    assert "unknown target 'mujco', did you mean 'mujoco'?" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("target", "expected"),
    [("gazebo-classic", "refused"), ("gazebo-sim@6", "honoured"), ("sdformat@11", "refused")],
)
def test_readers_of_older_sdf_reject_newer_files(target, expected):
    """Each release of libsdformat has a version of SDF, and converts older ones to it."""
    (reading,) = Portability.of("sdf-1.9", chosen_targets([target])).readings
    assert reading.cell.behaviour.name == expected
