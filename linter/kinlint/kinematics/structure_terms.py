"""Terms that a run has to ask for, so that the store has all that structures are made of."""

from __future__ import annotations

from kinlint.facts.mechanism import BODY, DIRECTED, FRAME, JOINT, KINDS
from kinlint.facts.metamodel_terms import chain, geom, kin
from kinlint.kinematics.joint_numbers import NEEDED

ASKED = frozenset(
    {
        *DIRECTED,
        kin("first-axis"),
        *(BODY, JOINT, FRAME, geom("simplices"), kin("on-body"), kin("JointCoupling")),
        *(chain("between-attachments"), chain("joints"), kin("leader"), kin("follower")),
        *(kin("multiplier"), kin("TwoAxisJoint"), *(kind for kind, _ in KINDS), *NEEDED),
    }
)
"""Properties and classes."""
