"""A slip in a namespace is mended at the prefix, in one place, and changes nothing else."""

import pytest

COMPOSABLE = '"https://w3id.org/kinlint/composable.json"'
CHAIN = "https://comp-rob2b.github.io/metamodels/kinematic-chain/structural-entities"
UNIT = "http://qudt.org/vocab/unit/"
ONLY = ("--fix-only", "--unsafe-fixes", "--select", "LD009,LD015,LD031")


def model(context, graph):
    """Return a model with *context* after that of all metamodels."""
    return f'{{"@context": [{COMPOSABLE}, {context}],\n "@graph": [{graph}]}}\n'


JOINTS = '{"@id": "ex:elbow", "@type": "k:Joint"}, {"@id": "ex:wrist", "@type": ["k:Joint"]}'
COORDINATES = (
    '{"@id": "ex:tip", "@type": "PositionCoordinate", "qudt-schema:unit": {"@id": "u:M"}},'
    '{"@id": "ex:top", "@type": "PositionCoordinate", "qudt-schema:unit": {"@id": "u:MilliM"}}'
)
SLIPS = {
    "http for https": (f'"http{CHAIN[5:]}#"', f'"{CHAIN}#"', JOINTS),
    "slash for hash": (f'"{CHAIN}/"', f'"{CHAIN}#"', JOINTS),
    "name of the context file": (f'"{CHAIN}.json#"', f'"{CHAIN}#"', JOINTS),
    "no delimiter": (f'"{CHAIN}"', f'"{CHAIN}#"', JOINTS),
    "a term definition": (
        f'{{"@id": "{CHAIN}/", "@prefix": true}}',
        f'{{"@id": "{CHAIN}#", "@prefix": true}}',
        JOINTS,
    ),
}
UNITS = {
    "a plural of units": ('"http://qudt.org/vocab/units/"', f'"{UNIT}"', COORDINATES),
    "https for http": ('"https://qudt.org/vocab/unit/"', f'"{UNIT}"', COORDINATES),
}


@pytest.mark.slow
@pytest.mark.parametrize("slip", [*SLIPS, *UNITS])
@pytest.mark.parametrize("place", ["{}", "{}, {{}}", '{{"far": "urn:far:"}}, {}'])
def test_a_prefix_is_mended_where_it_is_defined(slip, place, kinlint, write) -> None:
    """Every other byte stays, however often the prefix is used."""
    wrong, right, graph = {**SLIPS, **UNITS}[slip]
    prefix = "k" if slip in SLIPS else "u"

    def text(namespace):
        own = f'{{"ex": "https://example.org/arm#", "{prefix}": {namespace}}}'
        return model(place.format(own), graph)

    path = write("arm.jsonld", text(wrong))

    kinlint("arm.jsonld", *ONLY)

    assert path.read_text() == text(right)
    assert kinlint("arm.jsonld", "--select", "LD009,LD015")[0] == 0


def test_a_term_that_uses_the_prefix_moves_with_it(kinlint, write) -> None:
    """Its definition stays as it is written."""

    def text(namespace):
        own = f'{{"ex": "https://example.org/arm#", "k": "{namespace}", "Link": "k:Joint"}}'
        return model(own, '{"@id": "ex:elbow", "@type": "Link"}')

    path = write("arm.jsonld", text(f"{CHAIN}/"))

    kinlint("arm.jsonld", *ONLY)

    assert path.read_text() == text(f"{CHAIN}#")


def test_whole_names_that_the_prefix_does_not_reach_are_mended_as_well(kinlint, write) -> None:
    """Each at its place."""
    own = f'{{"ex": "https://example.org/arm#", "k": "{CHAIN}/"}}'
    graph = f'{JOINTS}, {{"@id": "ex:knee", "@type": "{CHAIN}/Joint"}}'
    write("arm.jsonld", model(own, graph))

    kinlint("arm.jsonld", *ONLY)

    assert kinlint("arm.jsonld", "--select", "LD009")[0] == 0


