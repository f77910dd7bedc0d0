"""SPARQL: its tokens, its parser, the abstract syntax tree (AST), and questions about that.

Nothing here knows of SHACL, of rules or of the store: who compiles rules, mends models or lifts
XML formats reads queries and updates here.
"""
