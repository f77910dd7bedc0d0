"""Facts: numbers and graphs that SPARQL cannot compute, derived from a closed model as triples."""
