"""The language server: what editors are told of robots while they are written."""
