"""Arrays as callers hand them over."""

from __future__ import annotations

from collections.abc import Iterator
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
        if not isinstance(values, (str, bytes)):
            return np.ma.filled(np.ma.asarray(values, dtype=float), np.nan)
    except (TypeError, ValueError):
        pass
    raise InputError(f"{what} is no array of real numbers, but of type {type(values).__name__}; give a list or an array")
