"""COLLADA: robots with kinematics, physics and looks, and meshes (ISO/PAS 17506)."""