def test_the_prefix_of_one_file_becomes_that_of_the_others(kinlint, write) -> None:
    """The names of the file are then those that the others refer to."""
    ours, theirs = (f'{{"ex": "https://example.org/arm{end}"}}' for end in "/#")
    tip = '{"@id": "ex:tip", "@type": ["3D", "Point"]}'
    frame = '{"@id": "ex:tool", "@type": ["3D", "Frame"], "origin": "ex:tip"}'
    path = write("points.jsonld", model(ours, tip))
    write("frames.jsonld", model(theirs, frame))

    kinlint(".", *ONLY)

    assert path.read_text() == model(theirs, tip)


def test_a_prefix_of_a_context_file_is_not_rewritten_elsewhere(kinlint, write) -> None:
    """The uses are left as they are, or mended one by one."""
    shared = f'{{"@context": {{"ex": "https://example.org/arm#", "k": "{CHAIN}/"}}}}'
    context = write("names.json", shared)
    write("arm.jsonld", model('"./names.json"', JOINTS))

    kinlint("arm.jsonld", *ONLY)

    assert context.read_text() == shared


TURTLE = "@prefix ex: <https://example.org/arm#> .\n@prefix {prefix}: {namespace} .\n{body}\n"
TURTLE_SLIPS = {
    "http for https": ("k", f"<http{CHAIN[5:]}#>", f"<{CHAIN}#>", "ex:elbow a k:Joint ."),
    "slash for hash": ("k", f"<{CHAIN}/>", f"<{CHAIN}#>", "ex:elbow a k:Joint ."),
    "SPARQL": ("k", f"<{CHAIN}.json#>", f"<{CHAIN}#>", "ex:elbow a k:Joint . ex:wrist a k:Joint ."),
    "units": (
        "u",
        "<https://qudt.org/vocab/unit/>",
        f"<{UNIT}>",
        "ex:tip <http://qudt.org/schema/qudt/unit> u:M .",
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("slip", TURTLE_SLIPS)
def test_a_prefix_is_mended_in_turtle(slip, kinlint, write) -> None:
    """At its declaration, where the finding is, too."""
    prefix, wrong, right, body = TURTLE_SLIPS[slip]
    path = write("arm.ttl", TURTLE.format(prefix=prefix, namespace=wrong, body=body))

    told = kinlint("arm.ttl", "--select", "LD009", "--output-format", "concise")[1]
    kinlint("arm.ttl", *ONLY)

    assert told.startswith("arm.ttl:2:12: ")
    assert path.read_text() == TURTLE.format(prefix=prefix, namespace=right, body=body)


def test_files_in_turtle_define_a_prefix_alike(kinlint, write) -> None:
    """What one file names is described in the other; an empty prefix is each file's own."""
    joint = f"@prefix k: <{CHAIN}#> .\n@prefix arm: <https://example.org/arm#> .\n"
    joint += (
        "@prefix : <urn:a:> .\narm:elbow a k:Joint ; k:between-attachments arm:seat , arm:root .\n"
    )
    frame = "@prefix g: <https://comp-rob2b.github.io/metamodels/geometry/structural-entities#> .\n"
    frame += "@prefix : <urn:b:> .\n@prefix arm: <https://example.org/{}> .\n"
    frame += "arm:seat a g:Frame . arm:root a g:Frame . arm:arm a g:SimplicialComplex .\n"
    path = write("joint.ttl", joint)
    write("frame.ttl", frame.format("arms#"))

    told = kinlint("joint.ttl", "frame.ttl", "--select", "LD031", "--output-format", "concise")[1]
    kinlint("joint.ttl", "frame.ttl", *ONLY)

    assert [line[:15] for line in told.splitlines() if "LD031" in line] == ["joint.ttl:2:14:"]
    assert path.read_text() == joint.replace("arm#", "arms#")
