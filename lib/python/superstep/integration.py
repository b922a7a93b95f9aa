"""One method over one scene."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from .arrays import numbers, refuse_masks
from .scene import Case, Scene, as_scene

OnOutput = Callable[[float, NDArray[np.float64]], Any]


@dataclasses.dataclass(frozen=True)
class Result:
    """What a run found."""

    scene: Scene = dataclasses.field(repr=False)
    method: str  #: SPEC
    times: NDArray[np.float64] = dataclasses.field(repr=False)  #: (k,) s, the output times that were reached
    #: (k, m) unknowns at these times, K or V: the memory that the run wrote to, not a copy
    states: NDArray[np.float64] = dataclasses.field(repr=False)
    status: str  #: "ok", or how it ended
    reason: str  #: why, unless it is ok
    choice: str  #: what the method chose by itself and why; "" = it had nothing to choose
    t_reached: float  #: s
    spans: list[float]  #: what rtol refers to, one a field [K or V]; empty = the method takes none
    #: sweeps over the network, steps, rejected, jacobians, factorizations, solves, potential_solves, max_stages,
    #: cpu_prepare_s, cpu_stepping_s, wall_stepping_s, cpu_pilot_s; error_bound (over the span), rounding_bound (the part
    #: of it that is rounding) and settled_at (s), or None
    statistics: dict[str, Any]

    def values(self, field: str = "") -> NDArray[np.float64]:
        """(k, n) values of a field on all nodes, fixed ones included, K or V. field: "" = the first."""
        rows = [self.scene.values(field, t, y) for t, y in zip(self.times, self.states)]
        return np.array(rows).reshape(len(rows), len(self.scene.ids))

    @property
    def temperature(self) -> NDArray[np.float64]:
        """(k, n) K"""
        return self.values("temperature")

    @property
    def potential(self) -> NDArray[np.float64]:
        """(k, n) V"""
        return self.values("potential")


def integrate(
    scene: Case,
    method: str = "auto",
    *,
    rtol: Optional[float] = None,
    t_end: Optional[float] = None,
    output_times: Optional[ArrayLike] = None,
    on_output: Optional[OnOutput] = None,
    threads: int = 1,
    time_limit: float = 0.0,
) -> Result:
    """Runs a method from t = 0 over the output times.

    scene: a Scene, a dict or the path of a case file
    method: SPEC, ``name`` or ``name:key=value,key=value``, as ``superstep list`` has them
    rtol: rms error at output times over the span of the field that the run may have; None = the method's own
    output_times: s, ascending, > 0; t_end: s. Without both the scene's; t_end alone ends those of the scene
    on_output: called with t and the unknowns (m,), which must not be written to, as soon as t is reached; what it
        raises ends the run and is raised here
    threads: that may compute; the result does not depend on them
    time_limit: s of wall time; 0 = none

    Other Python threads go on meanwhile, and Ctrl-C raises KeyboardInterrupt at the next step end.
    Raises InputError for a wrong SPEC or wrong times, before anything is computed, and MethodError for a method that
    refuses the scene, fails, or runs out of time: its ``status`` and ``reason`` say how, its ``result`` holds what was
    reached before.
    """
    scene = as_scene(scene)
    if not isinstance(method, str):
        raise TypeError(f"method must be a SPEC, a string; it is {method!r}")
    if on_output is not None and not callable(on_output):
        raise TypeError(f"on_output must be a function of t and y; it is {on_output!r}")
    rtol = None if rtol is None else float(rtol)
    if not time_limit >= 0:
        raise _core.InputError(f"time_limit is {time_limit!r}; it must be seconds, or 0 for none")
    out = _core.run(scene._core, method, rtol, _times(scene, t_end, output_times), on_output, threads, time_limit)
    result = Result(scene=scene, **out)
    if result.status != "ok":
        error = _core.MethodError(f"{result.method}: {result.status}: {result.reason}")
        error.status, error.reason, error.result = result.status, result.reason, result
        raise error
    return result


def _times(scene: Scene, t_end: Optional[float], output_times: Optional[ArrayLike]) -> list[float]:
    if output_times is None:
        times = scene.output_times
        if t_end is not None:
            times = times[times < t_end]
    else:
        refuse_masks(output_times, "output_times")
        times = numbers(output_times, "output_times")
        if times.ndim != 1:
            raise _core.InputError(f"output_times has the shape {times.shape}; it must be (k,)")
        if t_end is not None and times.size and times[-1] > t_end:
            raise _core.InputError(f"output_times ends at {times[-1]}; none may be after t_end = {t_end} s")
    if t_end is not None and not (times.size and times[-1] == t_end):
        times = np.append(times, t_end)
    return [float(t) for t in times]
