"""The namespaces kinlint speaks, as plain strings."""

from __future__ import annotations

METAMODELS = "https://comp-rob2b.github.io/metamodels/"

KINLINT = "https://w3id.org/kinlint/"
KL = f"{KINLINT}ns#"
KIN = f"{KINLINT}kinematics#"
SRC = f"{KINLINT}source#"
STORE = f"{KINLINT}store#"
FACT = f"{KINLINT}fact#"
FMT = f"{KINLINT}format#"
ATTRIBUTE = f"{KINLINT}attribute#"
REFERENCE = f"{KINLINT}reference#"
EXTENSION = f"{KINLINT}extension#"
INHERITED = f"{KINLINT}inherited#"
INTERMEDIATE = f"{KINLINT}intermediate#"
URDF = f"{KINLINT}urdf#"
SDF = f"{KINLINT}sdf#"
SRDF = f"{KINLINT}srdf#"
MJCF = f"{KINLINT}mjcf#"
COLLADA = f"{KINLINT}collada#"
USD = f"{KINLINT}usd#"
YAML = f"{KINLINT}yaml#"
LAUNCH = f"{KINLINT}launch#"
RULE = f"{KINLINT}rules/"
TARGET = f"{KINLINT}target#"
FEATURE = f"{KINLINT}feature#"

SH = "http://www.w3.org/ns/shacl#"
DASH = "http://datashapes.org/dash#"
OWL = "http://www.w3.org/2002/07/owl#"
RDFS = "http://www.w3.org/2000/01/rdf-schema#"
QUDT = "http://qudt.org/schema/qudt/"
UNIT = "http://qudt.org/vocab/unit/"
QUANTITY_KIND = "http://qudt.org/vocab/quantitykind/"

DOCUMENT_BASE = "https://base.kinlint.invalid/"
"""The sentinel base: an IRI that starts with it was relative where it was written."""

INFERRED_GRAPH = f"<{KINLINT}inferred>"
"""The named graph that holds what the closure added."""

LIFTED_GRAPH = f"<{KINLINT}lifted>"
"""The named graph that holds what the lifting queries made of other formats."""

FACTS_GRAPH = f"<{KINLINT}facts>"
"""The named graph that holds what was computed."""
