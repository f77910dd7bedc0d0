"""Results about what was lifted point to the text that it was lifted from."""

from dataclasses import replace

from kinlint.configuration.settings import Settings
from kinlint.document import Document, SourceMap
from kinlint.engine.constraint import Constraint
from kinlint.engine.lifting import lift
from kinlint.engine.result import Result
from kinlint.engine.store import Store
from kinlint.findings.locator import Locator
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import read
from kinlint.formats.xacro.format import XACRO
from kinlint.terms import XSD, iri, literal
from kinlint.text import SourceText, Span
from kinlint.vocabulary import KIN, METAMODELS

ROBOT = """<robot name="arm">
  <link name="base"/>
  <link name="lower arm"/>
  <joint name="elbow" type="revolute">
    <parent link="base"/>
    <child link="lower arm"/>
    <limit lower="-1.50" upper="2" effort="5" velocity="1"/>
  </joint>
</robot>
"""
BASE = "urn:kinlint:document:arm.urdf#"


def locator(text=ROBOT, name="arm.urdf"):
    document = read(SourceText(name, text), ReadOptions.from_settings(Settings()))
    store = Store()
    store.load([document])
    lift(store)
    return Locator([document], store)


def shown(location):
    return location.source[location.span]


def result(focus, path=None, value=None, **bindings):
    constraint = Constraint(owner="urn:x:rule", shape="<urn:x:s>", component="", severity="")
    return Result(constraint, focus, path, value, None, bindings)


def test_a_lifted_node_is_where_its_element_is():
    """By what it says it is from."""
    found = locator()

    assert shown(found.node(iri(f"{BASE}joint/elbow/position-limit"))) == "limit"
    assert found.node(iri(f"{BASE}joint/elbow")) == found.node(iri(f"{BASE}/joint/elbow"))
    assert found.node(iri(f"{BASE}joint/none")) is None


def test_a_lifted_value_is_where_it_is_spelled():
    """At the attribute that has it, whatever the lifted property is called."""
    limit, lower = iri(f"{BASE}joint/elbow/position-limit"), iri(f"{KIN}lower")
    value = literal("-1.50", f"{XSD}double")
    said = result(limit, lower, value)

    assert shown(locator().result_location(said, ())) in ("-1.50", '"-1.50"')


def test_a_result_that_nothing_shows_is_at_the_beginning():
    """Of the first file."""
    assert locator().result_location(result(iri("urn:x:none")), ()).span == Span(0, 0)


def test_where_a_rule_says_to_look_comes_first():
    """By `?at`, though the focus node is elsewhere."""
    found = locator()
    base, elbow = iri(f"{BASE}/link/base"), iri(f"{BASE}/joint/elbow")

    assert found.result_location(result(base, at=elbow), ()) == found.node(elbow)


def test_a_document_of_several_texts_knows_which_is_meant():
    """Spans count through all pieces; a piece may come again."""
    main, macro = SourceText("main.xacro", "0123456789"), SourceText("macro.xacro", "abcdef")
    whole = Document(main, "<urn:x:g>", (), SourceMap(), format=XACRO)
    made = replace(whole, pieces=((0, main), (10, macro), (16, main)))

    assert whole.location(Span(3, 5)).source is main
    assert [shown(made.location(Span(*span))) for span in ((9, 10), (10, 12), (15, 16))] == [
        "9",
        "ab",
        "f",
    ]
    assert made.location(Span(17, 19)).span == Span(1, 3)
    assert made.sources == (main, macro, main)


COMPOSED = """<sdf version="1.9">
  <model name="arm">
    <link name="base"><pose>0 0 1 0 0 0</pose></link>
    <link name="hand"><pose>0 0 2 0 0 0</pose></link>
    <joint name="elbow" type="revolute">
      <pose>0 0 3 0 0 0</pose>
      <parent>base</parent>
      <child>hand</child>
      <axis><xyz>0 0 1</xyz></axis>
    </joint>
  </model>
</sdf>
"""


def test_a_composed_value_has_a_source_in_each_element():
    """The element of the joint itself is the first of them."""
    found = locator(COMPOSED, "arm.sdf")
    position = iri("urn:kinlint:document:arm.sdf#model/arm/joint/elbow/pose/position")
    z = iri(f"{METAMODELS}geometry/coordinates#z")
    (value,) = found.store.values(position, z)

    sources = found.result_sources(result(position, z, value), ())

    assert [shown(each.location) for each in sources] == [
        "0 0 3 0 0 0",
        "0 0 2 0 0 0",
        "0 0 1 0 0 0",
    ]
    assert shown(found.result_location(result(position, spot=z), ())) == "0 0 3 0 0 0"
