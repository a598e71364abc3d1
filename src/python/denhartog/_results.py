"""What the methods of a System return. Displacements are in units of P / k_1, phases in radians."""
from __future__ import annotations

import math
from ctypes import byref, c_void_p
from dataclasses import dataclass
from typing import NamedTuple, Optional, Union

import numpy as np

from . import _library
from ._errors import InputError, whole

Real = Union[float, np.ndarray]
REGIMES = ("continuous", "stick_slip", "permanent_sticking")
STATUSES = ("answered", "on_boundary", "not_converged", "at_a_pole", "failed")


# The numbers of a boundary and of the sums over the modes, or the bounds of their errors.
BoundaryNumbers = NamedTuple("BoundaryNumbers", [("exact", Real), ("paper", Real), ("approximate", Real), ("sticking", Real)])
FunctionNumbers = NamedTuple("FunctionNumbers", [("V", np.ndarray), ("U", np.ndarray), ("G", np.ndarray), ("H_j", Real),
                                                 ("S_j", Real)])


EnergyNumbers = NamedTuple("EnergyNumbers", [
    (name, float) for name in ("contact", "dampers", "friction", "on_base", "equivalent_damping", "equivalent_damping_ratio",
                               "textbook_contact", "textbook_contact_off", "textbook_amplitude", "textbook_amplitude_off")])


class Energies(EnergyNumbers):
    """What a steady motion dissipates in a period of the force, and the forces that it hands over. Every number is proved.

    Attributes
    ----------
    contact, dampers : float
        Energies that friction and the dampers dissipate, in units of P^2 / k_1; means where the motion is longer than a period.
    friction : float
        The largest friction force, in units of P.
    on_base : float
        The largest force of springs and dampers on the base, without a constant load, in units of P.
    equivalent_damping, equivalent_damping_ratio : float
        Of a dashpot that dissipates as much as friction, c = W / (pi omega X^2) with the energy W and the amplitude X of the
        contact, in units of sqrt(k_1 m_1), and c / (2 sqrt(k_1 m_1)). NaN, as what follows, where the contact does not move.
    textbook_contact, textbook_contact_off : float
        4 F X, and by what part of `contact` it is off.
    textbook_amplitude, textbook_amplitude_off : float
        X by a dashpot 4 F / (pi omega X) in place of friction, in units of P / k_1, and by what part of the amplitude it is
        off; NaN where friction is too large for that formula.
    errors : tuple
        Bounds of the errors of these numbers, under the same names. It is beside the tuple, not one of its members.
    """

    errors: EnergyNumbers


class Boundary(BoundaryNumbers):
    """The friction ratios that part the regimes, at one frequency ratio (numbers) or at several (arrays of their shape).

    Attributes
    ----------
    exact : float or ndarray
        beta_lim, Eq. (69): below it the contact slides throughout. It takes the maximum over tau of the sum over the modes.
    paper : float or ndarray
        Eq. (69) with (56), the sum of the maxima of the modes; never above `exact`.
    approximate : float or ndarray
        Eq. (67); never below `exact`.
    sticking : float or ndarray
        From here on the contact never moves; NaN where no friction holds it, as the system resonates while it is held.
    errors : tuple
        Bounds of the errors of these four, under the same names. It is beside the tuple, not one of its four members.
    proved : bool
        True where every number and every bound is proved; else the bounds are estimates. It is beside the tuple as well.
    """

    errors: BoundaryNumbers
    proved: bool


class FreeDecay(NamedTuple):
    """A motion from a start without the harmonic load. Every number is proved; arrays that end in `_error` are bounds.

    Attributes
    ----------
    at_rest : bool
        True where the contact rests for good; if not, `rest_from` and `rest_at` are NaN and `masses` is empty.
    turns, turn_errors : ndarray, shape (n, 2)
        tau and the displacement of the contact where it turns, in order; at the last one it comes to rest for good.
    stops, stop_errors : ndarray, shape (n, 3)
        Start, end and place of each stop before that.
    rest_from, rest_at, rest_from_error, rest_at_error : float
        tau from which the contact rests for good, and its displacement.
    masses, masses_error : ndarray, shape (N,)
        Places of rest of all masses.
    others : str
        "come_to_rest", "vibrate" for ever, or "not_known": the other masses.
    on_limit : bool
        True where the springs pull on the contact at rest with static friction, to all digits.
    """

    at_rest: bool
    turns: np.ndarray
    turn_errors: np.ndarray
    stops: np.ndarray
    stop_errors: np.ndarray
    rest_from: float
    rest_at: float
    rest_from_error: float
    rest_at_error: float
    masses: np.ndarray
    masses_error: np.ndarray
    others: str
    on_limit: bool


