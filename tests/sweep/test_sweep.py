"""Studies in chunks: bytes that do not depend on who computed them, and what is left after accidents.

Needs DENHARTOG_LIBRARY, DENHARTOG_PROGRAM, DENHARTOG_SOURCE_DIR. Ends with status 77 where a package is missing. docs/promises.md names these tests by
their first lines.
"""
import contextlib
import copy
import csv
import io
import json
import os
import pathlib
import pty
import signal
import subprocess
import sys
import tempfile
import time
import unittest

try:
    import dask
    import jsonschema
    import netCDF4
    import numpy as np
    import scipy
    import xarray
    import zarr
except ImportError as missing:
    print(f"skipped: {missing} (Debian packages python3-xarray, -zarr, -dask, -scipy, -netcdf4, -jsonschema)")
    sys.exit(77)

SOURCE, PROGRAM = pathlib.Path(os.environ["DENHARTOG_SOURCE_DIR"]), os.environ["DENHARTOG_PROGRAM"]
sys.path.insert(0, str(SOURCE / "src/python"))
os.environ["PYTHONPATH"] = str(SOURCE / "src/python")
import denhartog
from denhartog import InputError, _study, sweep

STUDY = {
    "scene": {"mass_ratios": [1, 2], "stiffness_ratios": [1, 0.5], "damping_ratios": [0.03, 0.06], "contact": 2, "load": 1},
    "axes": [{"quantity": "r", "from": 0.3, "to": 1.7, "count": 9}, {"quantity": "beta", "from": 0, "to": 1.5, "count": 6}],
    "answers": ["regime", "amplitudes", "stops"], "masses": [1, 2], "points_of_a_chunk": 12,
}
# With samples, and with reductions in which several chunks have a part and others in which they have not.
REDUCED = STUDY | {
    "samples": {"method": "sobol", "count": 8, "seed": 5, "variables": [
        {"quantity": "zeta", "as": "factor", "lognormal": {"median": 1, "log_standard_deviation": 0.3}},
        {"quantity": "beta", "as": "factor", "uniform": {"from": 0.8, "to": 1.2}}]},
    "reduce": [
        {"name": "regimes", "statistic": "share", "over": ["sample"]},
        {"name": "peak", "statistic": "maximum", "of": "amplitude_1", "over": ["r", "sample"]},
        {"name": "least", "statistic": "minimum", "of": "amplitude_2", "over": ["r"]},
        {"name": "counts", "statistic": "histogram", "of": "amplitude_2", "over": ["sample", "r"],
         "bins": {"from": 0.01, "to": 10, "count": 5, "scale": "logarithmic"}},
        {"name": "middle", "statistic": "quantiles", "of": "amplitude_1", "over": ["sample"], "probabilities": [0.5],
         "bins": {"from": 0, "to": 20, "count": 400}},
        {"name": "stops", "statistic": "maximum", "of": "stops_per_period", "over": ["r", "sample"]},
        {"name": "band", "statistic": "quantiles", "of": "amplitude_1", "over": ["beta"], "probabilities": [0.25, 0.75]}]}
# One chunk that takes far longer than it is given.
LONG = STUDY | {"axes": [{"quantity": "r", "from": 0.3, "to": 1.7, "count": 4000}, {"quantity": "beta", "from": 0, "to": 1.5, "count": 200}],
                "points_of_a_chunk": 10**6}


def files_of(folder):
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


def mapped(scene, *arguments):
    """The rows of a map of the program, its header first."""
    text = subprocess.run([PROGRAM, "map", "-", *arguments], input=json.dumps(scene), capture_output=True, text=True, check=True).stdout
    return list(csv.reader(text.splitlines()))


def command(*arguments):
    return [sys.executable, "-m", "denhartog.sweep", *map(str, arguments)]


