"""The benchmark as columns."""

import csv
import os
import signal
import subprocess
import tempfile
import threading
import unittest
import warnings

import numpy as np

from samples import cases, network
from superstep import InputError, bench

FEW = ("rkc:rtol=1e-3", "exponential:rtol=1e-3")


class Benchmarks(unittest.TestCase):
    def test_columns_are_those_of_the_program(self):
        columns = bench(cases / "chain.toml", FEW, repetitions=1, cache=False)
        with tempfile.TemporaryDirectory() as folder:
            command = [os.environ["SUPERSTEP_PROGRAM"], "bench", str(cases / "chain.toml"), "--repetitions", "1"]
            command += ["--no-cache", "--quiet", "--out", folder]
            for method in FEW:
                command += ["--integrator", method]
            subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
            with open(os.path.join(folder, "results.csv"), encoding="utf-8") as file:
                rows = list(csv.DictReader(file))
        self.assertEqual(list(columns), list(rows[0]))
        self.assertEqual({len(column) for column in columns.values()}, {len(rows)})
        for name in ("case", "integrator", "params", "status"):
            self.assertEqual(columns[name], [row[name] for row in rows])
        for name in ("nodes", "steps", "rhs", "error_rms"):
            np.testing.assert_allclose(columns[name], [float(row[name] or "nan") for row in rows], rtol=1e-6)

    def test_numbers_are_arrays_and_texts_lists(self):
        columns = bench(network(), FEW, repetitions=1)
        self.assertIsInstance(columns["status"], list)
        self.assertEqual(columns["nodes"].dtype.kind, "i")
        self.assertEqual(columns["cpu_total_s"].dtype.kind, "f")
        self.assertEqual(columns["status"], ["ok"] * 3)  # the baseline is added

    def test_several_scenes_are_one_table(self):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            columns = bench(
                [network(name="one"), cases / "lattice_two_way.toml"], ["rkc:rtol=1e-3"], repetitions=1, cache=False
            )
        self.assertEqual(len(set(columns["case"])), 2)
        self.assertEqual({len(column) for column in columns.values()}, {len(columns["case"])})
        potential = [name for name in columns if name.endswith("_potential")]
        self.assertTrue(potential)
        first = np.array([case == "one" for case in columns["case"]])
        for name in potential:
            self.assertTrue(np.isnan(np.asarray(columns[name], dtype=float)[first]).all(), name)

    def test_a_time_limit_below_zero_or_none_at_all_is_refused(self):
        for seconds in (-1.0, float("nan")):
            with self.assertRaisesRegex(InputError, "time_limit is .*; it must be seconds, or 0"):
                bench(network(), FEW, time_limit=seconds)

    def test_a_method_that_fails_is_a_row(self):
        columns = bench(network(t_end=5e3), ["forward-euler:step=50"], repetitions=1)
        row = columns["integrator"].index("forward-euler")
        self.assertIn("unstable", columns["status"])
        self.assertEqual(columns["status"][row], "unstable")

    def test_wrong_wishes_are_refused(self):
        for words, named in {
            "did you mean 'rkc'": {"methods": ["rkk"]},
            "repetitions is 0": {"repetitions": 0},
            "threads is -1": {"threads": -1},
            "unknown integrator|did you mean": {"reference": "cvodee"},
        }.items():
            with self.subTest(words), self.assertRaisesRegex(InputError, words):
                bench(network(), **named)
        with self.assertRaisesRegex(InputError, "no scene"):
            bench([])

    def test_ctrl_c_ends_it(self):
        timer = threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            bench(network(t_end=1e3), ["forward-euler:step=1e-9"], time_limit=120.0)
        timer.join()

    def test_pandas_takes_them(self):
        try:
            import pandas
        except ImportError:
            self.skipTest("pandas is not installed")
        table = pandas.DataFrame(bench(network(), FEW, repetitions=1))
        self.assertEqual(len(table), 3)


if __name__ == "__main__":
    unittest.main()
