"""Runs: answers, memory, callbacks, and how they end."""

import os
import pathlib
import signal
import subprocess
import sys
import threading
import unittest

import numpy as np

import superstep
from samples import NaN, cases, laplacian, network, spheres
from superstep import InputError, MethodError, Scene, integrate

# Far more steps than anybody waits for; the limit ends the test where nothing else does.
ENDLESS = {"method": "forward-euler:step=1e-9", "time_limit": 120.0}


def address(array: np.ndarray) -> int:
    return array.__array_interface__["data"][0]


class Answers(unittest.TestCase):
    def test_a_network_decays_as_its_exponential(self):
        n, scene = 40, network(output_times=[0.1, 0.7])
        weight = 1 / np.sqrt(np.linspace(1, 2, n))
        eigenvalue, vector = np.linalg.eigh(weight[:, None] * laplacian(n) * weight)
        for method in ("exponential:rtol=1e-10", "cvode:rtol=1e-8", "rkc:rtol=1e-6", "auto"):
            result = integrate(scene, method, rtol=1e-6)
            np.testing.assert_array_equal(result.times, [0.1, 0.7, 2.0])
            for t, y in zip(result.times, result.states):
                exact = weight * (vector @ (np.exp(-eigenvalue * t) * (vector.T @ (scene.y0 / weight))))
                self.assertLess(np.sqrt(np.mean((y - exact) ** 2)), 1e-6 * 100, method)  # rtol times the span

    def test_a_module_that_a_method_loads_is_found_from_python(self):
        if "petsc" not in [method.name for method in superstep.methods()]:
            self.skipTest("built without PETSc")
        self.assertGreater(integrate(network(), "petsc:rtol=1e-4").statistics["steps"], 0)

    def test_rtol_and_the_spec_say_the_same(self):
        one, other = integrate(network(), "rkc", rtol=1e-5), integrate(network(), "rkc:rtol=1e-5")
        np.testing.assert_array_equal(one.states, other.states)
        self.assertTrue(one.method.startswith("rkc:rtol=1e-0"), one.method)

    def test_output_times_may_be_others_than_the_scene_has(self):
        scene = network(output_times=[0.5, 1.0])
        self.assertEqual(integrate(scene).times.tolist(), [0.5, 1.0, 2.0])
        self.assertEqual(integrate(scene, t_end=0.7).times.tolist(), [0.5, 0.7])
        self.assertEqual(integrate(scene, t_end=9.0).times.tolist(), [0.5, 1.0, 2.0, 9.0])
        self.assertEqual(integrate(scene, output_times=[0.25]).times.tolist(), [0.25])
        self.assertEqual(integrate(scene, output_times=[0.25], t_end=0.3).times.tolist(), [0.25, 0.3])
        self.assertEqual(scene.output_times.tolist(), [0.5, 1.0, 2.0])

    def test_every_scene_of_the_cases_gives_values_on_all_nodes(self):
        result = integrate(cases / "lattice_two_way.toml", "rock", rtol=1e-4)
        nodes = len(result.scene.ids)
        self.assertEqual(result.temperature.shape, (3, nodes))
        self.assertEqual(result.potential.shape, (3, nodes))
        self.assertEqual((result.potential[0].min(), result.potential[0].max()), (0.0, 4.0))
        self.assertGreater(result.temperature[-1].max(), 301)

    def test_a_steady_potential_is_solved_for(self):
        scene = spheres(
            case={
                "electric": {
                    "mode": "steady",
                    "conductivity": 1e6,
                    "fixed": [{"where": {"ids": [0]}, "value": 0.0}, {"where": {"ids": [11]}, "value": 1.0}],
                }
            }
        )
        self.assertEqual([field.steady for field in scene.fields], [True, False])
        result = integrate(scene)
        np.testing.assert_allclose(result.potential[0], np.arange(12) / 11, atol=1e-12)  # equal contacts in a row

    def test_statistics(self):
        result = integrate(network(), "rkc", rtol=1e-4)
        self.assertEqual((result.status, result.reason), ("ok", ""))
        for name in ("sweeps", "steps", "max_stages"):
            self.assertGreater(result.statistics[name], 0, name)
        self.assertGreaterEqual(result.statistics["cpu_stepping_s"], 0)
        self.assertEqual(len(result.spans), 1)
        self.assertIn("auto", integrate(network()).method)
        self.assertNotEqual(integrate(network()).choice, "")

    def test_threads_change_nothing(self):
        scene = Scene.from_dict(
            {"t_end": 0.5, "network": {"generator": "lattice", "size": 20000, "inlet": 1.0, "outlet": 0.0}}
        )
        one, two = (integrate(scene, "rkc:rtol=1e-3", threads=threads).states for threads in (1, 2))
        np.testing.assert_array_equal(one, two)


