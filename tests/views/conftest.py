"""What the tests of this room share."""

from __future__ import annotations

import pytest

from gcrules.rules.catalog.file import load
from gcrules.views.pages.catalog_pages import bibliography, catalog_pages


@pytest.fixture(scope="session")
def pages() -> dict[str, str]:
    """What the shipped catalog gives, computed once."""
    return catalog_pages(load(), bibliography())
