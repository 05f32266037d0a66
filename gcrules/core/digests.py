"""How digests are shown to people."""

__all__ = ["beginning"]

_SHOWN = 16


def beginning(digest: str) -> str:
    """The figures by which people tell digests apart, the same everywhere."""
    return digest[:_SHOWN]
