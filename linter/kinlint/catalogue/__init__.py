"""The rules: their files, the catalogue compiled of them, and what each speaks of."""
