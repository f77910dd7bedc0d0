"""Quick fixes: what a rule repairs in the graph, written into the text and proven by reading it."""