class History(NamedTuple):
    """A motion from a start, or its last periods. Its errors are not known.

    Attributes
    ----------
    stops : ndarray, shape (n, 3)
        Start, end and place of every stop; the end is NaN of a rest that lasts to the end. tau counts from the start.
    tau : ndarray, shape (samples,)
        Instants, from the start of the motion.
    x, x_prime : ndarray, shape (samples, N)
        Displacements in units of P / k_1 and velocities dx/dtau.
    direction : ndarray of int, shape (samples,)
        1 or -1 as the contact slides, 0 while it sticks.
    """

    stops: np.ndarray
    tau: np.ndarray
    x: np.ndarray
    x_prime: np.ndarray
    direction: np.ndarray


class Motion(NamedTuple):
    """A steady motion at equally spaced instants of its period.

    Attributes
    ----------
    tau : ndarray, shape (samples,)
        omega t, from 0, which is the maximum of the force; dimensionless.
    x : ndarray, shape (samples, N)
        Displacements in units of P / k_1.
    x_prime : ndarray, shape (samples, N)
        Their derivatives with respect to tau, in units of P / k_1.
    """

    tau: np.ndarray
    x: np.ndarray
    x_prime: np.ndarray


class Functions(FunctionNumbers):
    """The sums over the modes, at one frequency ratio or, with its shape in front, at several.

    Attributes
    ----------
    V : complex ndarray, shape (..., N)
        Complex response of each mass, Eq. (33).
    U, G : ndarray, shape (..., N)
        First and second damping function of each mass, Eqs. (34) and (35).
    H_j : float or ndarray
        Load on the contact at tau = 0, per unit of friction ratio, Eq. (64).
    S_j : float or ndarray
        The largest sum over the modes of (57) as corrected, over tau.
    errors : tuple
        Bounds of the errors of these five, under the same names; of V those of real and imaginary part, as a complex number. It
        is beside the tuple, not one of its five members.
    """

    errors: FunctionNumbers


class FromGround(NamedTuple):
    """Absolute displacements of the masses asked for, where base, wall or both move.

    Attributes
    ----------
    amplitude, amplitude_error : ndarray, shape (M,)
        Largest absolute displacement of each mass and the bound of its error, in units of P / k_1.
    transmissibility, transmissibility_error : ndarray, shape (M,)
        The same over the amplitude of base or wall.
    phase, phase_error : ndarray, shape (M,)
        Its lag behind base or wall, in (-pi, pi], and the bound of its error; NaN for a mass at rest.
    """

    amplitude: np.ndarray
    amplitude_error: np.ndarray
    transmissibility: np.ndarray
    transmissibility_error: np.ndarray
    phase: np.ndarray
    phase_error: np.ndarray


