"""Which findings are silenced, by whom, and which suppressions are at fault."""
