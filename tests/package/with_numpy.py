"""Reads a map with numpy, and compares natural frequencies with LAPACK's singular values: with_numpy.py PROGRAM."""
import csv
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

PROGRAM = sys.argv.pop()
CHAIN = {"mass_ratios": [1, 2.5, 0.75], "stiffness_ratios": [1, 0.625, 1.875], "damping_ratios": [0.03, 0.06, 0.09], "contact": 2, "load": 1}


def answer(scene, *words):
    return subprocess.run([PROGRAM, *words], input=json.dumps(scene), capture_output=True, text=True, check=True).stdout


class Map(unittest.TestCase):
    def test_npy_has_the_numbers_of_csv(self):
        grid = ["--r", "0.25:2:15", "--beta", "0:2:9", "--mass", "1", "--mass", "2"]
        rows = list(csv.DictReader(answer(CHAIN, "map", "-", *grid).splitlines()))
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "map.npy")
            answer(CHAIN, "map", "-", *grid, "--output", str(file))
            table = np.load(file, allow_pickle=False)
        self.assertEqual(table.shape, (15, 9))
        names = np.array(["continuous", "stick_slip", "permanent_sticking"])
        self.assertEqual(list(names[table["regime"].ravel()]), [row["regime"] for row in rows])
        for field, column in [("r", "r"), ("beta", "beta"), ("stops_per_period", "stops_per_period"), ("periods", "periods"),
                              ("amplitude_1", "amplitude_1"), ("amplitude_2", "amplitude_2")]:
            self.assertEqual(table[field].ravel().tolist(), [float(row[column]) for row in rows], field)
        self.assertTrue((table["status"] == 0).all())


class NaturalFrequencies(unittest.TestCase):
    def test_those_of_chains_are_singular_values(self):
        random = np.random.default_rng(117085)
        for N in [1, 2, 3, 5, 8, 13]:
            for contrast in [1, 6]:
                gamma, kappa = 10.0 ** random.uniform(-contrast, contrast, (2, N))
                gamma[0] = kappa[0] = 1
                elongations = np.eye(N) - np.eye(N, k=-1)  # of the springs, one a row
                bidiagonal = np.sqrt(kappa)[:, None] * elongations / np.sqrt(gamma)
                expected = np.sort(np.linalg.svd(bidiagonal, compute_uv=False))
                scene = {**CHAIN, "mass_ratios": gamma.tolist(), "stiffness_ratios": kappa.tolist(), "damping_ratios": 0.05, "contact": 1, "r": 1}
                modes = json.loads(answer(scene, "functions", "--json"))["modes"]
                found = np.array([mode["natural_frequency_ratio"] for mode in modes])
                # LAPACK's are good to rounding of the largest; where the contrast is small that is rounding of each.
                np.testing.assert_allclose(found, expected, rtol=1e-12 if contrast == 1 else 0, atol=1e-14 * expected[-1] * N)


if __name__ == "__main__":
    unittest.main()
