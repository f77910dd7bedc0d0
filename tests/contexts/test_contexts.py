"""The bundled contexts mean what the published ones mean."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from data import locate_data
from pyld import jsonld
from transcribe import transcribe

from kinlint.contexts.context_library import (
    COMMUNITY,
    COMPOSABLE,
    NEWEST,
    RELEASE_DATES,
    RELEASES,
    Contexts,
    bundled_source,
)
from kinlint.errors import UsageError
from kinlint.terms import RDF_TYPE, XSD
from kinlint.vocabulary import KIN, KINLINT, METAMODELS

GEOM = f"{METAMODELS}geometry/structural-entities#"

Documents = Callable[[str], dict[str, Any] | None]


def published(release: str) -> Documents:
    root = locate_data("comp-rob2b", "metamodels", release)

    def document(iri: str) -> dict[str, Any] | None:
        path = root / iri.removeprefix(METAMODELS)
        if not iri.startswith(METAMODELS) or not path.exists():
            return None
        found: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
        return found

    return document


def published_iris(release: str) -> list[str]:
    root = locate_data("comp-rob2b", "metamodels", release)
    return sorted(METAMODELS + path.relative_to(root).as_posix() for path in root.rglob("*.json"))


def loader(documents: Documents) -> Callable[..., dict[str, Any]]:
    """A PyLD document loader; contexts that *documents* does not know are empty."""

    def load(iri: str, _options: object = None) -> dict[str, Any]:
        document = documents(iri) or {"@context": {}}
        return {"contextUrl": None, "documentUrl": iri, "document": document}

    return load


def effect(local: Any, documents: Documents) -> dict[str, Any]:
    """The term definitions of *local* as a processor sees them, scoped contexts included."""
    options = {"documentLoader": loader(documents), "base": "", "processingMode": "json-ld-1.1"}
    options["contextResolver"] = jsonld.ContextResolver({}, options["documentLoader"])
    processor = jsonld.JsonLdProcessor()
    initial = processor._get_initial_context(options)

    def terms(active: Any, seen: Any) -> dict[str, Any]:
        found = {}
        for term, definition in active["mappings"].items():
            if seen.get(term) == definition:
                continue
            plain = {key: value for key, value in definition.items() if key != "@context"}
            if "@context" in definition:
                inner = processor.process_context(active, definition["@context"], options)
                plain["base"] = inner.get("@base")
                plain["scoped"] = terms(inner, active["mappings"])
            found[term] = plain
        return found

    return terms(processor.process_context(initial, local, options), {})


def quads(model: Path, documents: Documents) -> set[str]:
    options = {"documentLoader": loader(documents), "base": "https://base.invalid/"}
    options |= {"format": "application/n-quads"}
    text = json.loads(model.read_text(encoding="utf-8"))
    return set(jsonld.to_rdf(text, options).splitlines())


@pytest.mark.parametrize("release", RELEASES)
def test_documents(release: str) -> None:
    """A release has exactly the published documents."""
    bundled = [iri for iri in Contexts.bundled(release).iris if iri.startswith(METAMODELS)]

    assert sorted(bundled) == published_iris(release)


@pytest.mark.parametrize("release", RELEASES)
def test_terms(release: str) -> None:
    """Every document defines the published terms, prefixes and scoped contexts, and no other."""
    ours, theirs = Contexts.bundled(release).document, published(release)

    for iri in published_iris(release):
        assert effect(ours(iri), ours) == effect(theirs(iri), theirs), iri


@pytest.mark.parametrize("release", RELEASES)
def test_redefined_prefix(release: str) -> None:
    """A file that redefines every prefix changes bundled and published contexts alike."""
    ours, theirs = Contexts.bundled(release).document, published(release)

    for iri in published_iris(release):
        own = theirs(iri)
        assert own is not None
        prefixes = {k: f"urn:{k}:" for k, v in own["@context"].items() if str(v)[-1] in "#/"}
        assert prefixes
        assert effect([iri, prefixes], ours) == effect([iri, prefixes], theirs), iri


@pytest.mark.slow
@pytest.mark.parametrize("release", RELEASES)
def test_models(release: str) -> None:
    """Every model of the metamodels' authors is the same graph under both."""
    ours, theirs = Contexts.bundled(release).document, published(release)
    root = locate_data("comp-rob2b")
    models = [path for path in root.rglob("*.json") if "metamodels" not in path.parts]
    sizes = []

    for model in models:
        expected = quads(model, theirs)
        assert quads(model, ours) == expected, model
        sizes.append(len(expected))

    assert len(models) > 45
    assert sum(sizes) > 2500


