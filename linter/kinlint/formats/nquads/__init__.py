"""N-Triples and N-Quads: one statement a line."""
