"""Renaming of links, joints, frames, nodes of graphs and macros in all files of a model."""
