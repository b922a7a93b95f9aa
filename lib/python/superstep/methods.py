"""The methods that there are."""

from __future__ import annotations

from typing import NamedTuple

from . import _core


class Method(NamedTuple):
    """A line of ``superstep list``."""

    name: str
    summary: str
    keys: list[str]  #: what may stand behind the colon of a SPEC: ``name:key=value,key=value``


def methods() -> list[Method]:
    """Every method, in the order of ``superstep list``."""
    return [Method(name, summary, keys) for name, summary, keys in _core.methods()]
