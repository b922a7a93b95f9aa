"""What Python adds to a run: wall time of `integrate` on a tiny scene, less what the library itself measured.

    PYTHONPATH=build/release/python python3 lib/python/measure/overhead.py
"""

import statistics
import time

import numpy as np

import superstep


def main(rounds: int = 2000) -> None:
    scene = superstep.Scene.from_edges([[0, 1]], 1.0, t_end=1.0, initial=np.array([0.0, 1.0]))
    for method, callback in (("rkc:rtol=1e-3", None), ("cvode:rtol=1e-3", None), ("rkc:rtol=1e-3", lambda t, y: None)):
        taken, own = [], []
        for _ in range(rounds):
            began = time.perf_counter()
            result = superstep.integrate(scene, method, on_output=callback)
            taken.append(time.perf_counter() - began)
            own.append(result.statistics["wall_stepping_s"])
        rest = [1e3 * (whole - part) for whole, part in zip(taken, own)]
        words = f"{method}{' with a callback' if callback else ''}"
        print(
            f"{words:32} whole {1e3 * statistics.median(taken):.3f} ms, stepping {1e3 * statistics.median(own):.3f} ms,"
            f" beside it {statistics.median(rest):.3f} ms (smallest {min(rest):.3f})"
        )


if __name__ == "__main__":
    main()
