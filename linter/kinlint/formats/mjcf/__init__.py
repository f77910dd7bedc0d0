"""Reads MJCF: what its files say, what they include, and what MuJoCo's compiler makes of it."""