@pytest.mark.parametrize("release", RELEASES)
def test_composable_shadows_nothing(release: str) -> None:
    """In composable.json no term of one document takes another meaning from a later one."""
    contexts = Contexts.bundled(release)
    document = contexts.document(COMPOSABLE)
    assert document is not None

    meanings: dict[str, set[str]] = {}
    for local in document["@context"]:
        for term, definition in effect(local, contexts.document).items():
            if not definition["_prefix"]:
                meanings.setdefault(term, set()).add(json.dumps(definition, sort_keys=True))
    shadowed = sorted(term for term, found in meanings.items() if len(found) > 1)

    # In 2023-10 the inertia's `of` and the spatial relations' were both on every node.
    assert shadowed == {"6d34a4f": ["of"]}.get(release, [])


def test_composable_is_complete() -> None:
    """One line stands for all documents of the newest release but the two that shadow others."""
    contexts = Contexts.bundled()
    left_out = {"newtonian-rigid-body-dynamics.json", "qudt-quant.json"}
    iris = [iri for iri in contexts.iris if iri.removeprefix(METAMODELS) not in left_out]
    ours = [iri for iri in iris if iri.startswith((METAMODELS, KINLINT)) and iri != COMPOSABLE]
    documents = [contexts.document(iri) or {} for iri in ours]
    one_by_one = effect([document["@context"] for document in documents], contexts.document)

    together = effect(COMPOSABLE, contexts.document)

    assert set(together) == set(one_by_one)
    assert together["kc"]["@id"] == f"{METAMODELS}kinematic-chain/structural-entities#"
    del together["kc"], one_by_one["kc"]
    assert together == one_by_one


def test_notation() -> None:
    """The notation says coercion, container, name, base, enumeration and scope."""
    contexts = Contexts.bundled("ba7e601")
    prefix = f"{METAMODELS}geometry/spatial-operators#"

    operators = contexts.document(f"{METAMODELS}geometry/spatial-operators.json")
    qudt = contexts.document(f"{METAMODELS}qudt.json")
    chain = contexts.document(f"{METAMODELS}kinematic-chain/structural-entities.json")

    assert operators is not None
    assert qudt is not None
    assert chain is not None
    assert operators["@context"]["geom-op"] == prefix
    assert operators["@context"]["PoseToAngleAroundAxis"]["@context"]["axis"] == {
        "@id": "geom-op:axis",
        "@type": "@vocab",
        "@context": {"x": "geom-op:x", "y": "geom-op:y", "z": "geom-op:z"},
    }
    assert qudt["@context"]["quantity-kind"] == {
        "@id": "qudt-schema:hasQuantityKind",
        "@type": "@id",
        "@context": {"@base": "http://qudt.org/vocab/quantitykind/"},
    }
    assert chain["@context"]["joints"] == {"@id": "kc:joints", "@type": "@id", "@container": "@set"}
    assert chain["@context"]["Joint"] == "kc:Joint"


def test_kinlint_terms() -> None:
    """What comp-rob2b lacks is at hand in every release, in one namespace of four documents."""
    expected = {
        "kinematics": {"PrismaticJoint", "RevoluteJointWithPolarity", "ZeroConfiguration"},
        "actuation": {"Actuator", "ActuatorForceLimit"},
        "geometry-references": {"VisualGeometry", "CollisionGeometry", "Box"},
        "orientation": {"EulerAngles", "Extrinsic", "Quaternion"},
    }
    for release in RELEASES:
        contexts = Contexts.bundled(release)
        ours = [iri for iri in contexts.iris if iri.startswith(KINLINT) and iri != COMPOSABLE]
        assert ours == [f"{KINLINT}{path}.json" for path in expected]
        for path, classes in expected.items():
            terms = effect(f"{KINLINT}{path}.json", contexts.document)
            assert classes <= terms.keys()
            names = {terms[each]["@id"] for each in terms}
            assert {f"{KIN}{each}" for each in classes} <= names
            assert all(each.startswith(KIN) for each in names - {XSD})


