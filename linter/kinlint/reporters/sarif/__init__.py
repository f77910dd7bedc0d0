"""SARIF 2.1.0 (OASIS), as GitHub code scanning and editors read it."""
