"""Grades a solver of one's own, here the single mass by Den Hartog, against the certified vectors.

Needs the program denhartog and its vectors: set DENHARTOG_PROGRAM, or have it in the PATH.
Usage: grade_my_solver.py [FIGURE.png] (PNG or SVG; the digits of the answers)
"""
import math
import sys

import numpy as np

from denhartog import conformance


def my_solver(question):
    """The amplitude of a single mass with one contact while it slides throughout; everything else is skipped."""
    scene = question["scene"]
    N = max(len(scene[key]) for key in ("mass_ratios", "stiffness_ratios", "damping_ratios"))
    if question["quantity"] != "amplitude" or N != 1:
        return None  # not computed here
    r, beta, (zeta,) = scene["r"], scene["beta"], scene["damping_ratios"]
    if not (r > 0 and beta >= 0 and zeta >= 0 and scene["mu"] >= 1):
        raise ValueError("the scene breaks a rule")
    if not 0 < zeta < 1:
        return None
    w, theta, delta = math.sqrt(1 - zeta**2), math.pi * math.sqrt(1 - zeta**2) / r, math.pi * zeta / r
    V = 1 / complex(1 - r**2, 2 * zeta * r)                                                      # (23)
    U = math.sin(theta) / (r * w * (math.cosh(delta) + math.cos(theta)))                         # (28)
    G = (math.sinh(delta) - zeta / w * math.sin(theta)) / (math.cosh(delta) + math.cos(theta))   # (29)
    return math.sqrt(abs(V) ** 2 - (beta * U) ** 2) - beta * G                                   # (38)


report = conformance.run(my_solver, group="contact")  # its questions are on sliding throughout
print(report)

if len(sys.argv) > 1:
    from matplotlib import pyplot

    digits = [result["digits"] for result in report.results.values() if result.get("digits") is not None]
    figure, axis = pyplot.subplots(constrained_layout=True)
    axis.hist(digits, bins=np.arange(0, 18))
    axis.set(xlabel="correct digits", ylabel="answers")
    figure.savefig(sys.argv[1])
