"""From a LIGGGHTS dump to the effective conductivity of the packing, and to the fastest method for it.

    python3 dump_to_conductivity.py [packing.dump]

Without a file it writes one: a cube of spheres as `dump custom id type x y z radius` has them.
"""

import pathlib
import sys
import tempfile

import numpy as np

import superstep


def write_dump(path: pathlib.Path, n: int = 12, radius: float = 1e-3) -> None:
    """n x n x n spheres, pushed about by some hundredths of a radius, so that neighbours overlap unequally."""
    random = np.random.default_rng(1)
    centres = 1.95 * radius * np.stack(np.meshgrid(*[np.arange(n)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    centres += 0.02 * radius * random.uniform(-1, 1, centres.shape)
    low, high = -radius, centres.max() + radius
    rows = "\n".join(f"{k + 1} 1 {x:.9g} {y:.9g} {z:.9g} {radius:.9g}" for k, (x, y, z) in enumerate(centres))
    bounds = f"{low:.9g} {high:.9g}\n" * 3
    path.write_text(
        f"ITEM: TIMESTEP\n1000\nITEM: NUMBER OF ATOMS\n{len(centres)}\nITEM: BOX BOUNDS ff ff ff\n{bounds}"
        f"ITEM: ATOMS id type x y z radius\n{rows}\n",
        encoding="utf-8",
    )


def main() -> None:
    with tempfile.TemporaryDirectory() as folder:
        if len(sys.argv) > 1:
            dump = pathlib.Path(sys.argv[1]).resolve()
        else:
            dump = pathlib.Path(folder) / "packing.dump"
            write_dump(dump)
        scene = superstep.Scene.from_dict(
            {
                "t_end": 60.0,  # s
                "output_times": [1.0, 10.0, 60.0],
                "packing": {"file": dump, "periodic": "none"},
                "material": {"density": 7800.0},  # kg/m3
                "contact": {"neck": "geometric"},
                "thermal": {
                    "conductivity": 50.0,  # W/(m K)
                    "specific_heat": 460.0,  # J/(kg K)
                    "initial": 300.0,  # K
                    "fixed": [{"where": "top", "value": 310.0}, {"where": "bottom", "value": 300.0}],
                },
            },
            name=dump.stem,
        )
    print(scene)
    conductivity = scene.effective_conductivity()
    print(f"effective conductivity {conductivity:.4g} W/(m K), {conductivity / 50.0:.3f} of that of the solid")
    assert 0 < conductivity < 50.0

    columns = superstep.bench(
        scene, ["auto", "exponential:rtol=1e-3", "rkc:rtol=1e-3", "cvode:rtol=1e-3"], repetitions=1
    )
    print(f"{'method':28} {'status':12} {'CPU [s]':>9} {'rms error [K]':>14}")
    for integrator, params, status, cpu, error in zip(
        *(columns[key] for key in ("integrator", "params", "status", "cpu_stepping_s", "error_rms"))
    ):
        print(f"{integrator + ':' * bool(params) + params:28} {status:12} {cpu:9.4f} {error:14.2e}")
    good = [k for k, status in enumerate(columns["status"]) if status == "ok"]
    fastest = min(good, key=lambda k: columns["cpu_stepping_s"][k])
    print("fastest:", columns["integrator"][fastest], columns["params"][fastest])


if __name__ == "__main__":
    main()
