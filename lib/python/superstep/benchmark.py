"""Methods against a reference, timed."""

from __future__ import annotations

import warnings
from collections.abc import Mapping, Sequence
from typing import Any, Union

import numpy as np

from . import _core
from .scene import Case, Scene, as_scene


def bench(
    scene: Union[Case, Sequence[Case]],
    methods: Sequence[str] = (),
    *,
    reference: str = "",
    repetitions: int = 3,
    cache: bool = True,
    threads: int = 1,
    time_limit: float = 600.0,
) -> dict[str, Any]:
    """Measures methods on a scene, or on several: CPU time, speedup and error, one row a method.

    scene: a Scene, a dict or the path of a case file, or a list of these
    methods: SPECs; none = those of the case, else every family. The baseline of the case is added
    reference: SPEC; "" = as the scene needs it, "none" = errors are not measured
    repetitions: timed runs of each method, interleaved
    cache: keep references of case files for the next time
    threads: that may compute. time_limit: s of wall time of each run; 0 = none

    Returns the columns of results.csv by their names (reports/schema.md): lists of text and arrays of numbers, NaN
    where nothing was measured; ``pandas.DataFrame(superstep.bench(...))`` takes them. A method that fails is a row,
    with its status and reason. What the user should look at is a UserWarning. Scenes without output times of their
    own are judged at 2, 10 and 100 % of the run.
    Raises InputError for wrong SPECs and scenes.
    """
    if isinstance(scene, Sequence) and not isinstance(scene, str):
        cases: list[Case] = list(scene)
    else:
        cases = [scene]
    if not cases:
        raise _core.InputError("bench: there is no scene to measure")
    methods = [methods] if isinstance(methods, str) else list(methods)
    parts = [_measure(as_scene(case), methods, reference, repetitions, cache, threads, time_limit) for case in cases]
    return parts[0] if len(parts) == 1 else _joined(parts)


def _measure(scene: Scene, methods: list[str], *settings: Any) -> dict[str, Any]:
    columns, said = _core.bench(scene._core, methods, *settings)
    for text in said:
        warnings.warn(text if text.startswith(scene.name) else f"{scene.name}: {text}", UserWarning, stacklevel=4)
    return columns


def _joined(parts: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """One table of several; columns that a part lacks are NaN there."""
    names = max(parts, key=len)
    return {name: _column([part.get(name, np.full(_rows(part), np.nan)) for part in parts]) for name in names}


def _rows(part: Mapping[str, Any]) -> int:
    return len(next(iter(part.values())))


def _column(pieces: Sequence[Any]) -> Any:
    if isinstance(pieces[0], list):
        return [text for piece in pieces for text in piece]
    return np.concatenate(pieces)
