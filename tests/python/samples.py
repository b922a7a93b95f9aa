"""Scenes of the tests, and where the project's cases are."""

import os
import pathlib

import numpy as np

import superstep

cases = pathlib.Path(os.environ.get("SUPERSTEP_SOURCE_DIR", pathlib.Path(__file__).parents[2])) / "cases"
NaN = float("nan")


def laplacian(n: int, seed: int = 1, nodes_per_edge: float = 0.4) -> np.ndarray:
    """Dense Laplacian of a connected random network, W/K."""
    random = np.random.default_rng(seed)
    matrix = np.zeros((n, n))
    for i in range(n):
        for j in {(i + 1) % n, *random.integers(0, n, int(1 / nodes_per_edge))}:
            if i != j:
                conductance = random.uniform(0.2, 2)
                matrix[[i, j], [j, i]] -= conductance
    return matrix - np.diag(matrix.sum(axis=1))


def network(n: int = 40, **more) -> superstep.Scene:
    """A closed network that starts with one node hot."""
    initial = np.zeros(n)
    initial[3] = 100.0
    given = {"t_end": 2.0, "capacity": np.linspace(1, 2, n), "initial": initial, **more}
    return superstep.Scene.from_matrix(laplacian(n), **given)


def row_of_spheres(n: int = 12) -> tuple[np.ndarray, np.ndarray]:
    """Centres and radii in m: spheres that overlap by a twentieth of a radius, upright."""
    centres = np.zeros((n, 3))
    centres[:, 2] = 1.95e-3 * np.arange(n)
    return centres, np.full(n, 1e-3)


def spheres(n: int = 12, **more) -> superstep.Scene:
    """Heat up a row of spheres whose ends are held."""
    given = {
        "conductivity": 50.0,
        "density": 7800.0,
        "specific_heat": 460.0,
        "t_end": 20.0,
        "initial": 300.0,
        "fixed": [{"where": {"ids": [0]}, "value": 300.0}, {"where": {"ids": [n - 1]}, "value": 400.0}],
        **more,
    }
    return superstep.Scene.from_spheres(*row_of_spheres(n), **given)


def nonlinear() -> superstep.Scene:
    """Conductivity follows temperature, and the surface radiates."""
    radiation = [{"where": "all", "emissivity": 0.8, "ambient": 900.0}]
    law = {"law": "linear", "value": 50.0, "coefficient": -1e-3, "reference": 300.0}
    return spheres(case={"thermal": {"conductivity": law, "radiation": radiation}})
