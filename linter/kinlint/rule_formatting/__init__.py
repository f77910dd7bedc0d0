"""The formatter of rule files: one layout of their Turtle, and of the SPARQL in it."""
