"""A measured frame in SI units: how far its top floor moves over frequency and friction force.

Three storeys stand on a shaking table; a friction damper sits between the first floor and the second.
Usage: measured_system.py [FIGURE.png] (PNG or SVG)
"""
import sys

import numpy as np

from denhartog import System

frame = System(masses=[12.0, 11.5, 9.8],             # kilograms
               stiffnesses=[18500, 17200, 16900],    # newtons per metre
               damping_ratios=[0.012, 0.009, 0.011],
               contact=[2, 1],                       # the damper, between the second floor and the first
               base_motion="with_wall")
X = 0.002                                            # amplitude of the table in metres
hz = np.linspace(1.0, 6.0, 251)
friction = np.array([1.0, 3.0, 6.5, 12.0])           # newtons

P = frame.base_force(X, hz=hz)                       # newtons; grows with the square of the frequency
r = frame.frequency_ratio(hz=hz)
found = frame.solve(r, frame.friction_ratio(friction[:, None], P), masses=3)
top = found.amplitude[..., 0] * frame.displacement_unit(P)  # metres, relative to the table; shape (friction, frequency)

print("natural frequencies in hertz:", np.round(frame.natural_frequencies / (2 * np.pi), 3))
for F, peak, where in zip(friction, np.nanmax(top, axis=1), hz[np.nanargmax(top, axis=1)]):
    print(f"friction {F:4.1f} N: the top floor moves by up to {1000 * peak:6.2f} mm, at {where:.2f} Hz")

if len(sys.argv) > 1:
    from matplotlib import pyplot

    figure, axis = pyplot.subplots(figsize=(7, 4.5), constrained_layout=True)
    for n, F in enumerate(friction):
        axis.plot(hz, 1000 * top[n], "--", color=f"C{n}", linewidth=1)
        axis.plot(hz, np.where(found.where("continuous")[n], 1000 * top[n], np.nan), color=f"C{n}", label=f"{F:g} N")
    axis.set(xlabel="frequency of the table in hertz", ylabel="peak displacement of the top floor in mm", yscale="log",
             title="solid: the damper slides throughout; dashed: it sticks")
    axis.legend(title="friction force")
    figure.savefig(sys.argv[1])
