"""Tests the Python package against the command line program: python3 -m unittest test_denhartog, or pytest.

The environment names what is tested: DENHARTOG_PROGRAM the program, DENHARTOG_SOURCE the folder of the sources, DENHARTOG_LIBRARY
the shared library where the package has none of its own.
"""
import json
import math
import os
import pathlib
import pickle
import signal
import subprocess
import tempfile
import threading
import unittest
import warnings
from decimal import Decimal

import numpy as np

import denhartog
from denhartog import System

PROGRAM = os.environ["DENHARTOG_PROGRAM"]
SOURCE = pathlib.Path(os.environ["DENHARTOG_SOURCE"]).resolve()
DOCS = SOURCE / "docs"
NAMES = ("example", "example_dimensional", "example_dashpots", "example_stick_slip", "example_quarter_car", "example_isolator")
CHAIN = dict(mass_ratios=[1, 2.5, 0.75], stiffness_ratios=[1, 0.625, 1.875], damping_ratios=[0.03, 0.06, 0.09], contact=2, load=1)


def told(*arguments, scene=None):
    """What the program prints, of a scene on its standard input if there is one."""
    return subprocess.run([PROGRAM, *map(str, arguments)], input=json.dumps(scene), capture_output=True, text=True, check=True).stdout


def answer(scene, *arguments):
    """What the program answers about a scene, or the file of one."""
    return json.loads(told(*arguments, "--json", scene=scene) if isinstance(scene, dict) else told(*arguments, "--json", scene))


