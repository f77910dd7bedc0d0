"""Reports of earlier runs, kept as long as nothing changes that they depend on."""
