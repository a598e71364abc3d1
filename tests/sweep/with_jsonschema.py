"""Checks studies against docs/study.schema.json: with_jsonschema.py PROGRAM SOURCE. Ends with status 77 where the validator is missing."""
import copy
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

try:
    from jsonschema import Draft202012Validator
except ImportError:
    print("skipped: python3-jsonschema is missing")
    sys.exit(77)

SOURCE = Path(sys.argv.pop())
PROGRAM = sys.argv.pop()
SCHEMA = json.loads((SOURCE / "docs/study.schema.json").read_text())
STUDY = {
    "scene": {"mass_ratios": [1, 2], "stiffness_ratios": [1, 0.5], "damping_ratios": [0.03, 0.06], "contact": 2, "load": 1},
    "axes": [
        {"quantity": "r", "from": 0.3, "to": 1.7, "count": 9, "scale": "logarithmic"},
        {"quantity": "beta", "values": [0, 0.5]},
        {"quantity": "mass", "entry": 2, "as": "factor", "values": [0.5, 1]},
        {"quantity": "load", "values": [1, 2]},
    ],
    "samples": {
        "method": "sobol", "count": 8, "seed": 5,
        "variables": [
            {"quantity": "zeta", "normal": {"mean": 0.03, "standard_deviation": 0.01, "from": 0}},
            {"quantity": "beta", "as": "factor", "lognormal": {"median": 1, "log_standard_deviation": 0.2}},
            {"quantity": "stiffness", "entry": 2, "loguniform": {"from": 0.5, "to": 2}},
        ],
    },
    "answers": ["regime", "phases"],
    "masses": [1, 2],
    "start": "sliding",
    "effort": 10000000,
    "reduce": [
        {"name": "share", "statistic": "share", "over": ["sample"]},
        {"name": "band", "statistic": "quantiles", "of": "amplitude_1", "over": ["sample"], "probabilities": [0, 0.5]},
        {"name": "counts", "statistic": "histogram", "of": "phase_2", "over": ["r"], "bins": {"from": -4, "to": 4, "count": 5}},
    ],
    "points_of_a_chunk": 100,
    "comment": "a study",
}
# Paths of the sound study, each with a value that breaks it; None takes the key away.
BROKEN = [
    (["scene"], None),
    (["no_such_key"], 1),
    (["axes"], []),
    (["axes", 0, "no_such_key"], 1),
    (["axes", 0, "quantity"], "omega"),
    (["axes", 0, "count"], 0),
    (["axes", 0, "count"], 1.5),
    (["axes", 0, "scale"], "cubic"),
    (["axes", 0, "values"], [1]),
    (["axes", 1, "values"], []),
    (["axes", 1, "values"], ["0.5"]),
    (["axes", 2, "entry"], 0),
    (["axes", 2, "as"], "sum"),
    (["samples", "method"], "halton"),
    (["samples", "count"], 0),
    (["samples", "seed"], -1),
    (["samples", "seed"], None),
    (["samples", "variables"], []),
    (["samples", "variables", 0, "uniform"], {"from": 0, "to": 1}),
    (["samples", "variables", 0, "normal"], None),
    (["samples", "variables", 0, "normal", "standard_deviation"], 0),
    (["samples", "variables", 1, "lognormal", "mean"], 1),
    (["samples", "variables", 2, "loguniform", "middle"], 1),
    (["answers"], ["velocity"]),
    (["masses"], [0]),
    (["start"], "fast"),
    (["effort"], 0),
    (["reduce", 0, "statistic"], "mean"),
    (["reduce", 0, "of"], "amplitude_1"),
    (["reduce", 0, "over"], []),
    (["reduce", 0, "name"], "a-b"),
    (["reduce", 1, "probabilities"], None),
    (["reduce", 1, "probabilities"], [1.5]),
    (["reduce", 2, "bins"], None),
    (["reduce", 2, "of"], None),
    (["points_of_a_chunk"], 0),
]


def broken(path, value):
    study = copy.deepcopy(STUDY)
    inner = study
    for step in path[:-1]:
        inner = inner[step]
    if value is None:
        del inner[path[-1]]
    else:
        inner[path[-1]] = value
    return study


def status(study):
    with tempfile.TemporaryDirectory() as scratch:
        return subprocess.run([PROGRAM, "sweep", "plan", "--without-estimate", "-", scratch + "/study"], input=json.dumps(study),
                              capture_output=True, text=True).returncode


class Schema(unittest.TestCase):
    validator = Draft202012Validator(SCHEMA)

    def test_the_schema_is_one(self):
        Draft202012Validator.check_schema(SCHEMA)

    def test_what_is_sound_is_planned(self):
        documented = [json.loads(file.read_text()) for file in sorted((SOURCE / "docs").glob("study_*.json"))]
        self.assertGreater(len(documented), 1)
        for study in [STUDY] + documented:
            self.assertEqual([error.message for error in self.validator.iter_errors(study)], [])
        self.assertEqual(status(STUDY), 0)
        self.assertEqual(status(documented[0]), 0)

    def test_what_is_broken_is_refused_by_both(self):
        for path, value in BROKEN:
            with self.subTest(path=path, value=value):
                self.assertFalse(self.validator.is_valid(broken(path, value)))
                self.assertEqual(status(broken(path, value)), 2)


unittest.main()
