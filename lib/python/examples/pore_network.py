"""Diffusion through a pore network, out of the arrays that OpenPNM has of one.

    python3 pore_network.py

`conns` is `throat.conns`, `coords` is `pore.coords`; a network of OpenPNM's own takes the place of `make_network`.
"""

import sys

import numpy as np

import superstep

try:
    import scipy.sparse
    import scipy.sparse.linalg
except ImportError:
    print("SciPy is not installed")
    sys.exit(77)

DIFFUSIVITY = 2e-9  # m2/s, of a salt in water
SPACING = 1e-4  # m between pores


def make_network(n: int, seed: int = 1):
    """n x n x n pores, of which a third of the throats is closed: coords (pores, 3) in m, conns (throats, 2)."""
    grid = np.arange(n**3).reshape(n, n, n)
    coords = SPACING * np.stack(np.meshgrid(*[np.arange(n)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    pairs = [
        np.stack((np.moveaxis(grid, axis, 0)[:-1].ravel(), np.moveaxis(grid, axis, 0)[1:].ravel()), axis=1)
        for axis in range(3)
    ]
    conns = np.concatenate(pairs)
    return coords, conns[np.random.default_rng(seed).random(len(conns)) > 0.33]


def main():
    coords, conns = make_network(16)
    random = np.random.default_rng(2)
    volume = np.pi / 6 * (SPACING * random.uniform(0.4, 0.7, len(coords))) ** 3  # m3
    radius = SPACING * random.lognormal(np.log(0.1), 0.3, len(conns))  # m, of throats
    conductance = DIFFUSIVITY * np.pi * radius**2 / SPACING  # m3/s

    # A concentration of 1 mol/m3 at the inlet and of 0 at the outlet: K is m3/s, C is m3.
    height = coords[:, 2]
    fixed = np.full(len(coords), np.nan)
    fixed[height == 0] = 1.0
    fixed[height == height.max()] = 0.0
    hours = 3600.0
    scene = superstep.Scene.from_edges(
        conns,
        conductance,
        capacity=volume,
        fixed=fixed,
        t_end=4 * hours,
        output_times=np.array([0.04, 0.2, 1, 4]) * hours,
    )
    print(scene, *scene.warnings, sep="\n")

    result = superstep.integrate(
        scene, "auto", rtol=1e-4, on_output=lambda t, y: print(f"{t / hours:6.2f} h: mean {y.mean():.4f} mol/m3")
    )
    print(f"{result.choice}; {result.statistics['sweeps']} sweeps, {result.statistics['cpu_stepping_s']:.3f} s of CPU")

    # What flows out at the end, and what SciPy's direct solver says of the steady state.
    concentration = result.temperature[-1]
    out = flow_into(np.flatnonzero(fixed == 0.0), conns, conductance, concentration)
    steady = steady_state(conns, conductance, fixed)
    expected = flow_into(np.flatnonzero(fixed == 0.0), conns, conductance, steady)
    area, length = (SPACING * 16) ** 2, height.max()
    print(
        f"effective diffusivity {out * length / area:.4g} m2/s, "
        f"{out * length / area / DIFFUSIVITY:.4f} of that of the water"
    )
    print(f"outflow over that of the steady state - 1: {out / expected - 1:.1e}")
    assert abs(out / expected - 1) < 1e-2, "four hours are enough, and the tolerance is 1e-4 of the span"


def flow_into(nodes, conns, conductance, value):
    """Sum over the throats that lead to these nodes from others, mol/s."""
    inside = np.isin(conns, nodes)
    towards = np.where(inside[:, 1], 1.0, -1.0) * (inside[:, 0] != inside[:, 1])
    return np.sum(towards * conductance * (value[conns[:, 0]] - value[conns[:, 1]]))


def steady_state(conns, conductance, fixed):
    n = len(fixed)
    both = np.concatenate((conns, conns[:, ::-1]))
    matrix = scipy.sparse.csr_matrix((np.tile(conductance, 2), both.T), shape=(n, n))
    joined = scipy.sparse.csgraph.connected_components(matrix)[1]
    held = ~np.isnan(fixed)
    free = ~held & np.isin(joined, joined[held])  # islands have no steady state of their own
    laplacian = scipy.sparse.diags(np.asarray(matrix.sum(axis=1)).ravel()) - matrix
    value = np.where(held, fixed, 0.0)
    right = -(laplacian @ value)[free]
    value[free] = scipy.sparse.linalg.spsolve(laplacian[free][:, free].tocsc(), right)
    return value


if __name__ == "__main__":
    import scipy.sparse.csgraph

    main()
