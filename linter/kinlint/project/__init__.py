"""The files of a project: what governs them, which are models, and what they say."""