class Memory(unittest.TestCase):
    def test_states_are_the_memory_that_the_run_wrote_to(self):
        seen = []
        result = integrate(
            network(output_times=[0.5, 1.0]), on_output=lambda t, y: seen.append((t, address(y), y.shape))
        )
        self.assertEqual([t for t, _, _ in seen], result.times.tolist())
        self.assertEqual([where for _, where, _ in seen], [address(row) for row in result.states])
        self.assertFalse(result.states.flags.owndata)
        self.assertEqual(type(result.states.base).__name__, "PyCapsule")
        self.assertTrue(result.states.flags.c_contiguous)
        self.assertEqual(result.times.base is not None, True)

    def test_states_outlive_their_run_and_scene(self):
        scene = network()
        result = integrate(scene, "exponential:rtol=1e-9")
        states, expected = result.states, result.states.copy()
        del scene, result
        integrate(network(), "exponential:rtol=1e-9")
        np.testing.assert_array_equal(states, expected)

    def test_a_callback_sees_and_does_not_touch(self):
        def write(t, y):
            y[0] = 1.0

        with self.assertRaisesRegex(ValueError, "read-only"):
            integrate(network(), on_output=write)


class Endings(unittest.TestCase):
    def test_what_a_callback_raises_ends_the_run(self):
        class Enough(Exception):
            pass

        seen = []

        def stop(t, y):
            seen.append(t)
            raise Enough

        scene = network(output_times=[0.5, 1.0])
        with self.assertRaises(Enough):
            integrate(scene, on_output=stop)
        self.assertEqual(seen, [0.5])
        self.assertEqual(integrate(scene).status, "ok")  # nobody uses it any more

    def test_a_failing_method_says_why_and_keeps_what_it_reached(self):
        scene = network(output_times=[1e-4, 1.0])
        with self.assertRaisesRegex(MethodError, "errors grow") as caught:
            integrate(scene, "forward-euler:step=50", output_times=[1e-4, 5e3])
        error = caught.exception
        self.assertEqual(error.status, "unstable")
        self.assertIn("errors grow", error.reason)
        self.assertEqual(error.result.times.tolist(), [1e-4])
        self.assertEqual(error.result.states.shape, (1, 40))
        self.assertIsInstance(error, RuntimeError)

    def test_a_method_that_cannot_treat_the_scene_refuses(self):
        from samples import nonlinear

        with self.assertRaises(MethodError) as caught:
            integrate(nonlinear(), "exponential")
        self.assertEqual(caught.exception.status, "refused")

    def test_wrong_wishes_are_refused_before_anything_is_computed(self):
        scene = network()
        for words, named in {
            "did you mean 'rkc'": {"method": "rkk"},
            "unknown key": {"method": "rkc:rtl=1e-3"},
            "rtol": {"rtol": -1.0},
            "forward-euler": {"method": "forward-euler", "rtol": 1e-3},
            r"output_times\[1\] is 0.5": {"output_times": [1.0, 0.5]},
            r"output_times\[0\] is nan": {"output_times": [NaN]},
            r"output_times\[0\] is 0": {"output_times": [0.0]},
            "is empty": {"output_times": []},
            r"shape \(1, 1\)": {"output_times": [[1.0]]},
            "none may be after t_end": {"output_times": [1.0], "t_end": 0.5},
            "threads is 0": {"threads": 0},
        }.items():
            with self.subTest(words), self.assertRaisesRegex(InputError, words):
                integrate(scene, **named)
        for named in ({"method": 7}, {"on_output": 3}):
            with self.assertRaisesRegex(TypeError, next(iter(named))):
                integrate(scene, **named)
        with self.assertRaisesRegex(InputError, "y has 3 values"):
            scene.rhs(0, [1, 2, 3])
        with self.assertRaisesRegex(InputError, "no field 'heat'"):
            scene.values("heat", 0, scene.y0)

    def test_inputs_are_not_guessed_beyond_what_is_known_of_them(self):
        pulse = {"times": [0, 1, 1, 2], "values": [1, 1, 0, 0], "period": 2}
        scene = Scene.from_edges([[0, 1]], 1.0, t_end=10.0, case={"network": {"source": pulse}})
        self.assertEqual(integrate(scene, t_end=5.0).times[-1], 5.0)
        with self.assertRaisesRegex(InputError, "build the scene with a later t_end"):
            integrate(scene, t_end=11.0)

    def test_ctrl_c_ends_a_run_and_leaves_the_scene(self):
        scene = network(t_end=1e3)
        timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            integrate(scene, **ENDLESS)
        timer.join()
        self.assertEqual(integrate(scene, "exponential").status, "ok")

    def test_other_signals_do_what_python_says_and_the_run_goes_on(self):
        seen = []
        before = signal.signal(signal.SIGUSR1, lambda *_: seen.append(1))
        try:
            timer = threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGUSR1))
            timer.start()
            with self.assertRaises(MethodError) as caught:
                integrate(network(t_end=1e3), "forward-euler:step=1e-9", time_limit=1.0)
            timer.join()
        finally:
            signal.signal(signal.SIGUSR1, before)
        self.assertEqual((seen, caught.exception.status), ([1], "timeout"))

    def test_other_threads_go_on(self):
        count, over = 0, threading.Event()

        def work():
            nonlocal count
            while not over.is_set():
                count += 1

        worker = threading.Thread(target=work)
        worker.start()
        before = count
        with self.assertRaises(MethodError):  # it is long
            integrate(network(t_end=1e3), "forward-euler:step=1e-9", time_limit=0.5)
        counted = count - before
        over.set()
        worker.join()
        self.assertGreater(counted, 1000)

    def test_a_negative_time_limit_is_refused(self):
        with self.assertRaisesRegex(InputError, "time_limit is -1.0; it must be seconds, or 0"):
            integrate(network(), "rkc", time_limit=-1.0)

    def test_two_scenes_run_beside_each_other(self):
        results = [None, None]

        def work(k):
            results[k] = integrate(network(), "rkc:rtol=1e-6")

        workers = [threading.Thread(target=work, args=(k,)) for k in range(2)]
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join()
        np.testing.assert_array_equal(results[0].states, results[1].states)

    def test_a_scene_that_is_in_use_says_so(self):
        scene = network()
        with self.assertRaisesRegex(RuntimeError, "the scene is being used"):
            integrate(scene, on_output=lambda t, y: scene.rhs(t, y))
        values = []
        integrate(scene, on_output=lambda t, y: values.append(scene.values("", t, y)))  # this needs nothing of it
        self.assertEqual(len(values), 1)


class TheModule(unittest.TestCase):
    def test_under_a_launcher_of_parallel_programs_each_interpreter_is_alone(self):
        script = "import superstep as s; print(s.integrate(s.Scene.from_edges([[0, 1]], 1.0, t_end=1.0)).status)"
        environment = {**os.environ, "OMPI_COMM_WORLD_SIZE": "3", "OMPI_COMM_WORLD_RANK": "1"}
        said = subprocess.run(
            [sys.executable, "-c", script], env=environment, check=True, capture_output=True, text=True
        )
        self.assertEqual(said.stdout.strip(), "ok")

    def test_it_names_every_method(self):
        names = [method.name for method in superstep.methods()]
        for name in ("forward-euler", "rkc", "cvode", "auto"):
            self.assertIn(name, names)
        rkc = next(method for method in superstep.methods() if method.name == "rkc")
        self.assertIn("rtol", rkc.keys)

    def test_it_is_typed_and_documented(self):
        folder = pathlib.Path(superstep.__file__).parent
        self.assertTrue((folder / "py.typed").exists())
        for name in superstep.__all__:
            if not name.startswith("_"):
                self.assertTrue(getattr(superstep, name).__doc__, name)


if __name__ == "__main__":
    unittest.main()
