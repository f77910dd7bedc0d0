"""Programs from models: what is stated, rewritten by SPARQL Updates, framed and rendered."""
