"""Mutates robots and models, and looks for what kinlint does not answer."""
