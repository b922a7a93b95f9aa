"""Every way to a scene, and what is refused on the way."""

import os
import tempfile
import unittest

import numpy as np

import superstep
from samples import NaN, cases, laplacian, network, row_of_spheres, spheres
from superstep import InputError, Scene


class WaysToAScene(unittest.TestCase):
    def test_a_case_file_and_a_dict_of_it_are_the_same_scene(self):
        of_file = Scene.from_file(cases / "lattice.toml")
        packing = {"file": "packings/lattice.csv", "length_unit": "mm"}
        ends = [
            {"where": {"layer": {"side": side, "thickness": 0.9}}, "value": value}
            for side, value in (("top", 400.0), ("bottom", 300))
        ]
        of_dict = Scene.from_dict(
            {
                "t_end": 20,
                "output_times": (0.5, 5.0, 20.0),
                "packing": packing,
                "material": {"density": np.float32(7800)},
                "contact": {"neck": "hertz"},
                "thermal": {"conductivity": np.int64(50), "specific_heat": 460.0, "initial": 300.0, "fixed": ends},
            },
            folder=cases,
        )
        np.testing.assert_array_equal(of_file.y0, of_dict.y0)
        np.testing.assert_array_equal(of_file.edges()[2], of_dict.edges()[2])
        a, b = (superstep.integrate(scene, "rkc:rtol=1e-3") for scene in (of_file, of_dict))
        np.testing.assert_array_equal(a.states, b.states)

    def test_spheres_in_memory_are_those_of_a_file(self):
        centres, radii = row_of_spheres()
        with tempfile.TemporaryDirectory() as folder:
            rows = [
                f"{k},{x!r},{y!r},{z!r},{r!r}" for k, ((x, y, z), r) in enumerate(zip(centres.tolist(), radii.tolist()))
            ]
            with open(os.path.join(folder, "row.csv"), "w", encoding="utf-8") as file:
                file.write("id,x,y,z,radius\n" + "\n".join(rows) + "\n")
            tables = {
                "t_end": 1.0,
                "material": {"density": 7800.0},
                "contact": {"neck": "hertz"},
                "thermal": {"conductivity": 50.0, "specific_heat": 460.0, "initial": 300.0},
            }
            of_file = Scene.from_dict({**tables, "packing": {"file": "row.csv"}}, folder=folder)
            of_arrays = Scene.from_dict({**tables, "packing": {"centres": centres, "radii": radii}})
        for one, other in zip(of_file.edges(), of_arrays.edges()):
            np.testing.assert_array_equal(one, other)
        np.testing.assert_array_equal(of_file.capacities(), of_arrays.capacities())
        self.assertEqual(len(of_arrays.edges()[0]), 11)

    def test_values_at_the_start_may_be_an_array(self):
        start = np.linspace(300, 400, 12)
        scene = spheres(initial=start, fixed=[])
        np.testing.assert_allclose(scene.y0, start, rtol=1e-14)
        np.testing.assert_array_equal(scene.unknown_node, np.arange(12))

    def test_materials_may_be_named_one_by_one(self):
        centres, radii = row_of_spheres(4)
        materials = [
            {"name": name, "density": 1000.0, "thermal": {"conductivity": k, "specific_heat": 1.0}}
            for name, k in (("good", 10.0), ("bad", 1.0))
        ]
        case = {
            "t_end": 1.0,
            "packing": {"centres": centres, "radii": radii, "materials": ["good", "good", "bad", "bad"]},
            "materials": materials,
            "contact": {"neck": "geometric"},
            "thermal": {},
        }
        conductance = Scene.from_dict(case).edges()[2]
        self.assertAlmostEqual(conductance[0] / conductance[2], 10.0, places=10)

    def test_a_matrix_may_come_in_any_form(self):
        dense = laplacian(30)
        reference = Scene.from_matrix(dense, t_end=1.0).edges()
        row, column = np.nonzero(dense)
        indptr = np.concatenate(([0], np.cumsum(np.bincount(row, minlength=30))))
        forms = {"sorted rows": (dense[row, column], column, indptr)}
        backwards = [
            np.concatenate([part[a:b][::-1] for a, b in zip(indptr, indptr[1:])])
            for part in (dense[row, column], column)
        ]
        forms["unsorted rows"] = (*backwards, indptr)
        forms["conductances"] = np.where(np.eye(30), 0, -dense)
        try:
            import scipy.sparse

            forms["SciPy's columns"] = scipy.sparse.csc_matrix(dense)
            forms["SciPy's coordinates"] = scipy.sparse.coo_matrix(dense)
        except ImportError:
            pass
        for form, matrix in forms.items():
            with self.subTest(form):
                for one, other in zip(reference, Scene.from_matrix(matrix, t_end=1.0).edges()):
                    np.testing.assert_allclose(one, other, rtol=1e-15)

    def test_edges_are_the_network_of_their_laplacian(self):
        dense = laplacian(30)
        row, column = np.nonzero(np.triu(dense, 1))
        scene = Scene.from_edges(
            np.stack((row, column), axis=1), -dense[row, column], t_end=1.0, capacity=np.full(30, 2.0)
        )
        y = np.random.default_rng(0).normal(size=30)
        np.testing.assert_allclose(scene.rhs(0, y), -dense @ y / 2, atol=1e-13)  # sums of some ten terms near 1

    def test_one_number_may_be_one_of_numpy(self):
        edges, fixed = [[0, 1], [1, 2]], [1.0, np.nan, 0.0]
        plain = Scene.from_edges(edges, 2.0, capacity=3.0, fixed=fixed, t_end=1.0)
        for kind in (np.float32, np.int64, np.array):  # the last: without dimensions
            scene = Scene.from_edges(edges, kind(2), capacity=kind(3), fixed=fixed, t_end=1.0)
            np.testing.assert_array_equal(scene.rhs(0, scene.y0), plain.rhs(0, plain.y0))

    def test_chosen_nodes_have_sources_and_values_that_follow_time(self):
        step = {"times": [0.0, 1.0, 1.0], "values": [4.0, 4.0, 2.0]}
        given = {
            "t_end": 3.0,
            "source": [{"ids": [2], "value": step}, {"ids": [1, 2], "value": 0.5}],
            "fixed": [{"ids": [0], "value": {"times": [0.0, 2.0], "values": [1.0, 5.0]}}],
        }
        chain = np.array([[1.0, -1, 0], [-1, 2, -1], [0, -1, 1]])
        for scene in (Scene.from_edges([[0, 1], [1, 2]], 1.0, nodes=3, **given), Scene.from_matrix(chain, **given)):
            y = np.array([7.0, 9.0])
            np.testing.assert_allclose(scene.rhs(0.5, y), [2 - 7 + 9 - 7 + 0.5, 7 - 9 + 4.5])
            np.testing.assert_allclose(scene.rhs(1.5, y), [4 - 7 + 9 - 7 + 0.5, 7 - 9 + 2.5])
        with self.assertRaisesRegex(InputError, "ids run from 0 to 2"):
            Scene.from_edges([[0, 1], [1, 2]], 1.0, **{**given, "source": [{"ids": [3], "value": 1.0}]})

    def test_fixed_nodes_sources_and_surroundings(self):
        dense = laplacian(30)
        ground = np.linspace(0, 1, 30)
        fixed = np.full(30, NaN)
        fixed[[0, 7]] = 5.0, 6.0
        source = np.arange(30.0)
        scene = Scene.from_matrix(dense + np.diag(ground), t_end=1.0, fixed=fixed, source=source, ambient=3.0)
        free = np.isnan(fixed)
        np.testing.assert_array_equal(scene.unknown_node, np.flatnonzero(free))
        values = np.random.default_rng(0).normal(size=30)
        values[~free] = fixed[~free]
        expected = source - dense @ values + ground * (3.0 - values)
        np.testing.assert_allclose(scene.rhs(0, values[free]), expected[free], atol=1e-12)
        np.testing.assert_array_equal(scene.values("temperature", 0, values[free])[~free], fixed[~free])

    def test_what_a_scene_says_of_itself(self):
        scene = network(name="mine")
        self.assertEqual(scene.name, "mine")
        self.assertEqual(scene.fields, [("temperature", "K", False)])
        self.assertEqual(scene.t_end, 2.0)
        self.assertIn("mine", repr(scene))
        np.testing.assert_array_equal(scene.ids, np.arange(40))
        self.assertIsNone(scene.centres)
        self.assertIsNone(scene.radii)
        centres, radii = row_of_spheres()
        np.testing.assert_array_equal(spheres().centres, centres)
        np.testing.assert_array_equal(spheres().radii, radii)
        np.testing.assert_allclose(scene.capacities(), np.linspace(1, 2, 40))

    def test_effective_conductivity_of_a_row(self):
        scene = spheres(neck="geometric")
        conductance, length = scene.edges()[2][0] / 11, 11 * 1.95e-3  # eleven contacts in a row
        area = np.pi / 4 * (2e-3) ** 2
        value = scene.effective_conductivity()
        self.assertGreater(value, 0.3 * conductance * length / area)  # whatever area the cross-section is given
        self.assertLess(value, 3 * conductance * length / area)
        with self.assertRaisesRegex(InputError, "no effective conductivity"):
            network().effective_conductivity()


