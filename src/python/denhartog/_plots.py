"""Figures of a system with matplotlib, which is imported when one is drawn."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _batch
from ._errors import InputError

if TYPE_CHECKING:
    from ._system import System


def _axes(axes: Any, count: int) -> list[Any]:
    """The axes given, or those of a new figure."""
    try:
        from matplotlib import pyplot
    except ImportError as reason:
        raise ImportError("matplotlib is needed to draw and is not installed: install it with `pip install matplotlib`, or on "
                          "Debian the package python3-matplotlib") from reason
    if axes is None:
        axes = pyplot.subplots(1, count, figsize=(6 * count, 4.2), constrained_layout=True)[1]
    listed = list(np.atleast_1d(np.asarray(axes, dtype=object)).flat)
    if len(listed) < count:
        raise InputError.of("axes", f"must be {count} axes of matplotlib", len(listed))
    return listed


def response(self: "System", r: ArrayLike, beta: ArrayLike, mass: Optional[int] = None, mu: Optional[float] = None,
             axes: Any = None, threads: int = 0) -> Any:
    """Draws amplitude and phase of a mass over the frequency ratio, a line for each friction ratio, as Fig. 6 of the paper.

    Parameters
    ----------
    r : array_like, shape (R,)
        Frequency ratios.
    beta : float or array_like, shape (B,)
        Friction ratios.
    mass : int
        The mass, from 1; default the mass in contact, of two the first.
    axes : sequence of two matplotlib axes
        For amplitude and phase; default those of a new figure.
    mu, threads
        As of `System.solve`.

    Returns
    -------
    list of two matplotlib axes
        Amplitude in units of P / k_1 on a logarithmic axis, and phase in degrees. Solid lines: the contact slides throughout;
        dashed ones: it rests for a part of every period, or for ever.
    """
    above, beside = _axes(axes, 2)[:2]
    k = self._contact_mass if mass is None else mass
    r_values, betas = np.atleast_1d(_batch.numbers("r", r)), np.atleast_1d(_batch.numbers("beta", beta))
    found = self.solve(r_values, betas[:, None], mu=mu, masses=k, threads=threads)
    for line, value in enumerate(betas):
        color = f"C{line % 10}"
        sliding = found.where("continuous")[line]
        for axis, shown in ((above, found.amplitude[line, :, 0]), (beside, np.degrees(found.phase[line, :, 0]))):
            joined = np.where(np.abs(np.diff(shown, append=shown[-1])) > 180, np.nan, shown) if axis is beside else shown
            positive = np.where(joined > 0, joined, np.nan) if axis is above else joined
            axis.plot(r_values, positive, "--", color=color, linewidth=1)
            axis.plot(r_values, np.where(sliding, positive, np.nan), "-", color=color, linewidth=1.6,
                      label=rf"$\beta$ = {value:g}")
    above.set(xlabel="$r$", ylabel=rf"$\bar X_{{{k}}}$", yscale="log")
    beside.set(xlabel="$r$", ylabel=rf"$\phi_{{{k}}}$ in degrees")
    beside.legend()
    return [above, beside]


def regimes(self: "System", r: ArrayLike, beta_max: Optional[float] = None, mu: Optional[float] = None, fill: bool = True,
            label: Optional[str] = None, axes: Any = None) -> Any:
    """Draws the boundaries of the regimes in the plane of frequency and friction ratio, as Fig. 10 of the paper.

    Parameters
    ----------
    r : array_like, shape (R,)
        Frequency ratios, ascending.
    beta_max : float
        Upper end of the axis; default 3, or less where the boundaries are lower.
    mu : float
        Static over kinetic friction in place of that of the system.
    fill : bool
        Whether the regimes are coloured and named; give False to draw several systems into the same axes.
    label : str
        Name of the system in the legend.
    axes : matplotlib axes
        Default those of a new figure.

    Returns
    -------
    matplotlib axes
        Solid line: beta_lim, Eq. (69); dashed line: the smallest beta at which the contact never moves.
    """
    axis = _axes(axes, 1)[0]
    r_values = np.atleast_1d(_batch.numbers("r", r))
    found = self.boundary(r_values, mu=mu)
    sticking = np.where(np.isnan(found.sticking), np.inf, found.sticking)
    if beta_max is None:
        beta_max = float(min(3, 1.2 * np.max(sticking)))
    color = axis.plot(r_values, found.exact, "-", label=rf"{label or ''} $\beta_\mathrm{{lim}}$, (69)".strip())[0].get_color()
    axis.plot(r_values, np.where(np.isinf(sticking), np.nan, sticking), "--", color=color, linewidth=1,
              label=f"{label or ''} permanent sticking".strip())
    if fill:
        edges = [np.zeros_like(r_values), found.exact, np.minimum(sticking, beta_max), np.full_like(r_values, beta_max)]
        names = ("continuous", "stick-slip", "permanent sticking")
        for n, name in enumerate(names):
            axis.fill_between(r_values, np.minimum(edges[n], beta_max), np.minimum(edges[n + 1], beta_max), color=f"C{n + 1}",
                              alpha=0.15, linewidth=0, label=name)
    axis.set(xlabel="$r$", ylabel=r"$\beta$", ylim=(0, beta_max), xlim=(r_values[0], r_values[-1]))
    axis.legend(loc="upper right", fontsize="small")
    return axis


def motion(self: "System", r: float, beta: float, samples: int = 400, masses: Union[int, Sequence[int], None] = None,
           mu: Optional[float] = None, axes: Any = None) -> Any:
    """Draws the displacements over a period of the motion; the rests of the contact are shaded.

    Parameters
    ----------
    r, beta : float
        Frequency ratio and friction ratio.
    samples : int
        Number of instants.
    masses : int or sequence of ints
        Masses that are drawn, from 1; default all.
    mu : float
        Static over kinetic friction in place of that of the system.
    axes : matplotlib axes
        Default those of a new figure.

    Returns
    -------
    matplotlib axes
        x_k in units of P / k_1 over tau, from the maximum of the force.
    """
    axis = _axes(axes, 1)[0]
    found = self.solve(r, beta, mu=mu)
    tau, x, _ = found.motion(samples)
    for k in _batch.mass_list(masses, self.N):
        axis.plot(tau, x[:, int(k) - 1], label=f"$x_{{{k}}}$")
    period = 2 * np.pi * found.periods
    for start, end in found.stops:
        for shift in (-period, 0, period):  # a rest may reach over the end of the period
            low, high = max(start + shift, 0), min(end + shift, period)
            if low < high:
                axis.axvspan(low, high, color="0.5", alpha=0.2, linewidth=0)
    axis.set(xlabel=r"$\tau$", ylabel=r"$x_k$ in units of $P/k_1$", xlim=(0, period),
             title=rf"{found.regime.replace('_', ' ')}, $r$ = {found.r:g}, $\beta$ = {found.beta:g}")
    axis.legend()
    return axis
