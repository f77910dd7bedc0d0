"""A real triple store on the loopback interface."""

import pytest
from support.triple_store import program, served

from kinlint.endpoint.connection import Endpoint


@pytest.fixture(scope="session")
def oxigraph():
    """The address of Oxigraph's server."""
    server = program()
    if server is None:
        pytest.skip("Oxigraph's server is not installed; the extra 'test' brings it")
    with served(server) as url:
        yield url


@pytest.fixture
def store(oxigraph):
    """An empty store."""
    endpoint = Endpoint.from_user(oxigraph, None, {}, 120)
    endpoint.update("DROP ALL")
    return endpoint