@dataclass(frozen=True, eq=False, repr=False)
class Solution:
    """The steady motion at one point. M is the number of masses asked for.

    Attributes
    ----------
    r, beta, mu : float
        Frequency ratio, friction ratio, static over kinetic friction.
    regime : str
        ``continuous``, ``stick_slip`` or ``permanent_sticking``.
    on_boundary : bool
        True where beta equals a boundary as far as it is known, and the regime could be the neighbour.
    unique : bool
        True where the steady velocities are known not to depend on the start. Else see `from_rest`.
    from_rest : bool
        True where this is the motion that the start from rest leads to. Else it is a steady motion, and the start is not known
        to lead to it.
    symmetric : bool
        True where the motion mirrors itself after half its period, Eq. (25).
    periods : int
        Period of the motion in periods of the force.
    stops : ndarray, shape (S, 2)
        Start and end of each rest of the contact within that period; tau from the maximum of the force, in radians.
    stop_errors : ndarray, shape (S, 2)
        Bounds of the errors of `stops`; half the period where no error is bounded.
    rest_interval : tuple of two floats, or None
        In permanent sticking the contact may rest anywhere between them; None in the other regimes.
    rest_error : float
        Bound of the error of `rest_interval`.
    masses : ndarray of int, shape (M,)
        The masses asked for, counted from 1.
    amplitude, amplitude_error : ndarray, shape (M,)
        Largest displacement of each mass and the bound of its error, in units of P / k_1.
    phase, phase_error : ndarray, shape (M,)
        Lag of the largest displacement behind the force, in (-pi, pi], and the bound of its error; NaN for a mass at rest.
    contact_amplitude, contact_phase : float
        The same of the contact: of two masses that rub against each other, of the first relative to the second; of a contact
        with a direction w, of w^T x.
    contact_amplitude_error, contact_phase_error : float
        Bounds of their errors.
    from_ground : FromGround or None
        Absolute displacements and transmissibilities, where base, wall or both move; else None.
    relative_error : float
        The largest error of all masses before rounding to double: of amplitudes relative, of phases in radians.
    proved : bool
        True where every number and every bound is proved; else the bounds are estimates. The samples of `motion` are then
        proved too, to 1e-6 of the amplitude of each mass.
    warning : str
        What the amplitudes depend on too much: a mode next to its resonance and with next to no damping, which a unit in the last
        place of a number of the system moves by more than a thousandth. Empty where there is nothing to say.
    """

    r: float
    beta: float
    mu: float
    regime: str
    on_boundary: bool
    unique: bool
    from_rest: bool
    symmetric: bool
    periods: int
    stops: np.ndarray
    stop_errors: np.ndarray
    rest_interval: Optional[tuple[float, float]]
    rest_error: float
    masses: np.ndarray
    amplitude: np.ndarray
    amplitude_error: np.ndarray
    phase: np.ndarray
    phase_error: np.ndarray
    contact_amplitude: float
    contact_phase: float
    contact_amplitude_error: float
    contact_phase_error: float
    from_ground: Optional[FromGround]
    relative_error: float
    proved: bool
    warning: str
    _handle: c_void_p
    _N: int

    def energies(self, digits: int = 6) -> Energies:
        """What the motion dissipates in a period of the force, and the forces that it hands to wall and base.

        Parameters
        ----------
        digits : int
            Significant digits, 1 to 15. Energies have them beside the largest work that the load could do.

        Returns
        -------
        Energies
            In units of P^2 / k_1 and P.

        Raises
        ------
        PrecisionError
            Something is not proved, or the library was built without the reference.
        """
        pair = _library.Energies(), _library.Energies()
        _library.call("dh_solution_energies", self._handle, whole("digits", digits, 1, 15), *map(byref, pair))
        moves, exists = pair[0].contact_moves, pair[0].textbook_amplitude_exists
        known = [exists if "amplitude" in name else moves or not name.startswith(("equivalent", "textbook"))
                 for name in EnergyNumbers._fields]
        of = [EnergyNumbers(*(getattr(part, name) if there else math.nan for name, there in zip(EnergyNumbers._fields, known)))
              for part in pair]
        found = Energies(*of[0])
        found.errors = of[1]
        return found

    def motion(self, samples: int = 400) -> Motion:
        """The motion of all N masses over its period.

        Parameters
        ----------
        samples : int
            Number of instants, ``tau = 2 pi periods n / samples``, from the maximum of the force.

        Returns
        -------
        Motion
            tau (samples,), x and x_prime (samples, N). A contact that rests for ever is taken to rest at zero.
        """
        if not 1 <= samples <= 10_000_000:
            raise InputError.of("samples", "must be from 1 to 10000000", samples)
        x, x_prime = np.empty((samples, self._N)), np.empty((samples, self._N))
        _library.call("dh_solution_motion", self._handle, samples, x.size, x.ctypes, x_prime.ctypes)
        return Motion(2 * np.pi * self.periods * np.arange(samples) / samples, x, x_prime)

    def __repr__(self) -> str:
        stops = f", {len(self.stops)} stops in {self.periods} period(s)" if len(self.stops) else ""
        return (f"<{self.regime} at r = {self.r:.6g}, beta = {self.beta:.6g}{stops}: masses {self.masses.tolist()}, amplitude "
                f"{np.array2string(self.amplitude, precision=6)}, phase {np.array2string(self.phase, precision=6)}>")


