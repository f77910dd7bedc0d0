"""Shell completion: what may stand where, and scripts that tell shells so."""
