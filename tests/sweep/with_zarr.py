"""Opens the results of a sweep as users do: with_zarr.py PROGRAM. Ends with status 77 where python3-zarr is missing."""
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

try:
    import numpy
    import zarr
except ImportError:
    print("skipped: python3-zarr is missing")
    sys.exit(77)

PROGRAM = sys.argv.pop()
STUDY = {
    "scene": {"mass_ratios": [1, 2], "stiffness_ratios": [1, 0.5], "damping_ratios": [0.03, 0.06], "contact": 2, "load": 1},
    "axes": [
        {"quantity": "r", "from": 0.3, "to": 1.7, "count": 9},
        {"quantity": "beta", "from": 0, "to": 1.5, "count": 6},
        {"quantity": "stiffness", "entry": 2, "values": [0.5, 0.75, 1]},
    ],
    "samples": {"method": "latin_hypercube", "count": 8, "seed": 5,
                "variables": [{"quantity": "zeta", "as": "factor", "uniform": {"from": 0.5, "to": 2}}]},
    "answers": ["regime", "amplitudes", "stops"],
    "masses": [1, 2],
    "reduce": [
        {"name": "share", "statistic": "share", "over": ["sample"]},
        {"name": "peak", "statistic": "maximum", "of": "amplitude_1", "over": ["r"]},
        {"name": "best", "statistic": "minimum", "of": "peak", "over": ["beta"]},
        {"name": "counts", "statistic": "histogram", "of": "amplitude_2", "over": ["sample", "r"],
         "bins": {"from": 0.01, "to": 10, "count": 5, "scale": "logarithmic"}},
        {"name": "band", "statistic": "quantiles", "of": "amplitude_1", "over": ["sample"], "probabilities": [0.25, 0.5, 1]},
    ],
    "points_of_a_chunk": 100,
}


class Results(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.scratch.name) / "study"
        cls.netcdf = Path(cls.scratch.name) / "result.nc"
        for arguments in (["plan", "-", cls.folder, "--without-estimate"], ["run", cls.folder, "--all"],
                          ["merge", cls.folder, "--to", cls.netcdf]):
            subprocess.run([PROGRAM, "sweep", *map(str, arguments)], input=json.dumps(STUDY), text=True, check=True, capture_output=True)
        cls.store = zarr.open_consolidated(str(cls.folder / "result.zarr"))

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def test_axes_are_named_as_xarray_names_them(self):
        self.assertEqual(self.store["amplitude_1"].attrs["_ARRAY_DIMENSIONS"], ["stiffness_2", "sample", "r", "beta"])
        numpy.testing.assert_array_equal(self.store["r"][:], numpy.linspace(0.3, 1.7, 9))
        numpy.testing.assert_array_equal(self.store["stiffness_2"][:], [0.5, 0.75, 1])

    def test_reductions_are_what_numpy_makes_of_the_points(self):
        amplitude, second = self.store["amplitude_1"][:], self.store["amplitude_2"][:]
        regime = self.store["regime"][:]
        share = numpy.stack([(regime == k).mean(axis=1) for k in (0, 1, 2, -1)], -1)
        numpy.testing.assert_array_equal(self.store["share"][:], share)
        peak = numpy.nanmax(amplitude, axis=2)
        numpy.testing.assert_array_equal(self.store["peak"][:], peak)
        numpy.testing.assert_array_equal(self.store["peak_r"][:], self.store["r"][:][numpy.nanargmax(amplitude, axis=2)])
        numpy.testing.assert_array_equal(self.store["best"][:], peak.min(axis=2))
        numpy.testing.assert_array_equal(self.store["best_beta"][:], self.store["beta"][:][peak.argmin(axis=2)])
        quantiles = numpy.quantile(amplitude, [0.25, 0.5, 1], axis=1)
        numpy.testing.assert_allclose(numpy.moveaxis(quantiles, 0, -1), self.store["band"][:], rtol=1e-14)
        edges = numpy.append(self.store["counts_bin"][1:], numpy.inf)
        for k in range(3):
            for n in range(6):
                counts = numpy.histogram(second[k, :, :, n], numpy.insert(edges, 0, -numpy.inf))[0]
                numpy.testing.assert_array_equal(self.store["counts"][k, n], counts)

    def test_netcdf_has_the_same_numbers(self):
        try:
            import netCDF4
        except ImportError:
            self.skipTest("python3-netcdf4 is missing")
        with netCDF4.Dataset(self.netcdf) as file:
            file.set_auto_mask(False)
            self.assertEqual(set(file.variables), set(self.store))
            for name in self.store:
                numpy.testing.assert_array_equal(file[name][:], self.store[name][:])

    def test_xarray_opens_it(self):
        try:
            import xarray
        except ImportError:
            self.skipTest("python3-xarray is missing")
        data = xarray.open_zarr(self.folder / "result.zarr")
        self.assertEqual(float(data.peak.sel(beta=0, stiffness_2=0.75, sample=3)), float(self.store["peak"][1, 3, 0]))


unittest.main()
