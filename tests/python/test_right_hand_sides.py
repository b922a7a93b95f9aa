"""What other solvers are given."""

import unittest

import numpy as np

from samples import cases, laplacian, network, nonlinear
from superstep import InputError, Scene, integrate

try:
    import scipy.integrate
    import scipy.sparse
except ImportError:
    scipy = None


def differences(scene: Scene, t: float, y: np.ndarray) -> np.ndarray:
    """The Jacobian by central differences, column by column."""
    out = np.empty((y.size, y.size))
    for k in range(y.size):
        h = 1e-4 * max(1.0, abs(y[k]))
        up, down = y.copy(), y.copy()
        up[k] += h
        down[k] -= h
        out[:, k] = (scene.rhs(t, up) - scene.rhs(t, down)) / (up[k] - down[k])
    return out


def dense(scene: Scene, t: float, y: np.ndarray) -> np.ndarray:
    data, indices, indptr = scene.jacobian_data(t, y)
    out = np.zeros((y.size, y.size))
    for column in range(y.size):
        part = slice(indptr[column], indptr[column + 1])
        out[indices[part], column] = data[part]
    return out


class RightHandSides(unittest.TestCase):
    def test_they_are_the_matrix(self):
        scene = network()
        y = np.random.default_rng(1).normal(size=40)
        expected = -laplacian(40) / np.linspace(1, 2, 40)[:, None]
        np.testing.assert_allclose(scene.rhs(0, y), expected @ y, atol=1e-12)
        np.testing.assert_allclose(dense(scene, 0, y), expected, atol=1e-13)

    def test_jacobians_are_differences(self):
        two_way = Scene.from_dict(
            {
                "t_end": 1.0,
                "packing": {
                    "generator": "grid",
                    "count": 27,
                    "spacing": 1.9e-3,
                    "sizes": {"distribution": "uniform", "min": 2e-3, "max": 2e-3},
                },
                "material": {"density": 7800.0},
                "contact": {"neck": "hertz"},
                "electric": {
                    "conductivity": {
                        "law": "sigmoid",
                        "value": 1e4,
                        "amplitude": 1.5,
                        "steepness": 0.05,
                        "reference": 330.0,
                    },
                    "specific_capacity": 2e4,
                    "fixed": [{"where": "top", "value": 4.0}, {"where": "bottom", "value": 0.0}],
                },
                "thermal": {
                    "conductivity": {"law": "linear", "value": 50.0, "coefficient": -1e-3, "reference": 300.0},
                    "specific_heat": 460.0,
                    "initial": 300.0,
                },
            }
        )
        random = np.random.default_rng(2)
        for scene in (network(), nonlinear(), two_way):
            y = scene.y0 + random.uniform(0, 30 if scene.y0.max() > 200 else 1, scene.y0.size)
            found, expected = dense(scene, 0.0, y), differences(scene, 0.0, y)
            # Central differences of smooth laws: some 1e-8 of the largest entry, and roundings of f over h.
            np.testing.assert_allclose(found, expected, atol=1e-6 * np.abs(expected).max())
            self.assertEqual(
                [f.name for f in scene.fields],
                ["temperature"] if scene is not two_way else ["potential", "temperature"],
            )

    def test_rows_ascend_and_the_diagonal_is_there(self):
        scene = network()
        _, indices, indptr = scene.jacobian_data(0, scene.y0)
        for column in range(40):
            rows = indices[indptr[column] : indptr[column + 1]]
            self.assertTrue(np.all(np.diff(rows) > 0))
            self.assertIn(column, rows)

    def test_inputs_of_time_are_taken_at_that_time(self):
        ramp = {"times": [0.0, 1.0, 1.0, 2.0], "values": [0.0, 1.0, 5.0, 5.0]}
        scene = Scene.from_edges([[0, 1]], 1.0, t_end=2.0, capacity=[1.0, 2.0], case={"network": {"source": ramp}})
        for t, power in ((0.0, 0.0), (0.25, 0.25), (1.5, 5.0)):
            np.testing.assert_allclose(scene.rhs(t, [0.0, 0.0]), [power, power / 2], atol=1e-15)

    def test_inputs_hold_beyond_the_end(self):
        sawtooth = {"times": [0.0, 0.4], "values": [0.0, 4.0], "period": 0.4}
        given = {"t_end": 1.0, "capacity": [1.0, 2.0, 1.0], "fixed": [np.nan, np.nan, 0.0]}
        edges = [[0, 1], [1, 2]]
        heated = Scene.from_edges(edges, 1.0, **given, case={"network": {"source": sawtooth}})
        for t in (1.0, 1.3, 50.0):
            np.testing.assert_allclose(heated.rhs(t, [0.0, 0.0]), [2.0, 1.0], atol=1e-12)
        held = {"fixed": [{"ids": [2], "value": sawtooth}]}
        driven = Scene.from_edges(edges, 1.0, t_end=1.0, capacity=1.0, case={"network": held})
        for t in (1.0, 1.3, 50.0):
            np.testing.assert_allclose(driven.values("", t, [0.0, 0.0]), [0.0, 0.0, 2.0], atol=1e-12)

    def test_wrong_states_are_refused(self):
        scene = network()
        for y in ([1.0], np.zeros((1, 40)), np.zeros(41)):
            for function in (scene.rhs, scene.jacobian_data):
                with self.assertRaises(InputError):
                    function(0.0, y)

    def test_imaginary_parts_are_not_left_out(self):
        scene = network()
        for call in (scene.rhs, scene.jacobian_data, lambda t, y: scene.values("", t, y)):
            for y in (scene.y0 + 1e-20j, [str(one) for one in scene.y0]):
                with self.assertRaisesRegex(InputError, "y is of type .*; it must hold real numbers"):
                    call(0.0, y)

    def test_a_run_leaves_them_as_they_were(self):
        scene = nonlinear()
        before = scene.rhs(0, scene.y0)
        integrate(scene, "rkc:rtol=1e-2")
        np.testing.assert_array_equal(scene.rhs(0, scene.y0), before)


@unittest.skipUnless(scipy, "SciPy is not installed")
class BesideSciPy(unittest.TestCase):
    def solved(self, scene: Scene, times) -> np.ndarray:
        solution = scipy.integrate.solve_ivp(
            scene.rhs, (0, times[-1]), scene.y0, method="BDF", jac=scene.jacobian, t_eval=times, rtol=1e-9, atol=1e-9
        )
        self.assertTrue(solution.success, solution.message)
        return solution.y.T

    def test_bdf_and_ours_agree_within_the_tolerance(self):
        for make in (network, nonlinear):
            scene = make()
            times = np.array([0.1, 0.5, 1.0]) * scene.t_end
            expected = self.solved(scene, times)
            for method in ("auto", "cvode", "rock", "esdirk"):
                result = integrate(scene, method, rtol=1e-6, output_times=times)
                error = np.sqrt(np.mean((result.states - expected) ** 2, axis=1)).max()
                self.assertLess(error, 2e-6 * result.spans[0], method)  # ours has 1e-6 of the span; SciPy's, far less

    def test_the_jacobian_is_sciPys(self):
        scene = network()
        matrix = scene.jacobian(0, scene.y0)
        self.assertTrue(scipy.sparse.issparse(matrix))
        np.testing.assert_array_equal(matrix.toarray(), dense(scene, 0, scene.y0))
        self.assertTrue(matrix.has_sorted_indices)


if __name__ == "__main__":
    unittest.main()
