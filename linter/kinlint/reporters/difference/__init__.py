"""Reports of `kinlint diff`."""
