"""Files that a model is made of, and copies of their elements with nodes and names of their own."""

from __future__ import annotations

from kinlint.formats.mjcf.compiler_settings import CompilerSettings
from kinlint.formats.mjcf.default_classes import DefaultClasses
from kinlint.formats.mjcf.mjcf_elements import MjcfElement
from kinlint.formats.mjcf.orientation import pose
from kinlint.formats.rigid_transform import Transform
from kinlint.light_dataclasses import dataclass
from kinlint.terms import Term


@dataclass(eq=False)
class ModelFile:
    """A model as it is written, with its included files."""

    root: MjcfElement
    """Its root."""
    settings: CompilerSettings
    """Settings of its compiler."""
    models: dict[str, MjcfElement]
    """Roots of the models that it may attach, by name."""
    named: dict[tuple[str, str], MjcfElement]
    """Its elements by tag and name."""

    @classmethod
    def from_root(cls, root: MjcfElement) -> ModelFile:
        """Return the file with *root*, whose elements get what they inherit."""
        DefaultClasses.from_root(root).apply(root)
        named: dict[tuple[str, str], MjcfElement] = {}
        for each in root.below():
            named.setdefault((each.tag, each.name), each)
        return cls(root, CompilerSettings.from_root(root), _models(root), named)


@dataclass
class ElementCopy:
    """The circumstances under which elements are taken into the model."""

    file: ModelFile
    """Their file."""
    prefix: str = ""
    """Text before their names."""
    suffix: str = ""
    """Text behind their names."""
    mark: str = ""
    """End of their nodes, which no other copies have."""

    scaled: bool = False
    """True if they stand in a frame that scales lengths, which are unknown then."""

    def pose(self, element: MjcfElement) -> Transform | None:
        """Return the pose that *element* says, as far as it is known."""
        return None if self.scaled else pose(element, self.file.settings)

    def name(self, element: MjcfElement) -> str:
        """Return the name of the copy of *element*."""
        return f"{self.prefix}{element.name}{self.suffix}" if element.name else ""

    def node(self, element: MjcfElement) -> Term:
        """Return the node of the copy of *element*."""
        return f"{element.node[:-1]}{self.mark}>" if self.mark else element.node


def _models(root: MjcfElement) -> dict[str, MjcfElement]:
    """Return the roots of the models that the file with *root* may attach, by their names."""
    assets = (each for section in root.all("asset") for each in section.all("model"))
    return {each.name or top.text("model"): top for each in assets for top in each.children}
