"""The version of this program, from which packages, reports and citations take it; a release's tag names the same."""

__all__ = ["__version__"]

__version__ = "0.1.0"
