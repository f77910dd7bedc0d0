"""USD: scenes of prims with properties, in text, crate or package files."""
