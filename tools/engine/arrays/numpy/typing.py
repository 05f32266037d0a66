"""What annotations name."""

from .ndarray import ndarray

__all__ = ["ArrayLike", "NDArray"]

NDArray = ndarray
ArrayLike = object
