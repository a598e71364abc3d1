"""Figs. 6 and 10 of the paper. Usage: figures_of_the_paper.py FIGURE_6.png FIGURE_10.png (PNG or SVG)"""
import sys

import numpy as np
from matplotlib import pyplot

from denhartog import System


def figure_6(zetas=(0.001, 0.01, 0.1)):
    """Amplitude and phase of a single mass over the frequency ratio, a row for each damping ratio."""
    figure, rows = pyplot.subplots(len(zetas), 2, figsize=(10, 11), constrained_layout=True)
    r = np.linspace(0.05, 2, 391)
    for zeta, axes in zip(zetas, rows):
        mass = System(mass_ratios=[1], stiffness_ratios=[1], damping_ratios=zeta, contact=1, load=1)
        mass.plot_response(r, [0.1, 0.2, 0.4, 0.6, 0.8], axes=axes)
        axes[0].set_title(f"Fig. 6: a single mass, zeta = {zeta:g}")
    return figure


def figure_10(zetas=(0.001, 0.01, 0.1)):
    """Regimes of two masses, contact on the second and load on the first; zeta_i = zeta / r_n,i."""
    figure, axis = pyplot.subplots(figsize=(7, 5.5), constrained_layout=True)
    r_n = (np.sqrt(5) + np.array([-1, 1])) / 2
    for zeta in zetas:
        masses = System(mass_ratios=[1, 1], stiffness_ratios=[1, 1], damping_ratios=zeta / r_n, contact=2, load=1)
        masses.plot_regimes(np.linspace(0.01, 3, 1000), beta_max=3, fill=False, label=f"zeta = {zeta:g}:", axes=axis)
    for name, r, beta in (("permanent sticking", 0.5, 1.6), ("stick-slip", 0.21, 0.34), ("continuous", 1.5, 0.3)):
        axis.text(r, beta, name, ha="center")
    axis.set_title("Fig. 10: two masses")
    return figure


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    figure_6().savefig(sys.argv[1])
    figure_10().savefig(sys.argv[2])
