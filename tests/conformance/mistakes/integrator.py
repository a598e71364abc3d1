"""A time-stepping solver with some friction law: what solvers of the motion answer that make a mistake, and one that makes none.

Each step is exact for the linear system under the load, with friction constant over the step. Usage:
integrator.py LAW PERIODS [WIDTH], LAW being coulomb, sgn (with sgn(0) = 0), tanh or arctangent (of the velocity over WIDTH).
"""
import json
import math
import sys

import numpy as np

LAW, PERIODS, WIDTH = sys.argv[1], int(sys.argv[2]), float(sys.argv[3]) if len(sys.argv) > 3 else 0.0
SMOOTH = {"tanh": math.tanh, "arctangent": lambda x: 2 / math.pi * math.atan(x)}
STEPS = 2048 if LAW == "coulomb" else 512  # a period of the force


def exponential(A):
    squarings = max(0, math.ceil(math.log2(max(1e-300, np.abs(A).sum(axis=1).max()))) + 4)
    term = total = np.eye(len(A))
    for n in range(1, 20):
        term = term @ A / (n * 2.0**squarings)
        total = total + term
    for _ in range(squarings):
        total = total @ total
    return total


class Chain:
    """z = (x, x', cos tau, sin tau, 1): z' = A z; the last entry carries friction."""

    def __init__(self, scene):
        gamma, kappa = np.array(scene["mass_ratios"], float), np.array(scene["stiffness_ratios"], float)
        self.N, self.j, self.r = len(gamma), scene["contact"] - 1, scene["r"]
        self.mu, self.beta = scene["mu"], scene["beta"]
        N = self.N
        K = np.diag(kappa + np.append(kappa[1:], 0)) - np.diag(kappa[1:], 1) - np.diag(kappa[1:], -1)
        root = np.sqrt(gamma)
        squares, shapes = np.linalg.eigh(K / np.outer(root, root))
        damping = (shapes * (2 * np.array(scene["damping_ratios"]) * np.sqrt(squares))) @ shapes.T * np.outer(root, root)
        A = np.zeros((2 * N + 3, 2 * N + 3))
        A[:N, N : 2 * N] = np.eye(N)
        A[N : 2 * N, :N] = -K / (gamma * self.r**2)[:, None]
        A[N : 2 * N, N : 2 * N] = -damping / (gamma * self.r)[:, None]
        A[N + scene["load"] - 1, 2 * N] = 1 / (gamma[scene["load"] - 1] * self.r**2)
        A[2 * N, 2 * N + 1], A[2 * N + 1, 2 * N] = -1, 1
        A[N + self.j, 2 * N + 2] = 1 / (gamma[self.j] * self.r**2)
        self.decay = float((np.array(scene["damping_ratios"]) * np.sqrt(squares)).min()) / self.r  # slowest, in tau
        step = exponential(A * (2 * math.pi / STEPS))
        self.free, self.force = step.copy(), step[:, 2 * N + 2].copy()  # without friction; what a unit of it adds
        self.free[:, 2 * N + 2] = 0
        self.force[2 * N + 2] = 0

    def friction(self, law, width, before, free, gain, held):
        """Friction over a step, from the velocity of the contact before it and what that would become without friction.

        Without friction and load the step leaves `held` of the velocity."""
        beta = self.beta
        if law == "sgn":
            return -math.copysign(beta, before) if before else 0.0
        if law in SMOOTH:
            low, high = free - gain * beta, free + gain * beta  # the velocity after the step: free - gain beta smooth(v / width)
            for _ in range(30):
                v = (low + high) / 2
                low, high = (low, v) if v - free + gain * beta * SMOOTH[law](v / width) > 0 else (v, high)
            return -beta * SMOOTH[law]((low + high) / 2 / width)
        to_hold = (held * before - free) / gain  # friction that would keep it at rest
        if before and (free - gain * math.copysign(beta, before)) * before > 0:  # it goes on in its direction
            return -math.copysign(beta, before)
        return -free / gain if abs(to_hold) <= self.mu * beta else math.copysign(beta, to_hold)

    def run(self, law, periods, width):
        """Displacements and the velocity of the contact at the steps of the last period."""
        N, v = self.N, self.N + self.j
        z = np.zeros(2 * N + 3)
        z[2 * N] = 1
        x, velocity = [], []
        gain = float(self.force[v])
        for n in range(periods * STEPS):
            if n >= (periods - 1) * STEPS:
                x.append(z[:N])
                velocity.append(z[v])
            free = self.free @ z
            f = self.friction(law, width, float(z[v]), float(free[v]), gain, float(self.free[v, v]))
            z = free + f * self.force
            if law == "coulomb" and abs(z[v]) <= 1e-12 * abs(free[v]):  # friction stopped it
                z[v] = 0.0
        return np.array(x), np.array(velocity)


def stops(velocity):
    """Lengths of the rests: runs of steps without velocity, round the period."""
    rest = velocity == 0
    if rest.all() or not rest.any():
        return []
    rest = np.roll(rest, -int(np.argmin(rest)))
    edges = np.flatnonzero(np.diff(np.append(0, np.append(rest, 0).astype(int))))
    return sorted((b - a) * 2 * math.pi / STEPS for a, b in zip(edges[::2], edges[1::2]) if b - a > 4)


def answer(q, law, periods, width):
    chain = Chain(q["scene"])
    if law != "coulomb" and chain.decay * 2 * math.pi * periods < 10:
        raise ArithmeticError("the transient does not decay in the time of integration")
    x, velocity = chain.run(law, periods, width)
    if q["quantity"] == "stops_per_period":
        return len(stops(velocity))
    if q["quantity"] == "stop_durations":
        return stops(velocity)
    if q["quantity"] == "regime":
        return "permanent_sticking" if (velocity == 0).all() else "stick_slip" if stops(velocity) else "continuous"
    path = x[:, q["mass"] - 1]
    if q["quantity"] == "motion_under_force":
        return np.interp(np.arange(q["samples"]) / q["samples"], np.arange(STEPS) / STEPS, path).tolist()
    largest = int(np.argmax(abs(path)))
    before, at, after = abs(path[largest - 1]), abs(path[largest]), abs(path[(largest + 1) % STEPS])
    curvature = before - 2 * at + after
    inside = 0 < largest < STEPS - 1  # what is not periodic has no neighbour beyond the ends
    shift = (before - after) / 2 / curvature if curvature and inside else 0
    if q["quantity"] == "amplitude":
        return at - (before - after) * shift / 4
    return math.remainder(2 * math.pi * (largest + shift) / STEPS + (math.pi if path[largest] < 0 else 0), 2 * math.pi)


ANSWERED = ("amplitude", "phase", "motion_under_force", "stops_per_period", "stop_durations", "regime")
for line in sys.stdin:
    if line.startswith("denhartog-conform"):
        print("denhartog-conform 1 json steps in time,", *sys.argv[1:], flush=True)
        continue
    question = json.loads(line)
    if question["quantity"] in ANSWERED:
        try:
            reply = {"value": answer(question, LAW, PERIODS, WIDTH)}
        except ArithmeticError as reason:
            reply = {"skip": str(reason)}
        print(json.dumps({"id": question["id"], **reply}), flush=True)
    else:
        print(json.dumps({"id": question["id"], "skip": "no quantity of a motion"}), flush=True)
