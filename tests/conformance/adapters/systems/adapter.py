"""Answers the questions of `denhartog conform run --systems` by system.py, in the json dialect."""
import json
import math
import sys
from importlib.util import find_spec

find_spec("numpy") or sys.exit(f"numpy is missing: {sys.executable} does not have it; install it there, or start another Python")
from system import System, broken_rule, np

QUANTITIES = {  # s: the system; d: the displacement asked about, d^T x; q: the question
    "natural_frequency_ratios": lambda s, d, q: np.sqrt(np.sort(np.linalg.eigvals(np.linalg.solve(s.M, s.K)).real)) * s.r,
    "complex_response": lambda s, d, q: [(d @ s.X).real, (d @ s.X).imag],
    "first_damping_function": lambda s, d, q: s.U(d),
    "second_damping_function": lambda s, d, q: s.G(d),
    "H_j": lambda s, d, q: s.H_j,
    "S_j": lambda s, d, q: s.S,
    "amplitude": lambda s, d, q: s.amplitude_and_phase(d)[0],
    "phase": lambda s, d, q: wrapped(s.amplitude_and_phase(d)[1]),
    "initial_displacement": lambda s, d, q: s.motion(d, 0)[0, 0],
    "initial_velocity": lambda s, d, q: s.motion(d, 0)[1, 0],
    "displacement": lambda s, d, q: s.motion(d, q["tau"])[0, 0],
    "beta_lim_exact": lambda s, d, q: s.beta_lim,
    "beta_lim_sticking": lambda s, d, q: s.held[1],
    "beta_lim_high_frequency": lambda s, d, q: s.beta_lim_high_frequency,
    "regime": lambda s, d, q: s.regime,
    "rest_interval": lambda s, d, q: s.held[2] if s.regime == "permanent_sticking" else math.nan,
    "motion_under_force": lambda s, d, q: s.motion_under_force(d, 2 * math.pi * np.arange(q["samples"]) / q["samples"]),
    "absolute_amplitude": lambda s, d, q: s.amplitude_and_phase(d, s.frame)[0],
    "absolute_phase": lambda s, d, q: wrapped(s.amplitude_and_phase(d, s.frame)[1]),
    "transmissibility": lambda s, d, q: s.amplitude_and_phase(d, s.frame)[0] / s.base,
}


def wrapped(phi):
    return phi - 2 * math.pi * math.ceil((phi - math.pi) / (2 * math.pi))  # to (-pi, pi]


def reply(q):
    broken = broken_rule(q["scene"])
    if broken:
        return {"reject": broken}
    if q["quantity"] not in QUANTITIES:
        return {"skip": "not in the closed form"}
    if q["quantity"] in ("absolute_amplitude", "absolute_phase", "transmissibility") and "base_motion" not in q["scene"]:
        return {"reject": "nothing moves but the masses"}
    try:
        s = System(q["scene"])
        d = np.eye(s.N)[q["mass"] - 1] if q.get("mass", 0) > 0 else s.w  # mass 0: the contact between two masses
        value = QUANTITIES[q["quantity"]](s, d, q)
        if isinstance(value, str) or np.isfinite(value).all():
            return {"value": value if isinstance(value, str) else np.asarray(value, float).tolist()}
        return {"skip": "at a pole"}
    except (ArithmeticError, np.linalg.LinAlgError) as reason:
        return {"skip": str(reason)}


for line in sys.stdin:
    if line.startswith("denhartog-conform"):
        print("denhartog-conform 1 json a system from its matrices, in Python", flush=True)
    else:
        question = json.loads(line)
        print(json.dumps({"id": question["id"], **reply(question)}), flush=True)
