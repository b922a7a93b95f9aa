"""A dict as the TOML document that the one reader of cases reads."""

from __future__ import annotations

import json
import numbers
import os
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ._core import InputError
from .arrays import refuse_masks


def text_of(case: Mapping[str, Any], name: str) -> str:
    """The document, one key of the root a line.

    name: of the case, to begin an error message with.
    Raises InputError for keys that are no strings, and for values that TOML has no word for.
    """
    return "".join(f"{_key(key, name, '')} = {_value(value, name, str(key))}\n" for key, value in case.items())


def _string(text: str) -> str:
    try:
        text.encode()
    except UnicodeEncodeError:
        raise InputError(f"the text {text!r} holds half of a character, and cannot be written as UTF-8") from None
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def _key(key: Any, name: str, within: str) -> str:
    if not isinstance(key, str):
        raise InputError(f"{name}: a key{f' of {within}' if within else ''} is {key!r}; keys must be strings")
    return _string(key)


def _value(value: Any, name: str, place: str) -> str:
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, numbers.Integral):
        if not -(2**63) <= int(value) < 2**63:
            raise InputError(f"{name}: key '{place}' is {int(value)}; whole numbers must fit into 64 bits")
        return str(int(value))
    if isinstance(value, numbers.Real):
        return repr(float(value))
    if isinstance(value, (str, os.PathLike)):
        return _string(os.fspath(value))
    if isinstance(value, Mapping):
        within = ", ".join(f"{_key(k, name, place)} = {_value(v, name, f'{place}.{k}')}" for k, v in value.items())
        return f"{{{within}}}"
    if isinstance(value, np.ndarray):
        refuse_masks(value, f"{name}: {place}")
        return _value(value.tolist(), name, place)
    if isinstance(value, Sequence) and not isinstance(value, (bytes, bytearray)):
        return f"[{', '.join(_value(one, name, f'{place}[{k}]') for k, one in enumerate(value))}]"
    if value is None:
        raise InputError(f"{name}: key '{place}' is None; give it a value, or leave it out where it may be left out")
    raise InputError(
        f"{name}: key '{place}' is of type {type(value).__name__}; "
        "a case holds numbers, strings, booleans, lists and dicts"
    )
