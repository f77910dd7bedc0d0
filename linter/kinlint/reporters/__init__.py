"""What a run found, as text for people and for machines."""