@pytest.mark.parametrize(
    ("name", "node", "expected"),
    [
        (
            "kinematics",
            {
                "@type": "RevoluteJointWithPolarity",
                "positive-direction": "a:z",
                "handedness": ["LeftHanded", "RightHanded"],
            },
            {
                f"<{KIN}positive-direction> <a:z>",
                f"<{KIN}handedness> <{KIN}LeftHanded>",
                f"<{KIN}handedness> <{GEOM}RightHanded>",
            },
        ),
        (
            "kinematics",
            {"@type": "JointPositionLimit", "of-joint": "a:j", "upper": 2},
            {f"<{KIN}of-joint> <a:j>", f'<{KIN}upper> "2.0E0"^^<{XSD}double>'},
        ),
        (
            "actuation",
            {"@type": "Actuator", "actuates": "a:j", "gear-ratio": 100},
            {f"<{KIN}actuates> <a:j>", f'<{KIN}gear-ratio> "1.0E2"^^<{XSD}double>'},
        ),
        (
            "orientation",
            {"@type": ["EulerAngles", "Extrinsic"], "axes-sequence": "xyz", "alpha": 0.5},
            {f'<{KIN}axes-sequence> "xyz"', f'<{KIN}alpha> "5.0E-1"^^<{XSD}double>'},
        ),
    ],
)
@pytest.mark.parametrize("place", ["{}.json", "composable.json"])
def test_kinlint_values(name: str, node: dict[str, Any], expected: set[str], place: str) -> None:
    """A node of kinlint's own types states the same under its document and under them all."""
    contexts = Contexts.bundled()
    iri = KINLINT + place.format(name)
    options = {"documentLoader": loader(contexts.document), "format": "application/n-quads"}

    found = jsonld.to_rdf({"@context": iri, "@id": "a:n", **node}, options)

    said = {line[len("<a:n> ") : -len(" .")] for line in found.splitlines()}
    assert {each for each in said if RDF_TYPE not in each} == expected


@pytest.mark.parametrize(
    ("name", "release"),
    [(None, NEWEST), ("newest", NEWEST), ("2022-06", "59e0b06"), ("6d34a4f", "6d34a4f")],
)
def test_release_names(name: str | None, release: str) -> None:
    """A release is called by commit, by month, or "newest", which is the default."""
    assert Contexts.bundled(name).release == release


def test_newest_release() -> None:
    """Releases are in order of their dates."""
    assert list(RELEASE_DATES.values()) == sorted(RELEASE_DATES.values())
    assert NEWEST == RELEASES[-1] == "ba7e601"


def test_unknown_release() -> None:
    """An unknown release is refused with the nearest one and a list."""
    with pytest.raises(UsageError, match=r"'ba7e602', did you mean 'ba7e601'\?.*59e0b06 \(2022"):
        Contexts.bundled("ba7e602")
    with pytest.raises(UsageError, match="unknown release"):
        Contexts.bundled().at_release("main")


def test_unknown_document() -> None:
    """An IRI that nobody bundled has no document, nor has one of another release."""
    assert Contexts.bundled().document("https://example.org/vendor.json") is None
    assert Contexts.bundled("59e0b06").document(f"{METAMODELS}task/map.json") is None


def test_light() -> None:
    """Contexts are read with the standard library alone."""
    script = (
        "import sys; from kinlint.contexts.context_library import Contexts;"
        "Contexts.bundled().document('https://w3id.org/kinlint/composable.json');"
        "print({'pyld', 'rdflib', 'pyoxigraph', 'rich'} & set(sys.modules))"
    )

    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)

    assert run.stdout == "set()\n"


@pytest.mark.parametrize("name", COMMUNITY)
def test_community_contexts_are_equal_in_effect(name: str) -> None:
    """Each published document has the terms of the bundled one, at every address."""
    root = locate_data("contexts", name)
    base = bundled_source(name)["base"]
    bundled = Contexts.bundled()
    others = bundled_source("hbrs-sesame")["documents"]
    paths = {p.relative_to(root).with_suffix("").as_posix(): p for p in root.rglob("*.json")}

    assert paths.keys() == bundled_source(name)["documents"].keys()
    for path, file in paths.items():
        published_document = json.loads(file.read_text(encoding="utf-8"))
        local = {"@version": 1.1, **published_document["@context"]}
        ours = bundled.document(f"{base}{path}.json")
        assert ours is not None
        assert effect({"@version": 1.1, **ours["@context"]}, lambda _: None) == effect(
            local, lambda _: None
        ), path
    if name == "secorolab":
        moved = others.keys() - paths.keys()
        assert "floor-plan/floor-plan" in moved
        for path in moved:
            there = f"https://hbrs-sesame.github.io/metamodels/{path}.json"
            assert bundled.document(f"{base}{path}.json") == bundled.document(there) is not None


def test_transcription() -> None:
    """The script writes the bundled files from the published documents."""
    for name in COMMUNITY:
        bundled = bundled_source(name)
        made = transcribe(bundled["base"], locate_data("contexts", name))
        assert made["documents"] == bundled["documents"]