class WhatIsRefused(unittest.TestCase):
    def refused(self, words, make, *args, **named):
        with self.assertRaisesRegex(InputError, words) as caught:
            make(*args, **named)
        self.assertIsInstance(caught.exception, ValueError)
        self.assertNotIn("\n", str(caught.exception))

    def test_wrong_shapes(self):
        centres, radii = row_of_spheres()
        tables = {"conductivity": 1.0, "density": 1.0, "specific_heat": 1.0, "t_end": 1.0}
        self.refused(
            r"centres has the shape \(12, 2\); it must be \(n, 3\)", Scene.from_spheres, centres[:, :2], radii, **tables
        )
        self.refused("centres has 33 values, and must have 36", Scene.from_spheres, centres[1:], radii, **tables)
        self.refused(r"radii has the shape \(12, 1\)", Scene.from_spheres, centres, radii[:, None], **tables)
        self.refused("at least one particle", Scene.from_spheres, np.zeros((0, 3)), np.zeros(0), **tables)
        self.refused("thermal.initial has 3 values", Scene.from_spheres, centres, radii, initial=[1, 2, 3], **tables)
        self.refused(r"shape \(3, 4\); a network's is square", Scene.from_matrix, np.ones((3, 4)), t_end=1.0)
        self.refused("capacity has 2 values, and must have 40", network, capacity=[1.0, 2.0])
        self.refused(r"edges has the shape \(4,\)", Scene.from_edges, [0, 1, 2, 3], 1.0, t_end=1.0)
        self.refused("conductance has 2 values, and must have 1", Scene.from_edges, [[0, 1]], [1.0, 2.0], t_end=1.0)
        self.refused("no array of integers", Scene.from_edges, [[0.0, 1.0]], 1.0, t_end=1.0)
        self.refused("no array of real numbers", Scene.from_spheres, centres.astype(str), radii, **tables)
        self.refused("no array of real numbers", Scene.from_spheres, centres + 1j, radii, **tables)

    def test_numbers_that_cannot_be_computed_with(self):
        centres, radii = row_of_spheres()
        tables = {"conductivity": 1.0, "density": 1.0, "specific_heat": 1.0, "t_end": 1.0}
        centres[4, 1] = NaN
        self.refused("value 13 of centres is nan", Scene.from_spheres, centres, radii, **tables)
        self.refused("value 2 of capacity is inf", network, capacity=[1.0, 1.0, np.inf] + [1.0] * 37)
        self.refused("capacity of node 0 is -1; it must be >= 0", network, capacity=[-1.0] + [1.0] * 39)
        self.refused("value 0 of fixed is inf", network, fixed=[np.inf] + [NaN] * 39)
        self.refused("key 't_end' is inf; it must be finite", network, t_end=np.inf)
        self.refused("conductance -1 of edge 0", Scene.from_edges, [[0, 1]], -1.0, t_end=1.0)

    def test_matrices_of_no_network(self):
        dense = laplacian(5)
        dense[1, 2] *= 2
        self.refused(
            r"entry \(1, 2\) is .*the entry across the diagonal is another", Scene.from_matrix, dense, t_end=1.0
        )
        self.refused(r"entry \(0, 1\) of the matrix is nan", Scene.from_matrix, np.where(np.eye(2), 1, NaN), t_end=1.0)
        self.refused("row 0 of the Laplacian sums to", Scene.from_matrix, [[1.0, -2.0], [-2.0, 3.0]], t_end=1.0)
        good = ([2.0, -2.0, -2.0, 2.0], [0, 1, 0, 1], [0, 2, 4])
        Scene.from_matrix(good, t_end=1.0)
        self.refused("indptr goes from 0 to 5", Scene.from_matrix, (*good[:2], [0, 2, 5]), t_end=1.0)
        self.refused("indptr falls from 3 to 2 in row 1", Scene.from_matrix, (*good[:2], [0, 3, 2, 4]), t_end=1.0)
        self.refused(
            "column 2; there are columns 0 to 1", Scene.from_matrix, (good[0], [0, 1, 0, 2], good[2]), t_end=1.0
        )
        self.refused("data has 3 values, and must have 4", Scene.from_matrix, (good[0][1:], *good[1:]), t_end=1.0)
        self.refused("indptr is empty", Scene.from_matrix, ([], [], []), t_end=1.0)
        self.refused("no nodes", Scene.from_matrix, ([], [], [0]), t_end=1.0)
        self.refused("capacity is empty", network, capacity=[])
        self.refused("source is empty", network, source=np.zeros(0))

    def test_rows_that_differ_in_length(self):
        self.refused("the matrix has rows that differ in length", Scene.from_matrix, [[1.0], [1.0, 2.0]], t_end=1.0)
        self.refused("edges has rows that differ in length", Scene.from_edges, [[0], [0, 1]], 1.0, t_end=1.0)
        self.refused("edges is no array of integers", Scene.from_edges, (pair for pair in [[0, 1]]), 1.0, t_end=1.0)

    def test_names_of_particles_and_columns(self):
        centres, radii = [[0.0, 0.0, 0.0], [0.0, 0.0, 1.9]], [1.0, 1.0]
        tables = {key: 1.0 for key in ("conductivity", "density", "specific_heat", "t_end")}
        for wrong in ("ab", None, [["a", "b"]]):  # a text as long as the packing names nobody
            case = {"packing": {"materials": wrong}}
            self.refused("materials has the shape", Scene.from_spheres, centres, radii, **tables, case=case)
        case = {"packing": {"attributes": {1: [0.0, 0.0]}}}
        self.refused("a key of attributes is 1", Scene.from_spheres, centres, radii, **tables, case=case)

    def test_dicts_with_wrong_keys_and_values(self):
        good = {"t_end": 1.0, "network": {"edges": [[0, 1]], "conductance": [1.0]}}
        Scene.from_dict(good)
        self.refused("case: unknown key 't_ent'", Scene.from_dict, {**good, "t_ent": 1})
        self.refused(
            "mine: unknown key 'capacty' in .network.; did you mean 'capacity'",
            Scene.from_dict,
            {**good, "network": {**good["network"], "capacty": 1.0}},
            name="mine",
        )
        self.refused("key 't_end' is 'soon'; it must be a number", Scene.from_dict, {**good, "t_end": "soon"})
        self.refused("key 't_end' is None; give it a value", Scene.from_dict, {**good, "t_end": None})
        self.refused("key 'title' is of type set", Scene.from_dict, {**good, "title": {1}})
        self.refused("keys must be strings", Scene.from_dict, {**good, 7: 1})
        self.refused("64 bits", Scene.from_dict, {**good, "t_end": 2**70})
        self.refused("edges and no conductance", Scene.from_dict, {"t_end": 1.0, "network": {"edges": [[0, 1]]}})
        self.refused(
            "capacity is an array, and the network is in files",
            Scene.from_dict,
            {"t_end": 1.0, "network": {"matrix": "K.mtx", "capacity": [1.0]}},
        )
        with self.assertRaisesRegex(TypeError, "a case must be a dict"):
            Scene.from_dict("case.toml")
        self.refused(
            "has no radii", Scene.from_dict, {"t_end": 1.0, "packing": {"centres": np.zeros((1, 3))}, "thermal": {}}
        )

    def test_files(self):
        self.refused("nobody.toml", Scene.from_file, "nobody.toml")
        self.refused("particles move", Scene.from_file, cases / "sintering_two_particles.toml")
        with tempfile.NamedTemporaryFile("w", suffix=".toml") as file:
            file.write("t_end = 1\nnetwork = 3\n")
            file.flush()
            self.refused(file.name + ":2: key 'network'", Scene.from_file, file.name)

    def test_masked_values_are_none(self):
        centres, radii = row_of_spheres()
        masked = np.ma.array(radii, mask=[k == 3 for k in range(12)])
        tables = {"conductivity": 50.0, "density": 7800.0, "specific_heat": 460.0, "t_end": 1.0}
        self.refused("radii has masked values", Scene.from_spheres, centres, masked, **tables)
        K = laplacian(5)
        hole = np.zeros(K.shape, dtype=bool)
        hole[0, 1] = hole[1, 0] = True
        self.refused("matrix has masked values", Scene.from_matrix, np.ma.array(K, mask=hole), t_end=1.0)
        rows = [np.ma.array(row, mask=masked) for row, masked in zip(K, hole)]
        self.refused("matrix has masked values", Scene.from_matrix, rows, t_end=1.0)
        compressed = (np.ma.array([1.0, 1.0], mask=[1, 0]), [1, 0], [0, 1, 2])
        self.refused("matrix has masked values", Scene.from_matrix, compressed, t_end=1.0)
        self.refused("conductance has masked values", Scene.from_edges, [[0, 1]], np.ma.array([1.0], mask=[1]), t_end=1.0)
        times = np.ma.array([0.5, 1.0], mask=[1, 0])
        self.refused("output_times has masked values", Scene.from_edges, [[0, 1]], 1.0, t_end=1.0, output_times=times)
        scene = network()
        self.refused("output_times has masked values", superstep.integrate, scene, output_times=times)
        y = np.ma.array(scene.y0, mask=[True] + [False] * (len(scene.y0) - 1))
        for call in (scene.rhs, scene.jacobian_data, lambda t, y: scene.values("", t, y)):
            self.refused("y has masked values", call, 0.0, y)
        unmasked = np.ma.array(scene.y0)
        np.testing.assert_array_equal(scene.rhs(0.0, unmasked), scene.rhs(0.0, scene.y0))
        scene = Scene.from_edges([[0, 1], [1, 2]], 1.0, t_end=1.0, fixed=np.ma.array([1.0, 7.0, 0.0], mask=[0, 1, 0]))
        self.assertEqual(list(scene.unknown_node), [1])

    def test_what_no_case_can_hold(self):
        centres, radii = row_of_spheres()
        tables = {"conductivity": 50.0, "density": 7800.0, "specific_heat": 460.0, "t_end": 1.0}
        holds_itself = {}
        holds_itself["a"] = holds_itself
        self.refused("holds itself", Scene.from_spheres, centres, radii, **tables, case=holds_itself)
        self.refused("half of a character", Scene.from_spheres, centres, radii, **{**tables, "neck": "\udc80"})
        self.refused(
            "attributes is of type list", Scene.from_spheres, centres, radii, **tables, case={"packing": {"attributes": [1]}}
        )
        large = {"packing": {"ids": np.arange(12, dtype=np.uint64) + np.uint64(2**63)}}
        self.refused("2\\^63 and more", Scene.from_spheres, centres, radii, **tables, case=large)
        self.refused("counted from 0", Scene.from_edges, [[0, 1], [1, 10**9]], 1.0, t_end=1.0)
        with self.assertRaisesRegex(TypeError, "case must be a dict"):
            Scene.from_spheres(centres, radii, **tables, case=[1])
        for wrong in ({0.25, 1.0}, {"a": 1.0}, "1.0", ["x"]):
            self.refused("output_times is no array", Scene.from_spheres, centres, radii, **tables, output_times=wrong)
            self.refused("output_times is no array", superstep.integrate, network(), output_times=wrong)
        self.refused("fixed is no array", Scene.from_edges, [[0, 1]], 1.0, t_end=1.0, fixed={1.0})
        times = Scene.from_spheres(centres, radii, **tables, output_times=(t for t in [0.25])).output_times
        self.assertEqual(times[0], 0.25)

    def test_odd_texts_arrive_as_they_are(self):
        title = 'a "quoted" \\ back\tslash \x7f é \U0001f642'
        self.assertEqual(network(case={"title": title}).title, title)


if __name__ == "__main__":
    unittest.main()
