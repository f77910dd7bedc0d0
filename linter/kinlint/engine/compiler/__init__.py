"""Compiles SHACL shapes into SELECT queries for Oxigraph, each judging all focus nodes at once.

Violations of one constraint are the solutions of

    SELECT … WHERE { { SELECT DISTINCT ?this WHERE { targets } } LATERAL { body } }

LATERAL evaluates the body once per focus node with `?this` bound wherever it occurs, which is
what SHACL calls pre-binding. The body is the author's WHERE clause, or what a Core component
means; a shape that another one refers to becomes an EXISTS expression. What cannot be shown to
mean the same is deferred to the reference engine.

Everything here runs when rules are compiled, not when models are checked.
"""
