"""Models that say nothing of each other: linted in shares, recalled, and reported together."""
