"""XML formats: URDF, SRDF and SDF, read with exact places into the graph of their format."""