class Sweep(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.scratch = pathlib.Path(scratch.name)

    def assert_same_files(self, some, others):
        self.assertEqual([name for name in sorted({*some, *others}) if some.get(name) != others.get(name)], [])

    def planned(self, study=REDUCED, name="study"):
        sweep.plan(study, self.scratch / name)
        return self.scratch / name

    def combined(self, folder, to="result.nc"):
        sweep.combine(folder, folder / to)
        return (folder / to).read_bytes()

    def opened(self, study, grid=None):
        """The results of a study as they are when every chunk was stored and combined."""
        folder = self.planned(study)
        sweep.run(folder)
        sweep.combine(folder, folder / "result.zarr")
        return xarray.open_zarr(folder / "result.zarr").load()

    def called(self, *arguments, text=None):
        """Status, standard output and standard error of the command, within this process."""
        out, err, before = io.StringIO(), io.StringIO(), {n: signal.getsignal(n) for n in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)}
        stdin, sys.stdin = sys.stdin, io.StringIO(text)
        try:
            with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
                try:
                    status = sweep.main([str(each) for each in arguments])
                except SystemExit as left:
                    status = left.code
        finally:
            sys.stdin = stdin
            for number, handler in before.items():
                signal.signal(number, handler)
        return status, out.getvalue(), err.getvalue()

    def assert_refused(self, told, *arguments, status=2, text=None):
        """The command ends with a status and says why, and prints nothing else."""
        found, out, err = self.called(*arguments, text=text)
        self.assertEqual((found, out), (status, ""))
        self.assertIn(told, err)
        return err

    def test_order(self):
        """the results have the same bytes for any number of workers and any order of the chunks"""
        one, many = self.planned(name="one"), self.planned(name="many")
        sweep.run(one)
        chunks = sweep.opened(one)[0].chunks
        self.assertGreater(chunks, 30)
        sweep.run(many, range(chunks - 1, chunks // 2, -1), jobs=2)
        sweep.run(many, jobs=3)
        self.assert_same_files(files_of(one / "chunks"), files_of(many / "chunks"))
        self.assertTrue(self.combined(one) == self.combined(many))
        sweep.combine(one, one / "result.zarr")
        for seed in "123":  # of the order in which Python has the members of a set
            for result in (many / f"{seed}.zarr", many / f"{seed}.nc"):
                subprocess.run(command("combine", many, result), check=True, env=os.environ | {"PYTHONHASHSEED": seed})
            self.assert_same_files(files_of(one / "result.zarr"), files_of(many / f"{seed}.zarr"))
            self.assertTrue((one / "result.nc").read_bytes() == (many / f"{seed}.nc").read_bytes())

    def test_division(self):
        """the results do not depend on how a study is divided"""
        small, large = (self.opened_with(points) for points in (6, 1000))
        xarray.testing.assert_identical(small, large)

    def opened_with(self, points):
        with tempfile.TemporaryDirectory() as scratch:
            self.scratch = pathlib.Path(scratch)
            return self.opened(REDUCED | {"points_of_a_chunk": points})

    def test_map(self):
        """the points of a sweep are those of map, to the last bit"""
        data = self.opened(STUDY)
        rows = mapped(STUDY["scene"], "--r", "0.3:1.7:9", "--beta", "0:1.5:6", "--mass", "1", "--mass", "2")[1:]
        self.assertEqual(len(rows), 54)
        for row, (r, beta) in zip(rows, np.ndindex(9, 6)):
            point = data.isel(r=r, beta=beta)
            self.assertEqual(row[2], denhartog._results.REGIMES[int(point.regime)])
            self.assertEqual(int(row[3]), int(point.stops_per_period))
            self.assertEqual([float(row[5]), float(row[6])], [float(point.amplitude_1), float(point.amplitude_2)])
        self.assertGreater(int((data.regime == 1).sum()), 3)

    def test_units(self):
        """a sweep in hertz and newtons is the map in hertz and newtons, to the last bit"""
        scene = {"masses": [12.0, 11.5], "stiffnesses": [18500, 17200], "damping_ratios": 0.01, "contact": 2}
        for more in ({"base_motion": "with_wall", "base_displacement": 0.002}, {"load": 1, "force": 40},
                     {"base_motion": "alone", "base_displacement": 0.002, "damping_ratios": 0}, {"load": 1, "unbalance": 0.1}):
            with self.subTest(more):
                data = sweep.dataset({"scene": scene | more, "axes": [{"quantity": "frequency_hz", "from": 2, "to": 4, "count": 5},
                                                                      {"quantity": "friction", "from": 0, "to": 8, "count": 3}]}).compute()
                rows = mapped(scene | more, "--frequency-hz", "2:4:5", "--friction", "0:8:3")
                self.assertEqual([float(row[rows[0].index("amplitude_2")]) for row in rows[1:]], data.amplitude_2.values.ravel().tolist())

    def test_levels(self):
        """a sweep over the level of the load is the map over it, to the last digits"""
        scene = {"masses": [12.0, 11.5], "stiffnesses": [18500, 17200], "damping_ratios": 0.01, "contact": 2, "load": 1}
        hertz = 3
        for name, value in (("force", 40), ("unbalance", 0.1)):
            level = {name: value}
            with self.subTest(name):
                data = sweep.dataset({"scene": scene | level, "axes": [
                    {"quantity": "frequency_hz", "values": [hertz]}, {"quantity": "friction", "values": [5]},
                    {"quantity": name, "from": value, "to": 2 * value, "count": 3}]}).compute()
                rows = mapped(scene | level | {"friction": 5, "frequency_hz": hertz}, "--frequency-hz", f"{hertz}:{hertz}:1",
                              f"--{name}", f"{value}:{2 * value}:3")
                np.testing.assert_allclose(data.amplitude_2.values.ravel(), [float(row[5]) for row in rows[1:]], rtol=1e-9)

    def test_from_ground(self):
        """absolute displacements of a sweep are those of solve"""
        scene = {"mass_ratios": [1, 2], "stiffness_ratios": [1, 0.75], "damping_ratios": 0.05, "contact": 2, "base_motion": "wall"}
        study = {"scene": scene, "axes": [{"quantity": "r", "values": [0.5, 1.5]}, {"quantity": "beta", "values": [0.05, 0.4]}],
                 "answers": ["amplitudes", "phases"], "from_ground": True, "masses": [1]}
        data = sweep.dataset(study).compute()
        for r in (0.5, 1.5):
            for beta in (0.05, 0.4):
                seen = denhartog.System.from_scene(scene).solve(r, beta).from_ground
                at = data.sel(r=r, beta=beta)
                self.assertEqual([float(at.amplitude_1), float(at.phase_1)], [seen.amplitude[0], seen.phase[0]])
        for wrong in ({"scene": scene | {"base_motion": None, "load": 1}}, {"start": "sliding"}):
            bad = {**study, **wrong}
            bad["scene"] = {key: value for key, value in bad["scene"].items() if value is not None}
            self.assertRaises(denhartog.InputError, sweep.dataset, bad)

    def test_phases(self):
        """phases of a sweep are those of solve"""
        data = sweep.dataset(STUDY | {"axes": [{"quantity": "r", "values": [0.7]}, {"quantity": "beta", "values": [0.1, 0.4, 20]}],
                                      "answers": ["phases"]}).compute()
        system = denhartog.System.from_scene(STUDY["scene"])
        for beta in (0.1, 0.4):
            self.assertEqual(float(data.phase_2.sel(beta=beta)), system.solve(0.7, beta).phase[1])
        self.assertTrue(np.isnan(data.phase_2.sel(beta=20)))  # it rests

    def test_no_scene(self):
        """a sample whose numbers make no scene has points that say so"""
        data = self.opened(STUDY | {"start": "sliding", "samples": {"method": "sobol", "count": 16, "seed": 1, "variables": [
            {"quantity": "mu", "normal": {"mean": 1, "standard_deviation": 0.1}}]}})
        none = data.status == data.status.flag_values[-1]
        self.assertEqual(data.status.flag_meanings.split()[-1], "no_scene")
        np.testing.assert_array_equal(none.all(["r", "beta"]), data.mu < 1)
        self.assertEqual(int(none.sum()), 8 * 54)
        self.assertTrue(np.isnan(data.amplitude_1.where(none, drop=True)).all())

    def test_again(self):
        """a chunk that is run again is found done, and combine tells the chunks that are missing"""
        folder = self.planned()
        self.assertEqual(self.called("run", folder, "--chunk", "0-3"), (0, "chunks: 4 computed, 0 done before\n", ""))
        self.assertEqual(self.called("run", folder, "--chunk", "2-4", "--chunk", "5")[1], "chunks: 2 computed, 2 done before\n")
        last = sweep.opened(folder)[0].chunks - 1
        self.assert_refused(f"6-{last}: missing", "combine", folder, folder / "result.nc", status=1)
        self.assertFalse((folder / "result.nc").exists())
        self.assertIn(f"6 of {last + 1} chunks", self.called("status", folder)[1])

    def test_truncated(self):
        """a truncated chunk is found by combine and computed again by run"""
        folder = self.planned()
        sweep.run(folder, jobs=2)
        before, path = files_of(folder / "chunks"), folder / "chunks/7.npz"
        whole = path.read_bytes()
        altered = bytearray(whole)
        altered[-100] ^= 1
        for damaged in (whole[:len(whole) // 2], bytes(altered), whole[:30], b"", whole + b"x"):
            path.write_bytes(damaged)
            self.assert_refused("7: its file", "combine", folder, folder / "result.zarr", status=1)
            self.assertFalse((folder / "result.zarr").exists())
            status, out, err = self.called("run", folder)
            self.assertEqual((status, out), (0, f"chunks: 1 computed, {len(before) - 1} done before\n"))
            self.assertIn("chunk 7 is computed again", err)
            self.assert_same_files(files_of(folder / "chunks"), before)

    def test_version(self):
        """a chunk of another version is never put together with others"""
        folder, other = self.planned(), self.planned(REDUCED | {"effort": 10**7}, "other")
        sweep.run(folder)
        sweep.run(other, [5])
        for foreign in ((other / "chunks/5.npz").read_bytes(), (folder / "chunks/4.npz").read_bytes()):
            (folder / "chunks/5.npz").write_bytes(foreign)
            self.assert_refused("5: it was left by another program or another study", "combine", folder, folder / "result.nc", status=1)
            self.assertIn("another study: 5", self.called("status", folder)[1])
            self.assertEqual(self.called("run", folder, "--chunk", 5)[1], "chunks: 1 computed, 0 done before\n")
        self.assertEqual(self.called("combine", folder, folder / "result.nc")[0], 0)
        # The folder of another program is not touched, nor one that was altered.
        about = json.loads((folder / "study.json").read_text())
        for altered in (about | {"fingerprint": "0" * 64}, about | {"study": about["study"] | {"start": "sliding"}}):
            (folder / "study.json").write_text(json.dumps(altered))
            for arguments in (("run", folder), ("status", folder), ("combine", folder, folder / "other.nc")):
                self.assert_refused("the same program and the same study", *arguments)
        program = sweep._program
        sweep._program = lambda: b"another"
        self.addCleanup(setattr, sweep, "_program", program)
        self.assertEqual(self.called("run", other)[0], 2)
        self.assertEqual(self.called("plan", "-", other, text=json.dumps(REDUCED | {"effort": 10**7}))[0], 2)

    def test_stranger(self):
        """a file that no chunk wrote stands against combine"""
        folder = self.planned(STUDY)
        sweep.run(folder)
        (folder / "chunks/.3.npz.00.part").write_bytes(b"a run was killed while it wrote")
        before = self.combined(folder)
        self.assertEqual(sorted(os.listdir(folder / "chunks")), [f"{K}.npz" for K in range(5)])
        self.assert_refused("RESULT must not be there yet", "combine", folder, folder / "result.nc")  # a result is not overwritten
        self.assertEqual((folder / "result.nc").read_bytes(), before)
        (folder / "chunks/99.npz").write_bytes(b"")
        self.assertIn("chunks/99.npz is a file that no chunk of this plan wrote", self.called("combine", folder, folder / "x.nc")[2])

    def test_twice(self):
        """two runs of one chunk at once leave it once"""
        folder, one = self.planned(), self.planned(name="one")
        sweep.run(one)
        runs = [subprocess.Popen(command("run", folder), stdout=subprocess.DEVNULL) for _ in range(3)]
        self.assertEqual([run.wait() for run in runs], [0, 0, 0])
        self.assert_same_files(files_of(folder / "chunks"), files_of(one / "chunks"))

    def started(self, folder, *arguments):
        """A run that is in the middle of its chunk."""
        run = subprocess.Popen(command("run", folder, *arguments), stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(run.communicate)
        end = time.monotonic() + 120
        while time.monotonic() < end:  # its thread that computes is there, and has worked for a while
            ticks = sum(map(int, pathlib.Path(f"/proc/{run.pid}/stat").read_text().rsplit(")", 1)[1].split()[11:13]))
            if ticks > 100:  # hundredths of a second of the processor; it starts in half of these
                return run
            time.sleep(0.02)
        self.fail("the run did not come to its chunk")

    def test_interrupted(self):
        """a sweep that is interrupted leaves no half chunk, and its status is the signal"""
        folder = self.planned(LONG)
        before = files_of(folder)
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            for jobs in (1, 2):
                run = self.started(folder, "--jobs", jobs)
                run.send_signal(number)
                self.assertEqual(run.wait(60), 128 + number)
                self.assert_same_files(files_of(folder), before)

    def test_killed(self):
        """a sweep that is killed leaves no chunk that counts as done"""
        folder = self.planned(LONG)
        run = self.started(folder)
        run.kill()
        run.wait()
        self.assertEqual(sweep.faults(folder), {"missing": [0]})
        self.assertEqual(self.called("combine", folder, folder / "result.nc")[0], 1)

    def test_full_disk(self):
        """a sweep on a full disk says so, leaves nothing half-written, and goes on when there is room"""
        folder = self.planned(REDUCED | {"points_of_a_chunk": 432})
        before = files_of(folder)
        full = lambda *arguments: subprocess.run(["bash", "-c", "ulimit -f 4; exec \"$@\"", "bash", *command(*arguments)],
                                                 capture_output=True, text=True)
        run = full("run", folder)
        self.assertEqual(run.returncode, 2)
        self.assertIn("cannot be written", run.stderr)
        self.assert_same_files(files_of(folder), before)
        sweep.run(folder)
        self.assertEqual(full("combine", folder, folder / "all.nc").returncode, 2)
        self.assertEqual([name for name in os.listdir(folder) if "all.nc" in name], [])
        self.combined(folder)
        with open("/dev/full", "w") as full:
            self.assertEqual(subprocess.run(command("status", folder), stdout=full, stderr=subprocess.DEVNULL).returncode, 2)

    def test_progress(self):
        """a run on a terminal shows how much is done and the time left"""
        folder = self.planned(STUDY)
        ours, its = pty.openpty()
        subprocess.run(command("run", folder), stderr=its, stdout=subprocess.DEVNULL, check=True)
        os.close(its)
        shown = os.read(ours, 10000).decode()
        os.close(ours)
        self.assertRegex(shown, r"\[########\.+\]  20 %  1 of 5 chunks, \d+ s left")
        self.assertIn("100 %  5 of 5 chunks, 0 s left", shown)
        for file in (folder / "chunks").iterdir():
            file.unlink()
        told = []
        sweep.run(folder, told=lambda *news: told.append(news))
        self.assertEqual([news[:2] for news in told], [(n, 5) for n in range(1, 6)])
        self.assertTrue(all(news[2] > 0 for news in told[:4]) and told[4][2] == 0, told)

    def test_refused(self):
        """what a sweep is asked for wrongly is refused"""
        folder = self.planned(STUDY)
        for arguments, told in ((("run", folder, "--chunk", "99"), "from 0 to 4, or two with a hyphen, the lower first, but is 99"),
                                (("run", folder, "--chunk", "3-1"), "3-1"), (("run", folder, "--chunk", "1-2-3"), "1-2-3"),
                                (("run", folder, "--chunk", "²"), "--chunk"), (("run", folder, "--jobs", 0), "--jobs must be at least 1"),
                                (("run", self.scratch / "none"), "`plan` has written"),
                                (("combine", folder, "x.h5"), ".zarr or .nc"),
                                (("combine", folder, self.scratch / "none/x.nc"), "RESULT must be in a folder that is there"), (("plan", self.scratch / "none.json", "x"), "STUDY"),
                                (("plan", SOURCE / "docs/study_best_friction.json", folder / "study.json/new"), "FOLDER must be"),
                                (("plan", "-", self.scratch / "new"), "JSON"), (("run",), "FOLDER"),
                                (("status", self.scratch), "`plan` has written")):
            with self.subTest(arguments):
                self.assert_refused(told, *arguments, text="{")
        self.assertFalse((self.scratch / "new").exists())

    def test_reductions(self):
        """chunks in any number and order add up to the reduction of all points"""
        for points in (1, 30, 10**6):
            data = sweep.dataset(REDUCED | {"points_of_a_chunk": points}).compute()
            first, second, regime = (data[name].transpose("r", "sample", "beta").values for name in ("amplitude_1", "amplitude_2", "regime"))
            r, sample = data.r.values, data.sample.values
            np.testing.assert_array_equal(data.regimes, np.stack([(regime == k).mean(1) for k in (0, 1, 2, -1)], -1))
            flat = data.amplitude_1.transpose("sample", "r", "beta").values.reshape(-1, 6)
            np.testing.assert_array_equal(data.peak, flat.max(0))
            np.testing.assert_array_equal(data.peak_sample, sample[flat.argmax(0) // 9])
            np.testing.assert_array_equal(data.peak_r, r[flat.argmax(0) % 9])
            np.testing.assert_array_equal(data.least, second.min(0))
            np.testing.assert_array_equal(data.least_r, r[second.argmin(0)])
            edges = np.append(data.counts_bin.values, np.inf)
            for n in range(6):
                np.testing.assert_array_equal(data.counts[n], np.histogram(second[:, :, n], edges)[0])
            np.testing.assert_allclose(data.band, np.moveaxis(np.quantile(first, [0.25, 0.75], 2), 0, -1).swapaxes(0, 1), rtol=1e-14)
            np.testing.assert_allclose(data.middle[..., 0], np.quantile(first, 0.5, 1, method="inverted_cdf"), atol=0.05)
            stops = data.stops_per_period.transpose("sample", "r", "beta").values.reshape(-1, 6)
            np.testing.assert_array_equal(data.stops_sample, sample[stops.argmax(0) // 9])  # of equal ones the first

    def test_ties(self):
        """of equal largest values in several chunks the one with the earliest place counts, and a cell without numbers has none"""
        numbers = {"value": np.array([[3.0, 3, 1, -np.inf]] + [[-np.inf] * 4]), "place": np.array([[7, 2, 0, 9]] * 2)}
        for order in ([0, 1, 2, 3], [3, 2, 1, 0]):
            together = _study.extreme({"statistic": "maximum"}, {kind: each[:, order] for kind, each in numbers.items()}, (1,))
            np.testing.assert_array_equal(together["value"], [[3], [-np.inf]])
            self.assertEqual(together["place"][0], 2)
        pole = {"scene": {"mass_ratios": [1], "stiffness_ratios": [1], "damping_ratios": 0, "contact": 1, "load": 1}, "points_of_a_chunk": 2,
                "reduce": [{"name": "least", "statistic": "minimum", "of": "amplitude_1", "over": ["r"]}]}
        for r, place in (([1, 1], np.nan), ([1, 0.5], 0.5)):
            data = sweep.dataset(pole | {"axes": [{"quantity": "r", "values": r}, {"quantity": "beta", "values": [0, 0.1]}]}).compute()
            np.testing.assert_array_equal(data.least_r, [place] * 2)
            np.testing.assert_array_equal(np.isnan(data.least), [np.isnan(place)] * 2)

    def test_histogram(self):
        """quantiles of a histogram are linear within a bin, and not a number where they lie outside of the bins"""
        edges, counts = np.array([0.0, 1, 2, 3]), np.array([[0, 2, 0, 2, 0], [1, 2, 1, 0, 0], [0, 0, 0, 0, 0], [0, 0, 4, 0, 4]])
        found = _study._quantiles_of_counts(counts, edges, [0, 0.25, 0.5, 0.75, 1])
        nan = np.nan
        np.testing.assert_array_equal(found, [[0, 0.5, 1, 2.5, 3], [nan, 0, 0.5, 1, 2], [nan] * 5, [1, 1.5, 2, nan, nan]])

    def test_lazy(self):
        """a lazy dataset computes what the chunks of a folder have, in threads and in processes"""
        stored = self.opened(REDUCED)
        with dask.config.set(scheduler=lambda *_, **__: self.fail("something was computed")):
            lazy = sweep.dataset(REDUCED)
        self.assertTrue(all(dask.is_dask_collection(values.data) for name, values in lazy.data_vars.items() if not name.endswith("_factor")))
        for scheduler in ("threads", "processes"):
            xarray.testing.assert_identical(lazy.compute(scheduler=scheduler, num_workers=2), stored)

    def test_grid(self):
        """a grid and samples of xarray stand in place of axes and samples"""
        study = {key: value for key, value in REDUCED.items() if key not in ("axes", "samples")}
        whole = sweep.dataset(REDUCED)
        grid = whole[["r", "beta", "sample", "zeta_factor", "beta_factor"]]
        xarray.testing.assert_identical(sweep.dataset(study, grid).compute(), whole.compute())
        with self.assertRaisesRegex(InputError, "gravity must vary one of"):
            sweep.dataset(study, grid.rename(zeta_factor="gravity"))
        for name in ("r", "beta_factor"):
            with self.assertRaisesRegex(InputError, f"{name} must be a number or an array of numbers"):
                sweep.dataset(study, grid.assign({name: grid[name] + 0.5j}))

    def test_files(self):
        """zarr, xarray and netCDF4 read the results of a sweep"""
        folder = self.planned()
        sweep.run(folder)
        self.combined(folder)
        sweep.combine(folder, folder / "result.zarr")
        store = zarr.open_consolidated(str(folder / "result.zarr"))
        self.assertEqual(store["amplitude_1"].attrs["_ARRAY_DIMENSIONS"], ["sample", "r", "beta"])
        np.testing.assert_array_equal(store["r"][:], 0.3 + 1.4 * (np.arange(9) / 8))
        with netCDF4.Dataset(folder / "result.nc") as file, xarray.open_dataset(folder / "result.nc") as data:
            file.set_auto_mask(False)
            self.assertEqual(set(file.variables), set(store))
            for name in store:
                np.testing.assert_array_equal(file[name][:], store[name][:])
            xarray.testing.assert_identical(data.load(), xarray.open_zarr(folder / "result.zarr").load())

    def test_samples(self):
        """another seed gives other samples, and the first samples of Sobol's sequence are those of a longer study"""
        def drawn(method, count, seed):
            return _study.drawn_of({"method": method, "count": count, "seed": seed, "variables": [
                {"quantity": "mu", "uniform": {"from": 1, "to": 2}}, {"quantity": "zeta", "uniform": {"from": 1, "to": 2}}]})

        for method in ("sobol", "latin_hypercube"):
            one, same, other = drawn(method, 64, 7), drawn(method, 64, 7), drawn(method, 64, 8)
            np.testing.assert_array_equal(one["mu"], same["mu"])
            self.assertFalse(np.array_equal(one["mu"], other["mu"]))
            self.assertFalse(np.array_equal(one["mu"], one["zeta"]))
            for values in one.values():  # one in each of 64 parts
                self.assertEqual(sorted(np.floor(64 * (values - 1)).astype(int)), list(range(64)))
        np.testing.assert_array_equal(drawn("sobol", 300, 7)["zeta"][:64], drawn("sobol", 64, 7)["zeta"])

    def test_distributions(self):
        """samples have the mean and the deviation that their distribution says, and stay within its bounds"""
        def moments(**distribution):
            x = _study.drawn_of({"method": "sobol", "count": 2**14, "seed": 4, "variables": [{"quantity": "r", **distribution}]})["r"]
            return x.mean(), x.std(), x.min(), x.max()

        np.testing.assert_allclose(moments(uniform={"from": 2, "to": 5})[:2], [3.5, 3 / 12**0.5], rtol=1e-3)
        np.testing.assert_allclose(moments(normal={"mean": -1, "standard_deviation": 0.5})[:2], [-1, 0.5], rtol=1e-3)
        np.testing.assert_allclose(moments(lognormal={"mean": 0.02, "standard_deviation": 0.008})[:2], [0.02, 0.008], rtol=1e-2)
        np.testing.assert_allclose(moments(lognormal={"median": 2, "log_standard_deviation": 0.1})[0], 2 * np.exp(0.005), rtol=1e-3)
        mean, _, least, _ = moments(normal={"mean": 0, "standard_deviation": 1, "from": 0})
        np.testing.assert_allclose(mean, (2 / np.pi)**0.5, rtol=1e-3)
        self.assertGreaterEqual(least, 0)
        mean, _, least, most = moments(loguniform={"from": 0.1, "to": 10})
        np.testing.assert_allclose(mean, 9.9 / np.log(100), rtol=1e-3)
        self.assertTrue(0.1 <= least and most <= 10)
        _, _, least, most = moments(lognormal={"median": 1, "log_standard_deviation": 1, "from": 0.5, "to": 1.5})
        self.assertTrue(0.5 <= least < 0.501 and 1.499 < most <= 1.5)

    def test_chunks(self):
        """chunks have every point once, and no column of friction is split"""
        study = STUDY | {"axes": [*STUDY["axes"], {"quantity": "stiffness", "entry": 2, "values": [0.5, 0.75, 1]}],
                         "samples": REDUCED["samples"]}
        for points in (1, 7, 30, 100, 400, 10**4):
            plan = _study.plan_of(study | {"points_of_a_chunk": points})
            seen = np.zeros(plan.shape, int)
            for K in range(plan.chunks):
                part = plan.slices(K)
                seen[tuple(part.values())] += 1
                self.assertEqual(part["beta"], slice(0, 6))
            self.assertTrue((seen == 1).all())
            self.assertLessEqual(np.prod(plan.chunk), max(points, 6))
        band = {"name": "band", "statistic": "quantiles", "of": "amplitude_2", "over": ["sample"], "probabilities": [0.5]}
        self.assertEqual(_study.plan_of(study | {"reduce": [band]}).boxes[1], 1)
        bins = {"bins": {"from": 0, "to": 1, "count": 10}}
        self.assertGreater(_study.plan_of(study | {"reduce": [band | bins]}).boxes[1], 1)

    def test_effort(self):
        """the work allowed for a point is that of the study"""
        data = sweep.dataset(STUDY | {"effort": 1}).compute()
        self.assertTrue((data.status.values[data.regime == -1] >= 2).all())
        self.assertGreater(int((data.regime == -1).sum()), 0)

    def test_rules(self):
        """every rule of a study refuses what breaks it by name, rule and value"""
        axes, samples, band, edges = ["axes", 0], ["samples", "variables"], ["reduce", 6], ["reduce", 3, "bins"]
        study = json.loads(json.dumps(REDUCED | {"comment": "a study"}))
        study["axes"].append({"quantity": "mass", "entry": 2, "as": "factor", "values": [0.5, 1]})
        _study.plan_of(study)
        for path, value, told in (
                (["scene"], None, "scene must be given, but is nothing"), (["axis"], 1, "did you mean axes?"),
                (["axes"], [], "axes must have at least 1 entry, but is []"), ([*axes, "steps"], 1, 'given "steps" (at /axes/0)'),
                ([*axes, "quantity"], "omega", 'quantity must be one of r, frequency_hz, beta'), ([*axes, "count"], 0, "count must be at least 1, but is 0"),
                ([*axes, "count"], 1.5, "count must be of the type integer, but is 1.5"), ([*axes, "scale"], "cubic", "linear, logarithmic"),
                ([*axes, "values"], [1], "axes must keep the rule: An axis has `values`, or"), (["axes", 1, "from"], -1, "beta must be zero or positive, and finite, but is -1"),
                ([*axes, "from"], 0, "r must be positive and finite, but is 0"), ([*axes, "to"], 0, "`to` not below `from`"),
                ([*axes, "to"], 10**400, "r must have numbers that a double holds"),
                ([*axes, "count"], 1, "`to` equal to `from` where count is 1"), ([*axes, "entry"], 2, "an entry of zeta, mass, stiffness only"),
                ([*axes, "as"], "factor", "r_factor must be drawn, as a factor of the axis r"),
                (["axes", 1, "quantity"], "friction", "must not be given together with friction or frequency_hz"),
                (["axes", 1, "quantity"], "r", "r must vary once"), (["axes", 2, "entry"], 3, "must be one of 2 entries, but is 3"),
                (["axes", 2, "values"], [-1], "mass"), (["axes", 2, "as"], "sum", "value, factor"),
                (["axes", 2], {"quantity": "contact", "values": [1.5]}, "whole numbers that count the masses"),
                (["axes", 2], {"quantity": "load", "values": [3]}, "load"),
                (["axes", 1], {"quantity": "mu", "values": [1]}, "beta must be an axis or a variable that is drawn"),
                (["samples", "method"], "halton", "sobol, latin_hypercube"), (["samples", "count"], 0, "count"),
                (["samples", "count"], 2**24 + 1, "count must be at most 16777216"), (["samples", "seed"], -1, "seed must be at least 0"),
                (["samples", "seed"], None, "seed must be given"), ([*samples], [], "variables"),
                ([*samples, 0, "uniform"], {"from": 0, "to": 1}, "variables"), ([*samples, 0, "lognormal"], None, "variables"),
                ([*samples, 0, "lognormal", "mean"], 1, "lognormal"), ([*samples, 0, "lognormal", "median"], 0, "median must be above 0"),
                ([*samples, 1, "uniform", "to"], 0.5, "beta_factor must have `to` above `from`"),
                ([*samples, 0], {"quantity": "load", "uniform": {"from": 1, "to": 2}}, "load must be an axis, but is a variable"),
                ([*samples, 0], {"quantity": "mu", "uniform": {"from": 0.1, "to": 0.5}}, "mu must be at least 1"),
                (["answers"], ["velocity"], "answers"), (["masses"], [0], "masses"), (["masses"], [1, 3], "masses from 1 to 2, but is 3"),
                (["masses"], [1, 1], "different masses"), (["start"], "fast", "rest, sliding"), (["effort"], 0, "effort must be at least 1"),
                (["reduce", 0, "statistic"], "mean", "share, maximum"), (["reduce", 0, "of"], "amplitude_1", "A share has no `of`"),
                (["reduce", 0, "over"], [], "over"), (["reduce", 0, "over"], ["time"], "regimes must be over different axes of"),
                (["reduce", 1, "over"], ["r", "r"], "peak must be over different axes"), (["reduce", 0, "name"], "a-b", "name must match"),
                (["reduce", 0, "name"], "peak", "a name of its own, but is peak"), (["reduce", 1, "of"], "amplitude_9", "peak must be of one of"),
                ([*band, "probabilities"], None, "probabilities must be given"), ([*band, "probabilities"], [1.5], "must be at most 1"),
                (edges, None, "bins must be given"), ([*edges, "from"], 0, "counts must have a positive `from`"),
                ([*edges, "to"], 0.001, "`to` is above their `from`"), (["points_of_a_chunk"], 0, "points_of_a_chunk"),
                (["scene", "mu"], 0.5, "mu must be at least 1")):
            with self.subTest(path=path, value=value):
                broken = copy.deepcopy(study)
                inner = broken
                for step in path[:-1]:
                    inner = inner[step]
                if value is None:
                    del inner[path[-1]]
                else:
                    inner[path[-1]] = value
                err = self.assert_refused(told, "plan", "-", self.scratch / "broken", text=json.dumps(broken))
                self.assertNotIn("\n", err[:-1])
        self.assertFalse((self.scratch / "broken").exists())
        for text, told in (('{"scene": {}, "scene": {}}', "given twice"), ('{"scene": NaN}', "NaN"), ("[" * 100000, "nested"), ("[]", "object")):
            self.assertIn(told, self.called("plan", "-", self.scratch / "broken", text=text)[2])
        huge = {"axes": [STUDY["axes"][0], {"quantity": "beta", "from": 0, "to": 1, "count": 10**7}], "reduce": [
            {"name": "band", "statistic": "quantiles", "of": "amplitude_2", "over": ["r"], "probabilities": [0.5]}]}
        with self.assertRaisesRegex(InputError, "more than 16777216 points together"):
            _study.plan_of(STUDY | huge)

    def test_documented(self):
        """the studies of the documentation keep the schema, and the schema is one"""
        schema = _study._schema()
        jsonschema.Draft202012Validator.check_schema(schema)
        documented = sorted((SOURCE / "docs").glob("study_*.json"))
        self.assertGreater(len(documented), 1)
        for path in documented:
            _study.plan_of(_study.read(path.read_text()))


if __name__ == "__main__":
    unittest.main()
