"""Consumers of robot descriptions: what each makes of features, as `shapes/targets` says."""
