"""What SPARQL cannot compute: numbers derived from a closed model, stated as triples."""
