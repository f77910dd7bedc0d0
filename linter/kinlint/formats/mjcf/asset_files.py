"""The directories in which MuJoCo looks for the files of assets, as its compiler is told."""

from __future__ import annotations

from kinlint.formats.mjcf.compiler_settings import CompilerSettings
from kinlint.formats.mjcf.mjcf_elements import MjcfElement
from kinlint.formats.mjcf.model_statements import ModelStatements

DIRECTORIES = {
    "mesh": "meshdir", "hfield": "meshdir", "skin": "meshdir", "flexcomp": "meshdir",
    "texture": "texturedir",
}  # fmt: skip
"""The setting with the directory of the files of each kind of element."""


def state_directories(root: MjcfElement, settings: CompilerSettings, said: ModelStatements) -> None:
    """State the directory that files of the model below *root* are in, if it is not their own."""
    strips = settings.text("strippath") == "true"
    for element in root.below():
        setting = DIRECTORIES.get(element.tag)
        if setting is None or not any(name.startswith("file") for name in element.said):
            continue
        said.word(element.node, "filesIn", settings.text(setting) or settings.text("assetdir"))
        if strips:
            said.truth(element.node, "strippedPath", value=True)
