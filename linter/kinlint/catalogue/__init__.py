"""The rules: their files, the catalogue compiled of them, and the formats that they apply to."""
