"""Arrays as callers hand them over."""

from __future__ import annotations

from collections.abc import Iterator
from numbers import Real
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._core import InputError


def refuse_masks(value: Any, what: str, way_out: str = "fill them, or leave them out") -> None:
    """What lies under a mask is no value. Looks into lists and tuples, too.

    what: the name, to begin an error message with.
    Raises InputError.
    """
    if _is_masked(value):
        raise InputError(f"{what} has masked values; {way_out}")


def is_number(value: Any) -> bool:
    """One real number, of Python or of NumPy."""
    return isinstance(value, Real) or (isinstance(value, np.ndarray) and value.ndim == 0 and _is_real(value))


def as_array(value: Any, what: str) -> NDArray[Any]:
    """The array that it is, of whatever numbers. Raises InputError for rows that differ in length."""
    try:
        return np.asarray(value)
    except ValueError:
        raise InputError(f"{what} has rows that differ in length; give an array") from None


def real(value: Any, what: str) -> NDArray[Any]:
    """The array of real numbers that it is: neither masks nor imaginary parts are left out in silence.

    Raises InputError.
    """
    refuse_masks(value, what)
    array = as_array(value, what)
    if not _is_real(array):
        raise InputError(f"{what} is of type {array.dtype}; it must hold real numbers")
    return array


def _is_real(array: NDArray[Any]) -> bool:
    return array.dtype.kind in "biuf"


def _is_masked(value: Any) -> bool:
    if isinstance(value, np.ma.MaskedArray):
        return bool(np.ma.is_masked(value))
    return isinstance(value, (list, tuple)) and any(
        _is_masked(one) for one in value if isinstance(one, (np.ma.MaskedArray, list, tuple))
    )


def numbers(values: Any, what: str) -> NDArray[np.float64]:
    """Numbers one after the other, in whatever they come, masked ones as NaN.

    Raises InputError for what is none of that: a set has no order, a dict has keys.
    """
    if isinstance(values, Iterator):  # which can be gone through once only
        values = list(values)
    try:
        if not isinstance(values, (str, bytes)) and not np.iscomplexobj(values):
            return np.ma.filled(np.ma.asarray(values, dtype=float), np.nan)
    except (TypeError, ValueError):
        pass
    raise InputError(f"{what} is no array of real numbers, but of type {type(values).__name__}; give a list or an array")
