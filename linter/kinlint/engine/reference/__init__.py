"""The engines kinlint is measured by: pySHACL and owlrl over rdflib. Slow, and loaded on demand."""
