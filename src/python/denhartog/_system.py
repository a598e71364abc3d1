"""A system of masses and springs with one Coulomb contact."""
from __future__ import annotations

import ctypes
import json
from ctypes import byref
from typing import Any, Callable, Optional, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _batch, _library, _plots, _point, _scene
from ._errors import InputError
from ._results import Boundary, Functions, Handle, Map, Motion, Solution, Solutions
from ._units import Units

Progress = Optional[Callable[[int, int], Any]]


class System(Units):
    """Masses, springs, damping, contact and load, prepared for many points. It does not change once it is made.

    Give either `masses` and `stiffnesses` in units of your own that go together, or `mass_ratios` and `stiffness_ratios`; either
    `damping_ratios` or `damping_matrix`; either `load` or `base_motion`. Masses and modes count from 1.

    Parameters
    ----------
    masses, stiffnesses : array_like, shape (N,) or (N, N)
        Of a chain from the ground outwards, or the matrices M and K. Spring i joins mass i to mass i - 1, spring 1 mass 1 to
        the ground. m_1 and k_1 are the first of each.
    mass_ratios, stiffness_ratios : array_like, shape (N,) or (N, N)
        The same in units of m_1 and k_1: Eqs. (9) and (73).
    damping_ratios : float or array_like, shape (N,)
        Modal damping ratios zeta_i by ascending natural frequency, Eq. (18); one number for all modes.
    damping_matrix : array_like, shape (N, N)
        C in the units of masses and stiffnesses; of a system in ratios in units of sqrt(k_1 m_1).
    damping_tolerance : float, from 0 to 2
        How far `damping_matrix` may be from leaving the modes uncoupled for the damping ratios of its diagonal to take its place.
    contact : int or pair of ints
        The mass that rubs against a wall, or two masses that rub against each other.
    load : int or array_like, shape (N,)
        The mass that bears the force P cos(omega t), or the force on each mass in units of P.
    base_motion : {"with_wall", "alone"}
        A moving base in place of `load`: base and wall move together, or the base alone.
    mu : float
        Static over kinetic friction, Eq. (3), at least 1.

    Raises
    ------
    InputError
        Where a value breaks a rule; the message names quantity, rule and value.

    Examples
    --------
    >>> System(masses=[12.0, 11.5], stiffnesses=[18500, 17200], damping_ratios=0.01, contact=2, load=1)
    System(2 masses, contact on mass 2, load on mass 1, mu = 1, r_n = [0.621211, 1.58555], dimensional)
    """

    def __init__(self, *, masses: Optional[ArrayLike] = None, stiffnesses: Optional[ArrayLike] = None,
                 mass_ratios: Optional[ArrayLike] = None, stiffness_ratios: Optional[ArrayLike] = None,
                 damping_ratios: Optional[ArrayLike] = None, damping_matrix: Optional[ArrayLike] = None,
                 damping_tolerance: Optional[float] = None, contact: Union[int, Sequence[int], None] = None,
                 load: Union[int, ArrayLike, None] = None, base_motion: Optional[str] = None, mu: float = 1.0) -> None:
        scene = _scene.scene_of({
            "masses": masses, "stiffnesses": stiffnesses, "mass_ratios": mass_ratios, "stiffness_ratios": stiffness_ratios,
            "damping_ratios": damping_ratios, "damping_matrix": damping_matrix, "damping_tolerance": damping_tolerance,
            "contact": contact, "load": load, "base_motion": base_motion, "mu": mu})
        self._prepare(scene, json.dumps(scene))

    @classmethod
    def from_scene(cls, source: _scene.Source) -> "System":
        """A system from a scene, as the command line takes it.

        Parameters
        ----------
        source : mapping, str or path
            The scene itself, its text in JSON, or the path of a file that has it. r, beta, forces and frequencies of the scene
            are checked and not used; they stay in `scene`.
        """
        system = cls.__new__(cls)
        system._prepare(*_scene.read(source))
        return system

    def _prepare(self, scene: dict[str, Any], text: str) -> None:
        address, N, encoded = ctypes.c_void_p(), ctypes.c_size_t(), text.encode()
        _library.call("dh_system_from_json", encoded, len(encoded), byref(address))
        self._handle = Handle(address, "dh_system_destroy")
        _library.call("dh_system_masses", address, byref(N), None, None)
        self._scene, self._N = scene, N.value
        (self._r_n, self._zeta), (self._r_n_error, self._zeta_error) = (
            self._of_modes(name) for name in ("dh_natural_frequency_ratios", "dh_natural_frequency_ratio_errors"))

    def _of_modes(self, name: str) -> np.ndarray:
        """Two numbers of each mode, not to be changed."""
        rows = np.empty((2, self.N))
        _library.call(name, self._handle.address, self.N, *map(_library.pointer, rows))
        rows.flags.writeable = False
        return rows

    @property
    def scene(self) -> dict[str, Any]:
        """A copy of the scene: the arguments of the system as the command line takes them in JSON."""
        return json.loads(json.dumps(self._scene))

    @property
    def N(self) -> int:
        """Number of masses."""
        return self._N

    @property
    def contact(self) -> Union[int, tuple[int, int]]:
        """The mass in contact with a wall, j, or the two masses that rub against each other; from 1."""
        contact = self._scene["contact"]
        return tuple(map(int, contact)) if isinstance(contact, list) else int(contact)

    @property
    def mu(self) -> float:
        """Static over kinetic friction, Eq. (3)."""
        return float(self._scene.get("mu", 1.0))

    @property
    def natural_frequency_ratios(self) -> np.ndarray:
        """omega_i sqrt(m_1 / k_1), ascending; shape (N,), dimensionless."""
        return self._r_n

    @property
    def damping_ratios(self) -> np.ndarray:
        """Modal damping ratios zeta_i, Eq. (18), by ascending natural frequency; shape (N,). Of a damping matrix its diagonal in
        modal coordinates."""
        return self._zeta

    @property
    def natural_frequency_ratio_errors(self) -> np.ndarray:
        """Bounds of the errors of `natural_frequency_ratios`; shape (N,)."""
        return self._r_n_error

    @property
    def damping_ratio_errors(self) -> np.ndarray:
        """Bounds of the errors of `damping_ratios`; shape (N,)."""
        return self._zeta_error

    def solve(self, r: ArrayLike, beta: ArrayLike, digits: Optional[int] = None, mu: Optional[float] = None,
              masses: Union[int, Sequence[int], None] = None, threads: int = 0,
              progress: Progress = None, proved: bool = False) -> Union[Solution, Solutions]:
        """The steady motion, in every regime.

        Parameters
        ----------
        r : float or array_like
            Frequency ratio, Eq. (10), positive.
        beta : float or array_like
            Friction ratio, Eq. (11), not negative. `r` and `beta` are broadcast against each other.
        digits : int, from 1 to 15
            Significant digits that must be reached; without it 6 are aimed at.
        mu : float
            Static over kinetic friction in place of that of the system.
        masses : int or sequence of ints
            Masses that are wanted, from 1; default all.
        threads : int
            Threads for arrays, 0 for as many as the machine has. The numbers are the same for any.
        progress : callable
            For arrays: called as ``progress(done, all)``; the computation ends where it returns something true.
        proved : bool
            True to have every number and every bound proved, or PrecisionError with the reason. For scalars only.

        Returns
        -------
        Solution
            Where r and beta are both scalars.
        Solutions
            Else, with arrays of the broadcast shape, those over masses with the masses last. A point without an answer has
            its `status` and NaN.

        Raises
        ------
        InputError, DomainError, PrecisionError
            A value breaks a rule; and of scalars only: a mode without damping resonates; the digits are not reached.
        """
        r_array, beta_array = _batch.numbers("r", r), _batch.numbers("beta", beta)
        listed, static = _batch.mass_list(masses, self.N), self._static(mu)
        asked = 0 if digits is None else int(digits)
        if digits is not None and not 1 <= asked <= 15:
            raise InputError.of("digits", "must be from 1 to 15", digits)
        if r_array.ndim == beta_array.ndim == 0:
            return _point.solution(self._handle.address, self.N, float(r_array), float(beta_array), static, asked, listed,
                                   bool(proved))
        if proved:
            raise InputError.of("proved", "must be false for arrays: ask for a proof point by point", proved)
        found = _batch.solve_points(self._handle.address, r_array, beta_array, static, asked, listed,
                                    _batch.thread_count(threads), progress)
        full_r, full_beta = np.broadcast_arrays(r_array, beta_array)
        return Solutions(r=full_r.copy(), beta=full_beta.copy(), mu=static, masses=listed.astype(int),
                         amplitude_error=found.pop("error"), **found)

    def _static(self, mu: Optional[float]) -> float:
        return self.mu if mu is None else float(mu)

    def map(self, r: ArrayLike, beta: ArrayLike, masses: Union[int, Sequence[int], None] = None, start: str = "rest",
            threads: int = 0, progress: Progress = None, mu: Optional[float] = None) -> Map:
        """Regimes, stops and amplitudes over a grid: what ``denhartog map`` computes, to 6 digits of every amplitude.

        A point costs a few nanoseconds where the contact slides or rests and ``masses=system.contact``, some ten microseconds
        where it sticks and slips.

        Parameters
        ----------
        r : array_like, shape (R,)
            Frequency ratios, positive.
        beta : array_like, shape (B,)
            Friction ratios, not negative; ascending ones help each other.
        masses : int or sequence of ints
            Masses whose amplitudes are wanted, from 1; default all.
        start : {"rest", "sliding"}
            Which motion, where mu > 1 and there is more than one: that from rest, or the sliding motion as far as it exists.
        threads : int
            0 for as many as the machine has. The numbers are the same for any.
        progress : callable
            Called as ``progress(done, all)`` with columns, one for each frequency ratio; the computation ends where it returns
            something true.
        mu : float
            Static over kinetic friction in place of that of the system.

        Returns
        -------
        Map
            Arrays of the shape (R, B), amplitudes (R, B, M).

        Raises
        ------
        Cancelled
            Where `progress` ended it. Ctrl-C ends it with KeyboardInterrupt.
        """
        if start not in ("rest", "sliding"):
            raise InputError.of("start", "must be rest or sliding", start)
        axes = {}
        for name, values in (("r", r), ("beta", beta)):
            axes[name] = np.array(_batch.numbers(name, values), ndmin=1)
            if axes[name].ndim != 1 or axes[name].size == 0:
                raise InputError.of(name, "must be a number or a list of at least one", f"an array of shape {axes[name].shape}")
        listed, static = _batch.mass_list(masses, self.N), self._static(mu)
        found = _batch.solve_map(self._handle.address, axes["r"], axes["beta"], static, start == "sliding", listed,
                                 _batch.thread_count(threads), progress)
        return Map(mu=static, masses=listed.astype(int), **axes, **found)

    def boundary(self, r: ArrayLike, mu: Optional[float] = None, proved: bool = False) -> Boundary:
        """The friction ratios that part the regimes, to 10 digits.

        Parameters
        ----------
        r : float or array_like
            Frequency ratios, positive.
        mu : float
            Static over kinetic friction in place of that of the system.
        proved : bool
            True to have every number and every bound proved, or PrecisionError with the reason.

        Returns
        -------
        Boundary
            exact, paper, approximate, sticking: numbers, or arrays of the shape of `r`; `errors` has the bounds of their errors.
        """
        return _point.boundary(self._handle.address, _batch.numbers("r", r), self._static(mu), bool(proved))

    def motion(self, r: float, beta: float, samples: int = 400, mu: Optional[float] = None) -> Motion:
        """The steady motion at a point over its period: tau (samples,), x and x_prime (samples, N). See `Solution.motion`."""
        return self.solve(r, beta, mu=mu).motion(samples)

    def functions(self, r: ArrayLike) -> Functions:
        """The sums over the modes V, U, G of each mass, H_j and S_j, to 10 digits: see `Functions`.

        Parameters
        ----------
        r : float or array_like
            Frequency ratios, positive.
        """
        return _point.functions(self._handle.address, self.N, _batch.numbers("r", r))

    plot_response = _plots.response
    plot_regimes = _plots.regimes
    plot_motion = _plots.motion

    def __reduce__(self) -> tuple[Any, ...]:
        return System.from_scene, (self._scene,)

    def __repr__(self) -> str:
        contact, load = self.contact, self._scene.get("load")
        rubs = f"between masses {contact[0]} and {contact[1]}" if isinstance(contact, tuple) else f"on mass {contact}"
        loaded = f"load on mass {load}" if isinstance(load, (int, float)) else f"load {load}" if load is not None else \
            f"base motion {self._scene['base_motion']}"
        r_n = ", ".join(f"{x:.6g}" for x in self._r_n[:6]) + (", ..." if self.N > 6 else "")
        return (f"System({self.N} mass{'es' if self.N > 1 else ''}, contact {rubs}, {loaded}, mu = {self.mu:g}, r_n = [{r_n}]"
                f"{', dimensional' if self.dimensional else ''})")
