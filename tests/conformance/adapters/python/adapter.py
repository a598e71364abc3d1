"""Answers the questions of `denhartog conform` by closed_form.py, in the json dialect."""
import json
import math
import sys
from importlib.util import find_spec

find_spec("numpy") or sys.exit(f"numpy is missing: {sys.executable} does not have it; install it there, or start another Python")
from closed_form import ClosedForm, broken_rule, np

QUANTITIES = {  # c: the closed form of the scene; k: the mass, from 0; q: the question
    "natural_frequency_ratios": lambda c, k, q: c.r_n,
    "modal_frequency_ratios": lambda c, k, q: c.R,
    "mode_shape_products": lambda c, k, q: c.phi[k] * c.phi[c.j] / c.r**2,
    "complex_response": lambda c, k, q: [c.V[k].real, c.V[k].imag],
    "first_damping_function": lambda c, k, q: c.U[k],
    "second_damping_function": lambda c, k, q: c.G[k],
    "H_j": lambda c, k, q: c.H_j,
    "S_j": lambda c, k, q: c.demand(c.psi_j_squared),
    "amplitude": lambda c, k, q: c.amplitude_and_phase(k)[0],
    "phase": lambda c, k, q: wrapped(c.amplitude_and_phase(k)[1]) if c.amplitude_and_phase(k)[0] > 0 else math.nan,
    "amplitude_monoharmonic": lambda c, k, q: math.hypot(*c.initial(k)),
    "phase_monoharmonic": lambda c, k, q: wrapped(c.sliding[0] + math.atan2(*reversed(c.initial(k)))),
    "initial_displacement": lambda c, k, q: c.initial(k)[0],
    "initial_velocity": lambda c, k, q: c.initial(k)[1],
    "displacement": lambda c, k, q: c.motion(k, q["tau"])[0, 0],
    "beta_lim_exact": lambda c, k, q: c.beta_lim(c.demand(c.psi_j_squared)),
    "beta_lim_paper": lambda c, k, q: c.beta_lim(c.S_dj()),
    "beta_lim_approximate": lambda c, k, q: c.beta_lim(0),
    "beta_lim_sticking": lambda c, k, q: c.held[1],
    "beta_lim_high_frequency": lambda c, k, q: 2 / math.hypot(2 * c.mu, math.pi),  # (86) as corrected, j = l
    "regime": lambda c, k, q: c.regime,
    "rest_interval": lambda c, k, q: c.held[2] if c.regime == "permanent_sticking" else math.nan,
    "motion_under_force": lambda c, k, q: c.motion_under_force(k, 2 * math.pi * np.arange(q["samples"]) / q["samples"]),
}

def wrapped(phi):
    return phi - 2 * math.pi * math.ceil((phi - math.pi) / (2 * math.pi))  # to (-pi, pi]


def reply(q):
    if not all(isinstance(q["scene"].get(key), int) for key in ("contact", "load")) or "matrix" in " ".join(q["scene"]):
        return {"skip": "not a scene of the paper"}
    broken = broken_rule(q["scene"], q.get("mass", 1), q.get("tau", 0), q.get("samples", 1))
    if broken:
        return {"reject": broken}
    if q["quantity"] not in QUANTITIES:
        return {"skip": "not in the closed form"}
    try:
        value = QUANTITIES[q["quantity"]](ClosedForm(q["scene"]), q.get("mass", 1) - 1, q)
        return {"value": np.asarray(value).tolist()} if type(value) is str or np.isfinite(value).all() else {"skip": "at a pole"}
    except (ArithmeticError, np.linalg.LinAlgError) as reason:
        return {"skip": str(reason)}


for line in sys.stdin:
    if line.startswith("denhartog-conform"):
        print("denhartog-conform 1 json closed form in Python", flush=True)
    else:
        question = json.loads(line)
        print(json.dumps({"id": question["id"], **reply(question)}), flush=True)
