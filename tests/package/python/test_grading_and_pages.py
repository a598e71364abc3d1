"""Tests what stands around the Python package: grading, the page, the examples, the figures. See test_denhartog.py."""
import doctest
import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import unittest.mock
import warnings

import numpy as np

import denhartog
from denhartog import System, conformance

PROGRAM = os.environ["DENHARTOG_PROGRAM"]
SOURCE = pathlib.Path(os.environ["DENHARTOG_SOURCE"]).resolve()
DOCS, EXAMPLES = SOURCE / "docs", SOURCE / "src" / "python" / "examples"
CHAIN = dict(mass_ratios=[1, 2.5, 0.75], stiffness_ratios=[1, 0.625, 1.875], damping_ratios=[0.03, 0.06, 0.09], contact=2, load=1)


def library_answers(question):
    """Boundaries and regimes by the package itself, with static friction left out."""
    scene = question["scene"]
    system = System.from_scene(scene)
    if question["quantity"] in ("beta_lim_exact", "beta_lim_approximate", "beta_lim_sticking"):
        return getattr(system.boundary(scene["r"], mu=1), question["quantity"].rpartition("_")[2])
    if question["quantity"] == "regime":
        return system.solve(scene["r"], scene["beta"], mu=1).regime
    return 1 / 0 if question["id"] == "boundary-0002" else None


def right_regimes(question):
    """The regime, and nothing else."""
    scene = question["scene"]
    return System.from_scene(scene).solve(scene["r"], scene["beta"]).regime if question["quantity"] == "regime" else None


class Grading(unittest.TestCase):
    def test_a_function_is_graded(self):
        report = conformance.run(library_answers, PROGRAM, group=["boundary", "reject"])
        self.assertFalse(report.conforms)
        self.assertGreater(report.counts["rejected"], 30)
        self.assertGreater(report.counts["skipped"], 0)
        self.assertEqual(report.diagnosis["findings"][0]["mistake"], "mu-ignored")
        self.assertIn("Does not conform.", str(report))
        self.assertIsInstance(next(iter(report.raised.values())), ZeroDivisionError)
        right = conformance.run(right_regimes, PROGRAM, filter="boundary-0[0-2]")
        self.assertTrue(right.conforms and right.counts["pass"] > 0)

    def test_what_is_missing_is_told(self):
        with self.assertRaisesRegex(denhartog.Error, "not found"):
            conformance.run(library_answers, "/nowhere/denhartog")
        with self.assertRaisesRegex(denhartog.Error, "vectors must be a folder"):
            conformance.run(library_answers, PROGRAM, vectors=EXAMPLES)

    @unittest.skipUnless(importlib.util.find_spec("pytest"), "pytest is not installed")
    def test_each_question_is_a_test_of_pytest(self):
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "mine.py").write_text(
                "def f(question):\n    return 0.5 if question['quantity'] == 'beta_lim_exact' else None\n", encoding="utf-8")
            installed = pathlib.Path(denhartog.__file__).with_name("libdenhartog.so.0").exists()  # then pytest finds the plugin
            done = subprocess.run(
                [sys.executable, "-m", "pytest", "-q", *([] if installed else ["-p", "denhartog.pytest_plugin"]), "-p",
                 "no:cacheprovider", "--denhartog-function=mine:f", "--denhartog-filter=^boundary-000"], cwd=folder, text=True,
                env={**os.environ, "PYTHONPATH": os.pathsep.join([folder, *sys.path])}, stdout=subprocess.PIPE, check=False)
        self.assertRegex(done.stdout, r"\d+ failed, .*\d* skipped", done.stdout)
        self.assertIn("Diagnosis (", done.stdout)


class Documentation(unittest.TestCase):
    def test_the_page_shows_what_is_printed(self):
        page = (DOCS / "python.md").read_text(encoding="utf-8")
        text = "\n".join("" if line.startswith("```") else line for line in page.splitlines()) + "\n"
        self.check(doctest.DocTestParser().get_doctest(text, {}, "python.md", "docs/python.md", 0))

    def test_the_examples_of_the_docstrings(self):
        for module in (denhartog, sys.modules["denhartog._system"]):
            for example in doctest.DocTestFinder().find(module):
                self.check(example)

    def check(self, example):
        folder, output = os.getcwd(), []
        os.chdir(DOCS)
        try:
            runner = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE)
            runner.run(example, out=output.append)
        finally:
            os.chdir(folder)
        self.assertEqual(runner.failures, 0, "".join(output))

    @unittest.skipUnless(importlib.util.find_spec("matplotlib"), "matplotlib is not installed")
    def test_the_examples_draw(self):
        with tempfile.TemporaryDirectory() as folder:
            for script, names in (("figures_of_the_paper", ["6.png", "10.svg"]), ("measured_system", ["m.png"]),
                                  ("grade_my_solver", ["g.svg"])):
                files = [pathlib.Path(folder, name) for name in names]
                subprocess.run([sys.executable, EXAMPLES / f"{script}.py", *files], check=True, stdout=subprocess.DEVNULL)
                self.assertTrue(all(file.stat().st_size > 1000 for file in files))

    @unittest.skipUnless(importlib.util.find_spec("matplotlib"), "matplotlib is not installed")
    def test_plots(self):
        import matplotlib
        matplotlib.use("Agg")
        system = System(**CHAIN)
        self.assertEqual(len(system.plot_response(np.linspace(0.3, 2, 30), [0.1, 0.4], mass=1)), 2)
        self.assertEqual(system.plot_regimes(np.linspace(0.3, 2, 30)).get_xlabel(), "$r$")
        self.assertEqual(len(system.plot_motion(0.8, 0.6).get_lines()), 3)
        matplotlib.pyplot.close("all")

    def test_a_missing_matplotlib_is_told(self):
        with unittest.mock.patch.dict(sys.modules, {"matplotlib": None}), \
                self.assertRaisesRegex(ImportError, "matplotlib is needed"):
            System(**CHAIN).plot_motion(0.8, 0.6)


if __name__ == "__main__":
    warnings.simplefilter("error")
    unittest.main()
