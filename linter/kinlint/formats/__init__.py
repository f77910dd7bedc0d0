"""Front ends: each turns the text of one file format into a located graph."""
