"""Checks scenes against docs/scene.schema.json: with_jsonschema.py PROGRAM SOURCE. Ends with status 77 where the validator is missing."""
import json
import subprocess
import sys
import unittest
from pathlib import Path

try:
    from jsonschema import Draft202012Validator
except ImportError:
    print("skipped: python3-jsonschema is missing")
    sys.exit(77)

SOURCE = Path(sys.argv.pop())
PROGRAM = sys.argv.pop()
SCHEMA = json.loads((SOURCE / "docs/scene.schema.json").read_text())
CHAIN = json.loads((SOURCE / "docs/example.json").read_text())
COEFFICIENTS = {"masses": [1, 2], "stiffnesses": [2, 1], "damping_ratios": 0.01, "contact": 1, "load": 2, "frequency_hz": 0.2,
                "force": 1, "normal_force": 0.5, "friction_coefficient": 0.2, "static_friction_coefficient": 0.25}
# What the schema refuses has to be refused by the program too.
BROKEN = [
    {**CHAIN, "mu": 0.5},
    {**CHAIN, "r": 0},
    {**CHAIN, "beta": -1},
    {**CHAIN, "contact": 0},
    {**CHAIN, "contact": [1, 2, 3]},
    {**CHAIN, "contact": {"direction": []}},
    {**CHAIN, "contact": {"mass": 2}},
    {**CHAIN, "contact": {"direction": [1, 2, 3], "mass": 2}},
    {**CHAIN, "damping_tolerance": 3, "damping_matrix": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]},
    {**CHAIN, "friction": 1},
    {**CHAIN, "no_such_key": 1},
    {**CHAIN, "static_load": ["weight", 0, 0]},
    {**CHAIN, "normal_force": 1, "friction_coefficient": 1},
    {**COEFFICIENTS, "friction": 0.1},
    {**COEFFICIENTS, "mu": 1.2},
    {**COEFFICIENTS, "unbalance": 0.01},
    {**{key: value for key, value in CHAIN.items() if key != "load"}, "contact": [1, 2], "base_motion": "wall"},
    {key: value for key, value in COEFFICIENTS.items() if key != "normal_force"},
    {key: value for key, value in COEFFICIENTS.items() if key != "friction_coefficient"},
    {key: value for key, value in CHAIN.items() if key != "mass_ratios"},
]
SOUND = [
    {**CHAIN, "contact": {"direction": [0.5, "-1", 0]}},
    {**CHAIN, "comment": "a scene"},
    {**CHAIN, "r": "0.1"},
    {**CHAIN, "contact": [2, 3], "load": [1, 0.5, 0]},
    COEFFICIENTS,
    {**{key: value for key, value in COEFFICIENTS.items() if key != "force"}, "unbalance": 0.5},
    {**CHAIN, "static_load": [1, 0, "-0.5"]},
    {"masses": [1, 2], "stiffnesses": [[3, -1], [-1, 1]], "damping_matrix": [[0.2, 0], [0, 0]], "damping_tolerance": 0.01, "contact": 1,
     "load": 2, "frequency_hz": 0.2, "force": 1, "friction": 0.1},
]


def status(scene):
    return subprocess.run([PROGRAM, "solve"], input=json.dumps(scene), capture_output=True, text=True).returncode


class Schema(unittest.TestCase):
    validator = Draft202012Validator(SCHEMA)

    def test_the_schema_is_one(self):
        Draft202012Validator.check_schema(SCHEMA)

    def test_what_is_sound_is_answered(self):
        for scene in SOUND + [json.loads(file.read_text()) for file in (SOURCE / "docs").glob("example*.json")]:
            with self.subTest(scene=scene):
                self.assertEqual([error.message for error in self.validator.iter_errors(scene)], [])
                self.assertEqual(status(scene), 0)

    def test_a_scene_without_a_load_is_sound_for_a_motion_from_a_start(self):
        free = json.loads((SOURCE / "docs/free_decay.json").read_text())
        self.assertTrue(self.validator.is_valid(free))
        self.assertFalse(self.validator.is_valid({**free, "base_motion": "with_wall"}))
        run = subprocess.run([PROGRAM, "integrate", "--start", "0.02,0"], input=json.dumps(free), capture_output=True, text=True)
        self.assertEqual(run.returncode, 0)

    def test_what_is_broken_is_refused_by_both(self):
        for scene in BROKEN:
            with self.subTest(scene=scene):
                self.assertFalse(self.validator.is_valid(scene))
                self.assertEqual(status(scene), 2)


if __name__ == "__main__":
    unittest.main()
