"""From results of an engine to findings: what they say, where, and which are told as one."""
