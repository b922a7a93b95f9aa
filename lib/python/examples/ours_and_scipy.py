"""Our methods and SciPy's on the same right-hand side: CPU time and error of each.

    python3 ours_and_scipy.py
"""

import sys
import time

import numpy as np

import superstep

try:
    from scipy.integrate import solve_ivp
except ImportError:
    print("SciPy is not installed")
    sys.exit(77)

TOLERANCE = 1e-5  # of the span: 10 K


def main() -> None:
    n = 12
    centres = 1.9e-3 * np.stack(np.meshgrid(*[np.arange(n)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)  # m
    scene = superstep.Scene.from_spheres(
        centres,
        np.full(n**3, 1e-3),
        conductivity=50.0,
        density=7800.0,
        specific_heat=460.0,
        t_end=20.0,
        output_times=[0.2, 2.0, 20.0],
        initial=300.0,
        fixed=[{"where": "top", "value": 310.0}, {"where": "bottom", "value": 300.0}],
    )
    print(scene)
    times = scene.output_times
    reference = superstep.integrate(scene, "exponential", rtol=1e-12).states
    span = 10.0

    def report(name: str, states: np.ndarray, seconds: float) -> float:
        error = np.sqrt(np.mean((states - reference) ** 2, axis=1)).max() / span
        print(f"{name:24} {seconds:9.4f} s   rms error {error:.1e} of the span")
        return error

    for method in ("auto", "exponential", "rkc", "rock", "cvode", "esdirk"):
        result = superstep.integrate(scene, method, rtol=TOLERANCE)
        statistics = result.statistics
        error = report(method, result.states, statistics["cpu_prepare_s"] + statistics["cpu_stepping_s"])
        assert error < 2 * TOLERANCE, "rtol is what is delivered"
    for method in ("BDF", "Radau", "LSODA"):
        # SciPy's tolerances are those of one step and refer to values: what they deliver is another number.
        extra = {} if method == "LSODA" else {"jac": scene.jacobian}
        began = time.process_time()
        solution = solve_ivp(
            scene.rhs,
            (0, times[-1]),
            scene.y0,
            method=method,
            t_eval=times,
            rtol=1e-9,
            atol=0.1 * TOLERANCE * span,
            **extra,
        )
        error = report(f"SciPy's {method}", solution.y.T, time.process_time() - began)
        assert error < 10 * TOLERANCE, "both have solved the same equations"


if __name__ == "__main__":
    main()