def mapped(name, *arguments):
    """The map of a scene that the program writes."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "map.npy")
        told("map", scene_file(name), *arguments, "--output", path)
        return np.load(path)


def scene_file(name):
    return DOCS / f"{name}.json"


class AgainstTheProgram(unittest.TestCase):
    def test_the_schema_of_studies_is_in_the_package(self):
        from denhartog import _study
        self.assertIn("axes", _study._schema()["properties"])

    def test_a_solution_is_what_solve_tells(self):
        for name in NAMES:
            with self.subTest(name):
                system, true = System.from_scene(scene_file(name)), answer(scene_file(name), "solve")
                found = system.solve(true["r"], true["beta"])
                self.assertEqual(found.regime, true["regime"])
                self.assertEqual(found.unique, true["unique"])
                self.assertEqual((found.periods, found.symmetric), (true["periods"], true["symmetric"]))
                np.testing.assert_array_equal(found.amplitude, [m["amplitude"] for m in true["masses"]])
                np.testing.assert_array_equal(found.phase, [m["phase"] for m in true["masses"]])
                np.testing.assert_array_equal(found.amplitude_error, [m["error_bound"] for m in true["masses"]])
                stops = [[stop["start"], stop["end"]] for stop in true.get("stops", [])]
                np.testing.assert_array_equal(found.stops, np.array(stops).reshape(-1, 2))
                errors = [[stop["start_error_bound"], stop["end_error_bound"]] for stop in true.get("stops", [])]
                np.testing.assert_array_equal(found.stop_errors, np.array(errors).reshape(-1, 2))

    def test_a_map_is_that_of_map_to_the_last_bit(self):
        for name, masses in (("example", [2]), ("example_dimensional", [2, 3]), ("example_stick_slip", [1])):
            for start in ("rest", "sliding"):
                with self.subTest(name, start=start):
                    chosen = [word for k in masses for word in ("--mass", k)]
                    true = mapped(name, "--r", "0.3:1.5:25", "--beta", "0.05:1.2:12", "--start", start, *chosen)
                    found = System.from_scene(scene_file(name)).map(true["r"][:, 0], true["beta"][0], masses, start)
                    for field, there in (("regime", "regime"), ("stops", "stops_per_period"), ("periods", "periods"),
                                         ("status", "status")):
                        np.testing.assert_array_equal(getattr(found, field), true[there])
                    for n, k in enumerate(masses):
                        np.testing.assert_array_equal(found.amplitude[:, :, n], true[f"amplitude_{k}"])

    def test_a_map_has_the_phases_and_absolute_displacements_of_the_program(self):
        for name, ground in (("example", False), ("example_quarter_car", True), ("example_lever", False)):
            with self.subTest(name):
                true = mapped(name, "--r", "0.3:1.5:5", "--beta", "0.05:1.2:4", "--mass", 2, "--phases",
                              *(["--from-ground"] if ground else []))
                found = System.from_scene(scene_file(name)).map(true["r"][:, 0], true["beta"][0], 2, phases=True, from_ground=ground)
                np.testing.assert_array_equal(found.amplitude[:, :, 0], true["amplitude_2"])
                np.testing.assert_array_equal(found.phase[:, :, 0], true["phase_2"])
        self.assertIsNone(System(**CHAIN).map([1], [0.1]).phase)
        for start, what in (("rest", {"from_ground": True}), ("sliding", {"phases": True})):
            with self.assertRaises(denhartog.InputError):
                System(**CHAIN, mu=1.375).map([1], [0.1], start=start, **what)

    def test_a_contact_may_have_any_direction(self):
        true = answer(scene_file("example_lever"), "solve")
        system = System.from_scene(scene_file("example_lever"))
        found = system.solve(true["r"], true["beta"])
        np.testing.assert_array_equal(found.amplitude, [m["amplitude"] for m in true["masses"]])
        self.assertEqual((found.contact_amplitude, found.contact_phase), (true["contact"]["amplitude"], true["contact"]["phase"]))
        self.assertEqual(system.contact, {"direction": true["contact"]["direction"]})
        self.assertIn("contact along [-0.5, 1, 0]", repr(system))
        same = System(masses=[20, 12, 8], stiffnesses=[9000, 6000, 4000], damping_ratios=0.02, load=3,
                      contact={"direction": np.array([-0.5, 1, 0])})
        self.assertEqual(same.solve(true["r"], true["beta"]).contact_amplitude, found.contact_amplitude)
        tau, x, _ = found.motion(64)
        self.assertLessEqual(np.abs(x @ [-0.5, 1, 0]).max(), found.contact_amplitude * (1 + 1e-12))
        for direction, part in (([1, 2], "must have as many values"), ([0, 0, 0], "not zero")):
            with self.assertRaisesRegex(denhartog.InputError, part):
                System(**{**CHAIN, "contact": {"direction": direction}})

    def test_an_answer_has_the_warning_of_the_program(self):
        scene = {"mass_ratios": 1, "stiffness_ratios": 1, "damping_ratios": 0, "contact": 1, "load": 1, "r": 1 - 2**-45, "beta": 0.125}
        true = answer(scene, "solve")
        self.assertIn("a unit in the last place", true["warning"])
        self.assertEqual(System.from_scene(scene).solve(scene["r"], scene["beta"]).warning, true["warning"])
        self.assertEqual(System(**CHAIN).solve(1.125, 0.1).warning, "")

    def test_a_proved_solution_is_what_solve_tells_with_proved(self):
        for name in NAMES:
            with self.subTest(name):
                system, plain = System.from_scene(scene_file(name)), answer(scene_file(name), "solve")
                r, beta, path = plain["r"], plain["beta"], scene_file(name)
                true = answer(path, "solve", "--proved")
                found, other = system.solve(r, beta, proved=True), system.solve(r, beta)
                self.assertIs(true["method"]["proved"], True)
                self.assertIs(found.proved, True)
                self.assertIs(other.proved, False)
                self.assertEqual((found.regime, found.unique, len(found.stops)), (true["regime"], other.unique, len(other.stops)))
                # The program has r and beta of the scene's own units to all digits.
                np.testing.assert_allclose(found.amplitude, [m["amplitude"] for m in true["masses"]], rtol=1e-12)
                self.assertTrue((np.abs(found.amplitude - other.amplitude) <= found.amplitude_error + other.amplitude_error).all())
                self.assertTrue((np.abs(found.phase - other.phase) <= found.phase_error + other.phase_error).all())
                self.assertTrue((np.abs(found.stops - other.stops) <= found.stop_errors + other.stop_errors).all())
                self.assertTrue((found.amplitude_error <= 1e-15 * found.amplitude.max()).all())
                limits, others = system.boundary(r, proved=True), system.boundary(r)
                self.assertEqual((limits.proved, others.proved, len(limits)), (True, False, 4))
                for each in zip(limits, limits.errors, others, others.errors):
                    self.assertLessEqual(abs(each[0] - each[2]), each[1] + each[3])

    def test_boundaries_are_those_of_boundary(self):
        for name in NAMES:
            with self.subTest(name):
                true = answer(scene_file(name), "boundary")
                found = System.from_scene(scene_file(name)).boundary(true["r"])
                for kind in ("exact", "paper", "approximate", "sticking"):
                    self.assertAlmostEqual(getattr(found, kind) / true["beta_lim"][kind], 1, delta=1e-12)

    def test_bounds_are_those_of_boundary_and_functions(self):
        for name in NAMES:
            with self.subTest(name):
                system = System.from_scene(scene_file(name))
                true = answer(scene_file(name), "boundary", "--digits", 10)
                limits = system.boundary(true["r"])
                for kind in ("exact", "paper", "approximate", "sticking"):
                    bound, theirs = getattr(limits.errors, kind), true["beta_lim_error_bounds"][kind]
                    self.assertTrue(theirs / 4 <= bound <= 4 * theirs, (kind, bound, theirs))
                self.assertEqual(len(limits), 4)
                if name == "example_dashpots":  # its damping couples the modes: there are no functions of a mode
                    continue
                true = answer(scene_file(name), "functions")
                sums, modes = system.functions(true["modes"][0]["R"] * true["modes"][0]["natural_frequency_ratio"]), true["modes"]
                np.testing.assert_array_equal(system.natural_frequency_ratio_errors,
                                              [m["error_bounds"]["natural_frequency_ratio"] for m in modes])
                np.testing.assert_array_equal(system.damping_ratio_errors, [m["error_bounds"]["zeta"] for m in modes])
                for found, theirs in ((sums.errors.U, "U"), (sums.errors.G, "G"), (np.abs(sums.errors.V), "V")):
                    bounds = [m["error_bounds"][theirs] for m in true["masses"]]
                    self.assertTrue((0 < found).all() and (found < 10 * np.array(bounds)).all())
                self.assertEqual(len(sums), 5)
                copied = pickle.loads(pickle.dumps(sums))
                np.testing.assert_array_equal(copied.errors.V, sums.errors.V)

    def test_motions_are_those_of_solve(self):
        for name in NAMES:
            with self.subTest(name):
                at = answer(scene_file(name), "solve")
                rows = told("solve", "--samples", 32, scene_file(name)).splitlines()
                true = np.array([[float(x) for x in row.split(",")] for row in rows[1:]])
                tau, x, x_prime = System.from_scene(scene_file(name)).motion(at["r"], at["beta"], samples=32)
                found = np.column_stack([tau, x, x_prime])
                np.testing.assert_allclose(found, true, rtol=1e-9, atol=1e-9 * np.abs(true).max())

    def test_own_units_are_those_of_the_scene(self):
        system, true = System.from_scene(scene_file("example_dimensional")), answer(scene_file("example_dimensional"), "solve")
        own, scene = true["dimensional"], system.scene
        force = system.base_force(scene["base_displacement"], hz=scene["frequency_hz"])
        self.assertAlmostEqual(force / own["force"], 1, delta=1e-15)
        r = system.frequency_ratio(hz=2.6)
        self.assertAlmostEqual(r / true["r"], 1, delta=1e-15)
        self.assertEqual(system.frequency_ratio(own["frequency"]), r)
        beta = system.friction_ratio(6.5, force)
        self.assertAlmostEqual(beta / true["beta"], 1, delta=1e-15)
        found = system.solve(r, beta).amplitude * system.displacement_unit(force)
        np.testing.assert_allclose(found, [m["amplitude"] for m in own["masses"]], rtol=1e-12)
        np.testing.assert_allclose(system.natural_frequencies, system.natural_frequency_ratios * np.sqrt(18500 / 12), rtol=1e-15)

    def test_energies_are_those_of_the_program(self):
        for name in ("example", "example_dimensional", "example_quarter_car"):
            with self.subTest(name):
                true = answer(scene_file(name), "solve", "--energy", "--digits", 12)
                found = System.from_scene(scene_file(name)).solve(true["r"], true["beta"], digits=12).energies(12)
                energy = {**true["energy"], **{f"textbook_{key}": x for key, x in true["energy"]["textbook"].items()}}
                for key in found._fields:
                    self.assertAlmostEqual(getattr(found, key), energy[key], delta=1e-9 * max(1, abs(energy[key])))
                    self.assertLess(getattr(found.errors, key), 1e-8 * max(1, abs(energy[key])))
        resting = System(**CHAIN).solve(1.125, 100).energies()
        self.assertTrue(math.isnan(resting.equivalent_damping) and resting.contact == 0)
        with self.assertRaisesRegex(denhartog.InputError, "digits must"):
            System(**CHAIN).solve(1.125, 0.1).energies(16)

    def test_a_motion_from_a_start_is_that_of_the_program(self):
        scene = json.loads(pathlib.Path(scene_file("free_decay")).read_text())
        true = answer(scene_file("free_decay"), "integrate", "--start", "0.02,0")
        m, k, F = scene["masses"][0], scene["stiffnesses"][0], scene["friction"]
        system = System(masses=scene["masses"], stiffnesses=scene["stiffnesses"], damping_ratios=scene["damping_ratios"],
                        contact=scene["contact"], load=1)
        found = system.free_decay(F / k, [0.02])
        omega = math.sqrt(k / m)
        self.assertTrue(found.at_rest)
        np.testing.assert_allclose(found.turns[:, 0] / omega, [turn["t"] for turn in true["turns"]], rtol=1e-12)
        np.testing.assert_allclose(found.turns[:, 1], [turn["x"] for turn in true["turns"]], rtol=1e-10, atol=1e-14)
        self.assertAlmostEqual(found.rest_at, true["rest"]["x"], delta=1e-12)
        self.assertTrue((found.turn_errors < 1e-9).all())
        self.assertEqual(len(system.free_decay(F / k, [0.02], until=4.0).turns), 1)
        past = system.history(1, F / k, 3, [0.02], samples=8, load=False)
        self.assertEqual(past.x.shape, (24, 1))
        self.assertEqual(past.x[0, 0], 0.02)
        loaded = {**CHAIN, "static_load": [1, 0, 0], "r": 1.125, "beta": 0.15625}
        x, error = System.from_scene(loaded).place_of_rest()
        true = answer(loaded, "solve")["place_of_rest"]
        np.testing.assert_allclose(x, [place["x"] for place in true], rtol=1e-12)
        self.assertTrue((error < 1e-12).all())
        forced = System(**CHAIN).history(1.125, 0.15625, 5, last=2, samples=4)
        of_program = answer({**CHAIN, "r": 1.125, "beta": 0.15625}, "integrate", "--cycles", "5", "--history", "2")["history"]
        np.testing.assert_allclose(forced.stops[:, 0], [stop["start"] for stop in of_program["stops"]], rtol=1e-9)
        for wrong in (lambda: system.free_decay(-1, [0.02]), lambda: system.free_decay(1e-3, [1, 2]),
                      lambda: system.free_decay(1e-3, [1], until=-1), lambda: system.history(1, 0.1, 3, last=4),
                      lambda: system.history(1, 0.1, 0)):
            self.assertRaises(denhartog.InputError, wrong)

    def test_any_quantity_has_its_name(self):
        system, r, beta = System(**CHAIN), 1.125, 0.15625
        motion, functions = system.solve(r, beta, digits=12), system.functions(r)
        for k in (1, 2, 3):
            for name, true in (("amplitude", motion.amplitude[k - 1]), ("phase", motion.phase[k - 1]),
                               ("first_damping_function", functions.U[k - 1])):
                (value,), (error,) = system.quantity(name, r, beta, mass=k)
                self.assertLess(abs(value - true), error + 1e-10)
                self.assertLess(error, 1e-8)
        x, errors = system.quantity("motion_under_force", r, beta, mass=2, samples=8)
        np.testing.assert_allclose(x, motion.motion(8).x[:, 1], atol=1e-9)
        self.assertEqual(errors.shape, (8,))
        self.assertEqual(system.quantity("regime", r, 100)[0][0], 2)
        self.assertRaises(denhartog.DomainError, system.quantity, "speed", r)
        self.assertRaises(denhartog.DomainError, system.quantity, "transmissibility", r, beta)
        car = System.from_scene(scene_file("example_quarter_car"))
        seen = car.solve(r, beta, digits=12).from_ground
        for k in range(car.N):
            for name, true in (("absolute_amplitude", seen.amplitude), ("absolute_phase", seen.phase), ("transmissibility", seen.transmissibility)):
                self.assertLess(abs(car.quantity(name, r, beta, mass=k + 1)[0][0] - true[k]), 1e-10)
        for wrong in (dict(mass=4), dict(mass=-1), dict(samples=0), dict(mu=0.5)):
            self.assertRaises(denhartog.InputError, system.quantity, "amplitude", r, beta, **wrong)

    def test_absolute_displacements_are_those_of_the_program(self):
        for name in ("example_dimensional", "example_quarter_car", "example_isolator"):
            with self.subTest(name):
                true = answer(scene_file(name), "solve")
                system = System.from_scene(scene_file(name))
                found = system.solve(true["r"], true["beta"]).from_ground
                for key in ("amplitude", "transmissibility", "phase"):
                    expected = [m[key] for m in true["from_ground"]["masses"]]
                    np.testing.assert_allclose(getattr(found, key), expected, rtol=1e-9, atol=1e-9)
                    self.assertTrue((getattr(found, f"{key}_error") >= 0).all())
                many = system.solve([true["r"]], true["beta"], from_ground=True)
                np.testing.assert_array_equal(many.amplitude[0], found.amplitude)
                np.testing.assert_array_equal(many.phase[0], found.phase)
        with self.assertRaisesRegex(denhartog.InputError, "from_ground must be 0"):
            System(**CHAIN).solve([1.125], 0.1, from_ground=True)
        self.assertIsNone(System(**CHAIN).solve(1.125, 0.1).from_ground)
        system = System.from_scene(scene_file("example_isolator"))
        force = answer(scene_file("example_isolator"), "solve")["dimensional"]["force"]
        self.assertAlmostEqual(system.base_force(acceleration=0.5) / force, 1, delta=1e-15)
        car = System.from_scene(scene_file("example_quarter_car"))
        self.assertAlmostEqual(car.base_force(acceleration=0.5, omega=10) / car.base_force(0.005), 1, delta=1e-15)
        with self.assertRaisesRegex(denhartog.InputError, "displacement must be given, or acceleration"):
            car.base_force()

    def test_forces_may_be_out_of_phase(self):
        load = {**CHAIN, "load": [1, 0.5, 0.25], "load_phases": [0, 1.25, -2]}
        true = answer({**load, "r": 1.125, "beta": 0.05}, "solve")
        found = System(**load).solve(1.125, 0.05)
        np.testing.assert_allclose(found.amplitude, [m["amplitude"] for m in true["masses"]], rtol=1e-12)
        np.testing.assert_allclose(found.phase, [m["phase"] for m in true["masses"]], rtol=0, atol=1e-12)
        with self.assertRaisesRegex(denhartog.InputError, "load_phases must have as many values"):
            System(**{**load, "load_phases": [0, 1]})


class InPython(unittest.TestCase):
    def test_arrays_have_what_scalars_have(self):
        system = System(**CHAIN, mu=1.375)
        r, beta = np.array([0.5, 1.125, 1.75]), np.array([[0.05], [0.4], [1.5]])
        found = system.solve(r, beta, digits=8)
        self.assertEqual(found.amplitude.shape, (3, 3, 3))
        self.assertTrue({0, 1, 2} >= set(found.regime.ravel().tolist()))
        for at in np.ndindex(3, 3):
            one = system.solve(found.r[at], found.beta[at], digits=8)
            self.assertEqual(one.regime, found.regime_names[found.regime[at]])
            self.assertEqual((len(one.stops), one.periods), (found.stops[at], found.periods[at]))
            np.testing.assert_allclose(found.amplitude[at], one.amplitude, rtol=1e-8, atol=1e-12)
            np.testing.assert_allclose(found.phase[at], one.phase, rtol=0, atol=1e-8)
        np.testing.assert_array_equal(system.solve(r, 0.05, masses=2).amplitude.shape, (3, 1))
        for digits in (8.0, np.int8(8), np.array(8), Decimal(8)):
            self.assertEqual(system.solve(r, 0.05, digits=digits).amplitude.tolist(),
                             system.solve(r, 0.05, digits=8).amplitude.tolist())
        self.assertEqual(system.solve([], 0.1).regime.shape, (0,))

    def test_many_systems_are_solved_as_each_by_itself(self):
        one = System(mass_ratios=[1], stiffness_ratios=[1], damping_ratios=0.25, contact=1, load=1)
        two = System(mass_ratios=[1, 1], stiffness_ratios=[1, 1], damping_ratios=0.05, contact=2, load=1)
        systems, r, beta = [System(**CHAIN, mu=1.375), two, one], [1.125, 0.75, 0.5], [[0.0625], [0.4], [5]]
        found = denhartog.solve_many(systems, r, beta, digits=8)
        self.assertEqual((found.amplitude.shape, found.masses.tolist()), ((3, 3, 3), [1, 2, 3]))
        self.assertEqual(set(found.regime.ravel().tolist()), {0, 1, 2})
        for at in np.ndindex(3, 3):
            alone, N = systems[at[1]].solve(r[at[1]], beta[at[0]][0], digits=8), systems[at[1]].N
            self.assertEqual(alone.regime, found.regime_names[found.regime[at]])
            self.assertEqual((alone.mu, alone.periods, len(alone.stops)), (found.mu[at], found.periods[at], found.stops[at]))
            np.testing.assert_allclose(found.amplitude[at][:N], alone.amplitude, rtol=1e-8, atol=1e-12)
            np.testing.assert_allclose(found.phase[at][:N], alone.phase, rtol=0, atol=1e-8)
            self.assertTrue(np.isnan(found.amplitude[at][N:]).all() and np.isnan(found.phase_error[at][N:]).all())
        first = denhartog.solve_many(systems, r, beta, mu=1.0, masses=1, threads=1)
        self.assertEqual((first.amplitude.shape, first.mu.min(), first.mu.max()), ((3, 3, 1), 1, 1))
        np.testing.assert_array_equal(first.amplitude, denhartog.solve_many(systems, r, beta, mu=1.0, masses=1, threads=3).amplitude)
        self.assertEqual(denhartog.solve_many(two, 0.75, 0.4).amplitude.shape, (2,))
        self.assertEqual(denhartog.solve_many([], [], 0.4).amplitude.shape, (0, 0))
        with self.assertRaises(denhartog.Cancelled):
            denhartog.solve_many([two] * 5000, 0.75, 0.4, progress=lambda done, all: True)

    def test_the_numbers_do_not_depend_on_threads(self):
        system, r, beta = System(**CHAIN), np.linspace(0.3, 2, 40), np.linspace(0, 1, 20)
        one, three = (system.map(r, beta, threads=n) for n in (1, 3))
        np.testing.assert_array_equal(one.amplitude, three.amplitude)
        np.testing.assert_array_equal(one.where("stick_slip"), three.where("stick_slip"))

    def test_boundaries_and_functions_of_arrays(self):
        system, r = System(**CHAIN), np.array([[0.5, 1.125], [1.5, 2.5]])
        limits, sums = system.boundary(r), system.functions(r)
        self.assertEqual((limits.exact.shape, sums.V.shape, sums.H_j.shape), ((2, 2), (2, 2, 3), (2, 2)))
        for at in np.ndindex(2, 2):
            self.assertEqual(system.boundary(r[at]).exact, limits.exact[at])
            np.testing.assert_array_equal(system.functions(r[at]).V, sums.V[at])
        self.assertIsInstance(system.boundary(1.125).exact, float)
        undamped = System(mass_ratios=[1, 1], stiffness_ratios=[1, 1], damping_ratios=0, contact=2, load=1)
        self.assertTrue(np.isnan(undamped.boundary(np.sqrt(2)).sticking) or undamped.boundary(np.sqrt(2)).sticking > 1e10)

    def test_a_contact_between_two_masses(self):
        motion = System(**{**CHAIN, "contact": [3, 1]}).solve(1.125, 0.0625)
        between = motion.motion(2000).x @ [-1, 0, 1]
        self.assertAlmostEqual(motion.contact_amplitude, abs(between).max(), delta=1e-4 * motion.contact_amplitude)
        wall = System(**CHAIN).solve(1.125, 0.0625)
        self.assertEqual((wall.contact_amplitude, wall.contact_phase), (wall.amplitude[1], wall.phase[1]))
        self.assertEqual((wall.contact_amplitude_error, wall.contact_phase_error), (wall.amplitude_error[1], wall.phase_error[1]))

    def test_a_contact_at_rest(self):
        found = System(**CHAIN).solve(1.125, 5.0)
        self.assertEqual(found.regime, "permanent_sticking")
        self.assertEqual((found.amplitude[1], len(found.stops)), (0, 0))
        self.assertTrue(np.isnan(found.phase[1]))
        self.assertLess(found.rest_interval[0], found.rest_interval[1])

    def test_lists_arrays_and_matrices_are_the_same_system(self):
        listed = System(masses=[4, 10, 3], stiffnesses=[8, 5, 15], damping_ratios=0.05, contact=[2, 1], load=[1, 0.5, 0])
        k = np.array([[13.0, -5, 0], [-5, 20, -15], [0, -15, 15]])
        matrices = System(masses=np.diag([4.0, 10, 3]), stiffnesses=k, damping_ratios=np.full(3, 0.05), contact=(2, 1),
                          load=np.array([1, 0.5, 0]))
        np.testing.assert_allclose(listed.natural_frequencies, matrices.natural_frequencies, rtol=1e-13)
        ratios = System(mass_ratios=np.diag([1, 2.5, 0.75]), stiffness_ratios=k / 13, damping_ratios=0.05, contact=1, load=1)
        np.testing.assert_allclose(ratios.natural_frequency_ratios, matrices.natural_frequency_ratios, rtol=1e-13)
        self.assertEqual((matrices.k_1, matrices.m_1, matrices.contact), (13, 4, (2, 1)))

    def test_repr_and_copies(self):
        system = System(**CHAIN, mu=1.375)
        self.assertEqual(repr(system), "System(3 masses, contact on mass 2, load on mass 1, mu = 1.375, "
                                       "r_n = [0.334185, 1.29531, 1.82634])")
        copied = pickle.loads(pickle.dumps(system))
        self.assertEqual(copied.solve(1.125, 0.2).amplitude.tolist(), system.solve(1.125, 0.2).amplitude.tolist())
        self.assertIn("continuous at r = 1.125", repr(system.solve(1.125, 0.15625)))
        self.assertIn("masses [1, 2, 3]", repr(system.map([1, 1.5], [0.1, 3])))
        self.assertRegex(denhartog.__version__, r"^\d+\.\d+\.\d+$")

    def test_errors_name_quantity_rule_and_value(self):
        system = System(**CHAIN)
        for quantity, value, call in (
                ("beta", "-1", lambda: system.solve(1, -1)),
                ("r", "0", lambda: system.boundary(0)),
                ("mu", "0.5", lambda: system.solve(1, 1, mu=0.5)),
                ("masses", "-2", lambda: System(masses=[1, -2], stiffnesses=[1, 1], damping_ratios=0, contact=1, load=1)),
                ("damping_ratios", "-0.5", lambda: System(**{**CHAIN, "damping_ratios": [0.1, -0.5, 0]})),
                ("contact", "4", lambda: System(**{**CHAIN, "contact": 4})),
                ("masses", "4", lambda: system.map([1], [1], masses=4)),
                ("digits", "16", lambda: system.solve(1, 1, digits=16)),
                ("digits", "16", lambda: system.solve(1, 1, digits=16, proved=True)),
                ("proved", "True", lambda: system.solve([1, 2], 1, proved=True)),
                ("r", "0", lambda: system.boundary(0, proved=True)),
                ("regime", "sliding", lambda: system.map([1], [1]).where("sliding")),
                ("stiffness_ratios", "nan", lambda: System(**{**CHAIN, "stiffness_ratios": [1, np.nan, 1]})),
                ("beta", "(3,)", lambda: system.solve([1, 2], [1, 2, 3])),
                ("r", "'fast'", lambda: system.solve("fast", 1)),
                ("systems", "'chain'", lambda: denhartog.solve_many([system, "chain"], 1, 1)),
                ("r", "(3,)", lambda: denhartog.solve_many([system, system], [1, 2, 3], 1)),
                ("masses", "4", lambda: denhartog.solve_many([system], 1, 1, masses=4)),
                ("mu", "0.5", lambda: denhartog.solve_many([system], 1, 1, mu=0.5)),
                ("beta", "-2", lambda: denhartog.solve_many([system, system], 1, [1, -2])),
                ("r", "array([1.1+0.5j])", lambda: system.solve(np.array([1.1 + 0.5j]), 0.3)),
                ("r", "array(['2020-01-01'], dtype='datetime64[D]')", lambda: system.map(np.array(["2020-01-01"], "M8[D]"), 1)),
                ("beta", "['1', '2']", lambda: system.solve(1, ["1", "2"])),
                ("beta", "True", lambda: system.solve(1, True)),
                ("r", "[None, 1]", lambda: system.boundary([None, 1])),
                ("r", "an array with 1 of them", lambda: system.solve(np.ma.array([1, 2], mask=[0, 1]), 1)),
                ("beta", "[True, 0.5]", lambda: system.solve(1, [True, .5])),
                ("beta", "[array([ True]), [0.5]]", lambda: system.solve(1, [np.array([True]), [.5]])),
                ("r", "an array with 2 of them", lambda: system.solve([np.ma.array([1, 2], mask=[0, 1]), (1, np.ma.masked)], 1)),
                ("digits", "True", lambda: system.solve(1, 1, digits=True)),
                ("digits", "array([6])", lambda: system.solve(1, 1, digits=np.array([6]))),
                ("digits", "Decimal('6.5')", lambda: system.solve(1, 1, digits=Decimal("6.5"))),
                ("digits", "nan", lambda: system.solve(1, 1, digits=math.nan)),
                ("digits", "'6'", lambda: system.solve(1, 1, digits="6")),
                ("until", "'3'", lambda: system.free_decay(.1, [1, 0, 0], until="3")),
                ("cycles", "2.5", lambda: system.history(1, .1, 2.5)),
                ("last", "4", lambda: system.history(1, .1, 3, last=4)),
                ("samples", "-1", lambda: system.history(1, .1, 3, samples=-1)),
                ("digits", "12.5", lambda: system.solve(1, 1, digits=12.5)),
                ("digits", "6.5", lambda: system.solve(1.125, 0.1).energies(6.5)),
                ("threads", "2.5", lambda: system.map([1], [1], threads=2.5)),
                ("mu", "an array of shape (2,)", lambda: system.solve(1, 1, mu=np.array([1, 2]))),
                ("r", "an array of shape (2,)", lambda: system.history([1, 2], 1, 3)),
                ("beta", "'few'", lambda: system.free_decay("few", [1, 0, 0])),
                ("tau", "an array of shape (2,)", lambda: system.quantity("displacement", 1, 1, tau=[0, 1]))):
            with self.subTest(quantity=quantity, value=value), self.assertRaises(denhartog.InputError) as caught:
                call()
            fault = caught.exception
            self.assertIsInstance(fault, (denhartog.Error, ValueError))
            self.assertEqual((fault.quantity, fault.value), (quantity, value))
            self.assertTrue(fault.rule.startswith(("must", "of mode 2 must")), fault.rule)
        undamped = System(mass_ratios=[1], stiffness_ratios=[1], damping_ratios=0, contact=1, load=1)
        with self.assertRaises(denhartog.DomainError):
            undamped.functions(1.0)
        with self.assertRaises(denhartog.InputError):
            system.frequency_ratio(1.0)  # it has no units

    def test_a_map_of_many_points_can_be_followed_and_ended(self):
        system, steps = System(**CHAIN), []
        r, beta = np.linspace(0.2, 3, 500), np.linspace(0, 1, 200)
        found = system.map(r, beta, masses=system.contact, progress=lambda done, all: steps.append((done, all)))
        self.assertEqual(found.regime.size, 100000)
        self.assertEqual((steps[-1], steps), ((500, 500), sorted(steps)))
        self.assertTrue(np.isfinite(found.amplitude[found.status <= 1]).all())
        with self.assertRaises(denhartog.Cancelled):
            system.map(np.linspace(0.1, 3, 5000), beta, progress=lambda done, all: True)
        with self.assertRaises(denhartog.Cancelled):
            system.solve(np.linspace(0.1, 3, 100000), 0.3, progress=lambda done, all: True)
        with self.assertRaises(ZeroDivisionError):
            system.map(np.linspace(0.1, 3, 5000), beta, progress=lambda done, all: done // 0)

    def test_the_inverse_question(self):
        scene = {"mass_ratios": 1, "stiffness_ratios": 1, "damping_ratios": 0.1, "contact": 1, "load": 1, "r": 1, "beta": 0}
        found = denhartog.find(scene, "r", (0.05, 3), "amplitude of mass 1 = 2", samples=16)
        self.assertEqual([place.is_ for place in found.places], ["crossing", "crossing"])
        half = 1 - 2 * 0.1**2  # (1 - s)^2 + 4 zeta^2 s = 1 / 4 of s = r^2
        for place, sign in zip(found.places, (-1, 1)):
            root = math.sqrt(half + sign * math.sqrt(half**2 - 0.75))
            self.assertTrue(place.between[0] - 1e-15 <= root <= place.between[1] + 1e-15)
            self.assertLess(abs(place.amplitude - 2), 1e-13)
        self.assertEqual(found.unanswered, 0)
        self.assertEqual(denhartog.find(json.dumps(scene), "r", (0.05, 3), "amplitude of mass 1 = 2", samples=16), found)
        for part, call in (("between", lambda: denhartog.find(scene, "r", (1,), "amplitude of mass 1 = 2")),
                           ("between", lambda: denhartog.find(scene, "r", ("1", "2"), "amplitude of mass 1 = 2")),
                           ("samples", lambda: denhartog.find(scene, "r", (1, 2), "amplitude of mass 1 = 2", samples=1)),
                           ("samples", lambda: denhartog.find(scene, "r", (1, 2), "amplitude of mass 1 = 2", samples=2.5)),
                           ("vary", lambda: denhartog.find(scene, "omega", (1, 2), "amplitude of mass 1 = 2")),
                           ("so-that", lambda: denhartog.find(scene, "r", (1, 2), "phase of mass 1 = 2"))):
            with self.subTest(part), self.assertRaises(denhartog.InputError) as caught:
                call()
            self.assertIn(part, str(caught.exception))

    def test_an_interruption_ends_a_map(self):
        system = System(**CHAIN)
        # A process in the background of a shell ignores the interruption, and Python then leaves it so.
        self.addCleanup(signal.signal, signal.SIGINT, signal.signal(signal.SIGINT, signal.default_int_handler))
        threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT)).start()
        with self.assertRaises(KeyboardInterrupt):
            system.map(np.linspace(0.05, 3, 20000), np.linspace(0, 1, 500))


if __name__ == "__main__":
    warnings.simplefilter("error")
    unittest.main()