@dataclass(frozen=True, eq=False, repr=False)
class _Points:
    """What a map and the solutions at many points share."""

    r: np.ndarray
    beta: np.ndarray
    mu: Real
    masses: np.ndarray
    status: np.ndarray
    regime: np.ndarray
    stops: np.ndarray
    periods: np.ndarray
    amplitude: np.ndarray
    regime_names = REGIMES  #: names of the numbers in `regime`
    status_names = STATUSES  #: names of the numbers in `status`

    def where(self, regime: str) -> np.ndarray:
        """Where the motion is of a regime.

        Parameters
        ----------
        regime : str
            One of `regime_names`.

        Returns
        -------
        ndarray of bool
            Of the shape of `regime`.
        """
        if regime not in REGIMES:
            raise InputError.of("regime", "must be continuous, stick_slip or permanent_sticking", regime)
        return self.regime == REGIMES.index(regime)

    def _told(self) -> str:
        counts = [f"{np.count_nonzero(self.where(name))} {name}" for name in REGIMES if self.where(name).any()]
        without = np.count_nonzero(self.regime < 0)
        return ", ".join(counts + ([f"{without} without an answer"] if without else []))


@dataclass(frozen=True, eq=False, repr=False)
class Solutions(_Points):
    """The steady motions at many points. S is the broadcast shape of r and beta, M the number of masses asked for.

    Attributes
    ----------
    r, beta : ndarray, shape S
        Frequency ratios and friction ratios.
    mu : float; from `solve_many` an ndarray, shape S
        Static over kinetic friction.
    masses : ndarray of int, shape (M,)
        The masses asked for, counted from 1.
    status : ndarray of int8, shape S
        Index into `status_names`: 0 and 1 have numbers, the others not.
    regime : ndarray of int8, shape S
        Index into `regime_names`; -1 where there are no numbers.
    stops : ndarray of int, shape S
        Rests of the contact in a period of the motion; -1 where there are no numbers.
    periods : ndarray of int, shape S
        Period of the motion in periods of the force; -1 where there are no numbers.
    amplitude, amplitude_error : ndarray, shape S + (M,)
        In units of P / k_1, with bounds of their errors; NaN where there are no numbers.
    phase, phase_error : ndarray, shape S + (M,)
        In (-pi, pi], with bounds of their errors; NaN also where a mass does not move.
    """

    amplitude_error: np.ndarray
    phase: np.ndarray
    phase_error: np.ndarray

    def __repr__(self) -> str:
        return f"<solutions of shape {self.regime.shape}, masses {self.masses.tolist()}: {self._told()}>"


@dataclass(frozen=True, eq=False, repr=False)
class Map(_Points):
    """Regimes, stops and amplitudes over a grid of R frequency ratios by B friction ratios, for M masses.

    Attributes
    ----------
    r, beta : ndarray, shapes (R,) and (B,)
        Frequency ratios and friction ratios.
    amplitude : ndarray, shape (R, B, M)
        In units of P / k_1; NaN where there are no numbers.
    phase : ndarray, shape (R, B, M), or None
        Lags behind the force, or of absolute displacements behind base or wall, if they were asked for; NaN where a mass does
        not move or there are no numbers.
    mu, masses, status, regime, stops, periods
        As of `Solutions`, where S is (R, B) and mu one number.
    """

    phase: Optional[np.ndarray] = None

    def __repr__(self) -> str:
        r, beta = (f"{a.size} from {a[0]:.6g} to {a[-1]:.6g}" for a in (self.r, self.beta))
        return f"<map, r: {r}, beta: {beta}, masses {self.masses.tolist()}: {self._told()}>"
