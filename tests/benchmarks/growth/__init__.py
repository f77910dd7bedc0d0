"""How the time of a run grows with files that are large in one respect."""
