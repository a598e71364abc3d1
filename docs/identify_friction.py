"""Friction and damping from the peaks of a free decay test: identify_friction.py STIFFNESS < answer of `integrate --json`."""
import json
import sys

import numpy as np

k = float(sys.argv[1])
turns = json.load(sys.stdin)["turns"]
peaks = np.abs([turn["x"] for turn in turns])
instants = np.array([turn["t"] for turn in turns])
q, offset = np.polyfit(peaks[:-1], peaks[1:], 1)  # the line of one peak over the one before
decrement = -np.log(q)
print(f"damping ratio    {decrement / np.hypot(np.pi, decrement):.6f}")
print(f"friction force   {-offset / (1 + q) * k:.6f}")
print(f"damped frequency {np.pi / np.mean(np.diff(instants)):.6f} radians per second")
