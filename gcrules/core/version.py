"""The version of this program; pyproject.toml names the same (a test compares them)."""

__all__ = ["__version__"]

__version__ = "0.1.0"
