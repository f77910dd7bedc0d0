"""Dependencies between files: includes, and the URDF that an SRDF refers to.

`mentions` reads from a text, without parsing it, which robots and files it names; `file_groups`
divides the files of a run into models by that; `companions` finds the URDF of an SRDF among
`robot_descriptions`, of the run or in nearby directories, and `joined_documents` joins their
documents; `model_uri` and `included_text` find and read the files that SDF and xacro files include.
"""
