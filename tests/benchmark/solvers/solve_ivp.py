#!/usr/bin/env python3
"""scipy's solve_ivp with events over the pack: solve_ivp.py RTOL PARTS PACK [BUDGET] [EVERY]. Results to standard output.

A step is at most a PARTS-th of a period; 0: as long as the integrator likes, which is scipy's own setting.

As people write it: sliding until the contact's velocity is zero, then friction decides whether it sticks; sticking until the load
on the contact reaches static friction. From rest, for as many periods as the pack says bring transients down to RTOL.
"""
import json
import math
import sys
import time

import numpy as np
import scipy
from scipy.integrate import solve_ivp

RTOL, PARTS, PACK = float(sys.argv[1]), int(sys.argv[2]), sys.argv[3]
BUDGET = float(sys.argv[4]) if len(sys.argv) > 4 else 10.0
EVERY = int(sys.argv[5]) if len(sys.argv) > 5 else 1
MOST_EVENTS = 200  # in a period


class Chain:
    def __init__(self, scene):
        m, k, c = (np.array(scene[name], float) for name in ("m", "k", "c"))
        between = lambda s: np.diag(s + np.append(s[1:], 0)) - np.diag(s[1:], 1) - np.diag(s[1:], -1)
        self.N, self.j, self.l = len(m), scene["contact"] - 1, scene["load"] - 1
        self.m, self.K, self.C = m, between(k), between(c) + np.diag(scene["c_ground"])
        self.F, self.F_static, self.omega, self.direction = scene["F"], scene["F_static"], scene["omega"], 0

    def pull(self, t, y):
        """Forces on the masses but friction."""
        f = -self.K @ y[:self.N] - self.C @ y[self.N:]
        f[self.l] += math.cos(self.omega * t)
        return f

    def __call__(self, t, y):
        f = self.pull(t, y)
        f[self.j] = f[self.j] - self.F * self.direction if self.direction else 0.0
        return np.concatenate([y[self.N:], f / self.m])

    def after(self, t, y):
        """What the contact does from an instant at which it is at rest."""
        load = self.pull(t, y)[self.j]
        self.direction = 0 if abs(load) <= self.F_static else int(math.copysign(1, load))


def settled(scene, start):
    chain, period = Chain(scene), 2 * math.pi / scene["omega"]
    allowed = [float(name) for name, n in scene["periods_to_settle"].items() if n]
    periods = scene["periods_to_settle"][f"{max(RTOL, min(allowed)):.0e}"]
    turns = lambda t, y: y[chain.N + chain.j]
    breaks = lambda t, y: abs(chain.pull(t, y)[chain.j]) - chain.F_static
    turns.terminal = breaks.terminal = True
    breaks.direction = 1
    y, samples, stops, resting = np.zeros(2 * chain.N), np.zeros((chain.N, 64)), [], None
    chain.after(0.0, y)
    instants = period * np.arange(64) / 64
    for n in range(periods + 1):
        t, events, last = 0.0, 0, n == periods
        if last and chain.direction == 0:
            resting = 0.0
        while t < period:
            event = breaks if chain.direction == 0 else turns
            turns.direction = -chain.direction
            run = solve_ivp(chain, (t, period), y, rtol=RTOL, atol=RTOL * 1e-3, events=event, dense_output=last,
                            max_step=period / PARTS if PARTS else np.inf)
            if last:
                inside = (instants >= t) & (instants <= run.t[-1])
                samples[:, inside] = run.sol(instants[inside])[:chain.N] if inside.any() else samples[:, inside]
            t, y = run.t[-1], run.y[:, -1].copy()
            if run.status == 1:
                was = chain.direction
                if was:
                    y[chain.N + chain.j] = 0.0
                    chain.after(t, y)
                else:
                    chain.direction = int(math.copysign(1, chain.pull(t, y)[chain.j]))
                if last and was and chain.direction == 0:
                    resting = t
                if last and not was and resting is not None:
                    stops.append([resting, t])
                    resting = None
            events += 1
            if events > MOST_EVENTS or run.status < 0:
                raise ArithmeticError("an event is met again and again" if run.status >= 0 else run.message)
            if time.process_time() - start > BUDGET:
                raise ArithmeticError("not settled within the budget")
    if resting is not None:  # over the end of the period: with what there was at its start
        if stops and stops[0][0] == 0.0:
            stops[0] = [resting, stops[0][1] + period]
        else:
            stops.append([resting, period])
    return samples, stops


setting = f"rtol {RTOL:.0e}" + (f", max_step T/{PARTS}" if PARTS else "")
print(json.dumps({"method": "scipy solve_ivp with events, RK45", "setting": setting, "version": scipy.__version__}))
with open(PACK, encoding="utf-8") as file:
    scenes = json.load(file)
for scene in scenes[::EVERY]:
    start = time.process_time()
    line = {"scene": scene["scene"]}
    try:
        x, stops = settled(scene, start)
        line.update(x=x.tolist(), stops=stops)
    except (ArithmeticError, ValueError) as reason:
        line["failure"] = str(reason)
    line["seconds"] = time.process_time() - start
    print(json.dumps(line), flush=True)
