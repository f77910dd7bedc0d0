"""Loads documents into a store, draws conclusions, runs rules and explains what they found."""
