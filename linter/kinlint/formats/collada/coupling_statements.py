"""Statements about formulas of COLLADA that couple the positions of joints."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from kinlint.formats.collada.addressing import Addressing
from kinlint.formats.collada.collada_elements import ColladaElement
from kinlint.formats.collada.formulas import linear
from kinlint.formats.collada.joint_motions import kind_of, unit_of
from kinlint.formats.collada.kinematics import Joint
from kinlint.formats.collada.parameter_values import meant_by
from kinlint.formats.derived_statements import DerivedStatements


class CouplingStatements:
    """Statements about the formulas below *root*."""

    def __init__(
        self,
        root: ColladaElement,
        uses: Mapping[ColladaElement, Sequence[Joint]],
        addressing: Addressing,
        said: DerivedStatements,
    ) -> None:
        self.uses, self.addressing, self.said = uses, addressing, said
        self.formulas = [each for each in root.below() if each.tag == "formula"]

    def state(self) -> None:
        """State all couplings."""
        for formula in self.formulas:
            self._coupling(formula)

    def _coupling(self, formula: ColladaElement) -> None:
        """State the coupling that *formula* makes, if it is linear in the position of one joint."""
        target = formula.first("target", "param")
        math = formula.first("technique_common", "math")
        value = linear(math) if math is not None else None
        for each in math.below() if math is not None else ():
            if each.tag == "csymbol" and each.text("encoding") != "COLLADA":
                self.said.word(each.node, "unencoded", each.text())
        if math is not None and (value is None or value.symbol is None):
            self.said.state(formula.node, "nonlinear", math.node)
        if target is None or value is None or value.symbol is None:
            return
        leaders, followers = self._joints(value.symbol), self._joints(target)
        if len(leaders) != 1 or len(followers) != 1:
            return
        (leader,), (follower,) = leaders, followers
        node, scale = formula.node, unit_of(follower)
        self.said.state(node, "leader", leader.node)
        self.said.state(node, "follower", follower.node)
        self.said.word(node, "jointType", kind_of(follower))
        self.said.state(node, "mathFrom", formula.node)
        self.said.number(node, "multiplier", value.factor * scale / unit_of(leader))
        self.said.number(node, "offset", value.offset * scale)

    def _joints(self, named: ColladaElement) -> Sequence[Joint]:
        """Return the joints of one motion that the text of *named* leads to."""
        meant = meant_by(named, self.addressing)
        if meant is not None and meant.tag == "instance_joint":
            meant = self.addressing.instanced(meant)
        joints = self.uses.get(meant, ()) if meant is not None else ()
        return [each for each in joints if len(each.primitives) == 1]
