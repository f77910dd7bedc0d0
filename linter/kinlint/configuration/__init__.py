"""What a run was told: settings, the files that hold them, and which rules they choose."""
