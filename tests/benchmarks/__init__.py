"""Measures kinlint against named peers. Run it with `python tests/benchmarks`."""
