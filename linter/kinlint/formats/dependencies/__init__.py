"""What files have to do with each other: which a file includes, and which SRDF is about which URDF.

`mentions` reads from a text, without parsing it, which robots and files it names; `file_groups`
parts the files of a run into models by that; `companions` finds the URDF of an SRDF, among the
files of the run or beside it, and joins their documents; `model_uri` and `included_text` find and
read the files that SDF and xacro files include.
"""
