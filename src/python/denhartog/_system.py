"""A system of masses and springs with one Coulomb contact."""
from __future__ import annotations

import json
import math
import os
import pathlib
from ctypes import byref, c_double, c_int, c_size_t, create_string_buffer
from typing import Any, Mapping, Optional, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _batch, _library, _plots
from ._batch import Report, like
from ._errors import InputError, whole
from ._results import (REGIMES, Boundary, BoundaryNumbers, FreeDecay, FromGround, FunctionNumbers, Functions, History, Map, Motion,
                       Real, Solution, Solutions)


def plain(key: str, value: Any) -> Any:
    """`value` as lists and numbers of Python; a number that is not finite is refused."""
    if isinstance(value, (np.ndarray, np.generic)):
        value = value.tolist()
    if isinstance(value, Mapping):
        return {name: plain(str(name), entry) for name, entry in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(key, entry) for entry in value]
    if isinstance(value, float) and not math.isfinite(value):
        raise InputError.of(key, "must be finite", value)
    if value is None or isinstance(value, (bool, int, float, str)):
        return value
    raise InputError.of(key, "must be numbers, lists of numbers or arrays", repr(value))


class System:
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
    contact : int, pair of ints, or ``{"direction": w}``
        The mass that rubs against a wall, or two masses that rub against each other; or any direction w, N numbers: w^T x then
        slides, and friction loads mass k by w_k times its force.
    load : int or array_like, shape (N,)
        The mass that bears the force P cos(omega t), or the force on each mass in units of P.
    load_phases : array_like, shape (N,)
        By how much each force of such a list leads, in radians: p_k cos(omega t + theta_k) on mass k.
    base_motion : {"with_wall", "alone", "wall"}
        A moving base or wall in place of `load`: base and wall move together, or the base alone, or the wall alone.
    static_load : array_like, shape (N,)
        A constant force on each mass in units of P, of a system in ratios; of one in units give a scene to `from_scene`.
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
                 damping_tolerance: Optional[float] = None, contact: Union[int, Sequence[int], Mapping[str, ArrayLike], None] = None,
                 load: Union[int, ArrayLike, None] = None, load_phases: Optional[ArrayLike] = None,
                 base_motion: Optional[str] = None, static_load: Optional[ArrayLike] = None, mu: float = 1.0) -> None:
        scene = {key: plain(key, value) for key, value in locals().items() if key != "self" and value is not None}
        for ratios, matrix in (("mass_ratios", "mass_matrix"), ("stiffness_ratios", "stiffness_matrix")):
            value = scene.get(ratios)
            if isinstance(value, list) and value and isinstance(value[0], list):
                scene[matrix] = scene.pop(ratios)
        self._prepare(scene, json.dumps(scene))

    @classmethod
    def from_scene(cls, source: Union[Mapping[str, Any], str, "os.PathLike[str]"]) -> "System":
        """A system from a scene, as the command line takes it.

        Parameters
        ----------
        source : mapping, str or path
            The scene itself, its text in JSON, or the path of a file that has it. r, beta, forces and frequencies of the scene
            are checked and not used; they stay in `scene`.
        """
        system = cls.__new__(cls)
        if isinstance(source, Mapping):
            scene = plain("scene", source)
            text = json.dumps(scene)
        else:
            try:
                is_text = isinstance(source, str) and source.lstrip().startswith("{")
                text = source if is_text else pathlib.Path(source).read_text(encoding="utf-8")
            except OSError as reason:
                raise InputError(f"{source} cannot be read ({reason.strerror})") from reason
            try:
                scene = json.loads(text)
            except ValueError:
                scene = {}  # the library says what is wrong with it
        system._prepare(scene, text)
        return system

    def _prepare(self, scene: dict[str, Any], text: str) -> None:
        N, contact, encoded = c_size_t(), c_size_t(), text.encode()
        self._handle = _library.handle("dh_system_from_json", "dh_system_destroy", encoded, len(encoded))
        _library.call("dh_system_masses", self._handle, byref(N), byref(contact), None)
        self._scene, self._N, self._contact_mass = scene, N.value, contact.value  # that stands for the contact
        (self._r_n, self._zeta), (self._r_n_error, self._zeta_error) = (
            self._of_modes(name) for name in ("dh_natural_frequency_ratios", "dh_natural_frequency_ratio_errors"))

    def _of_modes(self, name: str) -> np.ndarray:
        """Two numbers of each mode, not to be changed."""
        rows = np.empty((2, self.N))
        _library.call(name, self._handle, self.N, *(row.ctypes for row in rows))
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
    def contact(self) -> Union[int, tuple[int, int], dict[str, Any]]:
        """The mass in contact with a wall, j, or the two masses that rub against each other, from 1; or the direction, as given."""
        contact = self._scene["contact"]
        if isinstance(contact, dict):
            return json.loads(json.dumps(contact))
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
              progress: Report = None, proved: bool = False, from_ground: bool = False) -> Union[Solution, Solutions]:
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
        from_ground : bool
            True to have absolute displacements and phases behind base or wall in arrays; a single `Solution` has both.

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
        points = {"r": _batch.numbers("r", r), "beta": _batch.numbers("beta", beta)}
        listed, static, asked = _batch.mass_list(masses, self.N), self._static(mu), _batch.digit_count(digits)
        if all(array.ndim == 0 for array in points.values()) and not from_ground:
            return self._solution(float(points["r"]), float(points["beta"]), static, asked, listed, bool(proved))
        if proved:
            raise InputError.of("proved", "must be false for arrays: ask for a proof point by point", proved)
        return _batch.solve(self._handle, points, listed, _batch.thread_count(threads), progress, mu=static, digits=asked,
                            from_ground=int(from_ground))

    def place_of_rest(self) -> tuple[np.ndarray, np.ndarray]:
        """Where a constant load, `static_load` of the scene, holds the masses, and the proved bounds of the errors.

        Displacements of every motion count from there. Both arrays have the shape (N,), in units of P / k_1; zero without one.
        """
        x, error = np.empty(self.N), np.empty(self.N)
        _library.call("dh_place_of_rest", self._handle, self.N, x.ctypes, error.ctypes)
        return x, error

    def _start(self, x: Optional[ArrayLike], x_prime: Optional[ArrayLike]) -> list[np.ndarray]:
        """Displacements and velocities at the start, zero where they are not given."""
        start = [np.zeros(self.N) if each is None else np.array(_batch.numbers(name, each), ndmin=1)
                 for name, each in (("x", x), ("x_prime", x_prime))]
        for name, each in zip(("x", "x_prime"), start):
            if each.shape != (self.N,):
                raise InputError.of(name, f"must have {self.N} values, one for each mass", f"an array of shape {each.shape}")
        return [np.ascontiguousarray(each) for each in start]

    def free_decay(self, beta: float, x: Optional[ArrayLike] = None, x_prime: Optional[ArrayLike] = None, r: float = 1.0,
                   mu: Optional[float] = None, until: Optional[float] = None) -> FreeDecay:
        """The motion from a start without the harmonic load, until the contact rests for good. Every number is proved.

        P and the frequency are units and nothing more. With r = 1 and beta = F / k_1 in metres, displacements are in metres and
        tau is omega_1 t with omega_1 = sqrt(k_1 / m_1).

        Parameters
        ----------
        beta : float
            Friction ratio F / P, positive.
        x, x_prime : array_like, shape (N,)
            Displacements and velocities dx/dtau at the start; zero where not given.
        r : float
            Frequency ratio, which makes the unit of time.
        mu : float
            Static over kinetic friction in place of that of the system.
        until : float
            tau up to which the motion is followed; by default until the contact rests for good.

        Returns
        -------
        FreeDecay

        Raises
        ------
        PrecisionError
            Something is not proved, as where undamped masses may set the contact in motion for ever: give `until`.
        """
        start = self._start(x, x_prime)
        until = None if until is None else _batch.number("until", until)
        if until is not None and not until > 0:
            raise InputError.of("until", "must be positive", until)
        request = _library.DecayRequest(r=_batch.number("r", r), beta=_batch.number("beta", beta), mu=self._static(mu),
                                        until=until or 0.0,
                                        **{name: each.ctypes.data for name, each in zip(("x", "x_prime"), start)})
        room = 100_000
        names = ("turn", "turn_x", "start", "end", "stop_x")
        arrays = {name: np.empty(room) for each in names for name in (each, f"{each}_error")}
        arrays.update(masses=np.full(self.N, np.nan), masses_error=np.full(self.N, np.nan), rest=np.empty(2), rest_error=np.empty(2))
        found = _library.Decay(room=room, **{name: each.ctypes.data for name, each in arrays.items()})
        _library.call("dh_free_decay", self._handle, byref(request), byref(found))
        rows = lambda count, *columns: np.array([arrays[each][:count] for each in columns]).T.copy()
        rest = arrays["rest"] if found.at_rest else np.full(2, np.nan)
        error = arrays["rest_error"] if found.at_rest else np.full(2, np.nan)
        masses = slice(None) if found.at_rest else slice(0)
        return FreeDecay(
            bool(found.at_rest), rows(found.turns, "turn", "turn_x"), rows(found.turns, "turn_error", "turn_x_error"),
            rows(found.stops, "start", "end", "stop_x"), rows(found.stops, "start_error", "end_error", "stop_x_error"),
            float(rest[0]), float(rest[1]), float(error[0]), float(error[1]), arrays["masses"][masses],
            arrays["masses_error"][masses], ("come_to_rest", "vibrate", "not_known")[found.others], bool(found.on_limit))

    def history(self, r: float, beta: float, cycles: int, x: Optional[ArrayLike] = None, x_prime: Optional[ArrayLike] = None,
                last: Optional[int] = None, samples: int = 0, mu: Optional[float] = None, load: bool = True) -> History:
        """The motion from a start at tau = 0, where the force is largest: every stop of it, and its states.

        Parameters
        ----------
        r, beta, mu
            As of `solve`.
        cycles : int
            Periods of the force that are followed.
        x, x_prime : array_like, shape (N,)
            Displacements in units of P / k_1 and velocities dx/dtau at the start; zero where not given.
        last : int
            How many of the periods are wanted, at the end; by default all.
        samples : int
            Instants in a period at which the state is wanted.
        load : bool
            False to take the harmonic load away.

        Returns
        -------
        History
        """
        start = self._start(x, x_prime)
        cycles, samples = whole("cycles", cycles, 1, 1_000_000), whole("samples", samples, 0, 10_000_000)
        wanted = cycles if last is None else whole("last", last, 1, cycles)
        request = _library.HistoryRequest(r=_batch.number("r", r), beta=_batch.number("beta", beta), mu=self._static(mu),
                                          cycles=cycles, last=wanted, samples=samples, without_load=not load,
                                          **{name: each.ctypes.data for name, each in zip(("x", "x_prime"), start)})
        count, room = wanted * samples, 1000 + 100 * wanted
        stops = np.empty((3, room))
        tau, states, direction = np.empty(count), np.empty((2, count, self.N)), np.empty(count, dtype=np.int8)
        found = _library.HistoryResult(stop_room=room, sample_room=count, tau=tau.ctypes.data, direction=direction.ctypes.data,
                                       **{name: row.ctypes.data for name, row in zip(("start", "end", "stop_x"), stops)},
                                       **{name: part.ctypes.data for name, part in zip(("x", "x_prime"), states)})
        _library.call("dh_follow", self._handle, byref(request), byref(found))
        stops = stops[:, :found.stops].T.copy()
        stops[stops[:, 1] < 0, 1] = np.nan
        return History(stops, tau, states[0], states[1], direction.astype(int))

    def _solution(self, r: float, beta: float, mu: float, digits: int, masses: np.ndarray, proved: bool) -> Solution:
        """The steady motion at a point; 0 digits aim at 6."""
        handle = _library.handle("dh_solve_proved" if proved else "dh_solve", "dh_solution_destroy", self._handle, r, beta, mu,
                                 digits)
        found, is_proved, from_rest = _library.Summary(), c_int(), c_int()
        _library.call("dh_solution_summary", handle, byref(found))
        _library.call("dh_solution_is_proved", handle, byref(is_proved))
        _library.call("dh_solution_is_from_rest", handle, byref(from_rest))

        def numbers(name: str, *mass: int) -> list[float]:
            of = _library.Mass()
            _library.call(name, handle, *mass, byref(of))
            return [of.amplitude, of.error, *((of.phase, of.phase_error) if of.moves else (math.nan, math.nan))]

        kinds = ("amplitude", "amplitude_error", "phase", "phase_error")
        of_masses = np.array([numbers("dh_solution_mass", int(k)) for k in masses]).T.copy()
        of_contact = {f"contact_{kind}": number for kind, number in zip(kinds, numbers("dh_solution_contact"))}
        from_ground = None
        if "base_motion" in self._scene:
            seen = []
            for k in masses:
                of, T, T_error = _library.Mass(), c_double(), c_double()
                _library.call("dh_solution_from_ground", handle, int(k), byref(of), byref(T), byref(T_error))
                seen.append([of.amplitude, of.error, T.value, T_error.value,
                             *((of.phase, of.phase_error) if of.moves else (math.nan, math.nan))])
            from_ground = FromGround(*np.array(seen).T.copy())
        stops = np.empty((2, 2, found.stops))
        for name, (start, end) in zip(("dh_solution_stops", "dh_solution_stop_errors"), stops):
            _library.call(name, handle, found.stops, start.ctypes, end.ctypes)
        stops, stop_errors = stops.swapaxes(1, 2).copy()
        rest_interval = (found.rest_from, found.rest_to) if found.rest_interval_exists else None
        whether = {name: bool(getattr(found, name)) for name in ("on_boundary", "unique", "symmetric")}
        warning = create_string_buffer(512)
        _library.call("dh_solution_warning", handle, len(warning), warning)
        return Solution(
            r=r, beta=beta, mu=mu, warning=warning.value.decode(), regime=REGIMES[found.regime], periods=found.periods, stops=stops, stop_errors=stop_errors,
            rest_interval=rest_interval, rest_error=found.rest_error, masses=masses.astype(int),
            from_ground=from_ground, relative_error=found.relative_error, proved=bool(is_proved), from_rest=bool(from_rest), _handle=handle, _N=self.N, **whether, **of_contact,
            **dict(zip(kinds, of_masses)))

    def _static(self, mu: Optional[float]) -> float:
        return self.mu if mu is None else _batch.number("mu", mu)

    def map(self, r: ArrayLike, beta: ArrayLike, masses: Union[int, Sequence[int], None] = None, start: str = "rest",
            threads: int = 0, progress: Report = None, mu: Optional[float] = None, phases: bool = False,
            from_ground: bool = False) -> Map:
        """Regimes, stops and amplitudes over a grid: what ``denhartog map`` computes, to 6 digits of every amplitude.

        A point costs least where the contact slides or rests and ``masses=system.contact``, and far more where it sticks and slips.

        Parameters
        ----------
        r : array_like, shape (R,)
            Frequency ratios, positive.
        beta : array_like, shape (B,)
            Friction ratios, not negative; ascending ones help each other.
        start : {"rest", "sliding"}
            Which motion, where mu > 1 and there is more than one: that from rest, or the sliding motion as far as it exists.
        progress : callable
            Called as ``progress(done, all)`` with columns, one for each frequency ratio; the computation ends where it returns
            something true.
        phases : bool
            True for phases as well; every point is then answered as by `solve`. For ``start="rest"`` only.
        from_ground : bool
            True for absolute displacements, and phases behind base or wall, where these move. For ``start="rest"`` only.
        masses, threads, mu
            As of `solve`.

        Returns
        -------
        Map
            Arrays of the shape (R, B), amplitudes and phases (R, B, M).

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
        found = _batch.solve_map(self._handle, axes["r"], axes["beta"], static, start == "sliding", listed,
                                 _batch.thread_count(threads), progress, phases=phases, from_ground=from_ground)
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
        at, names = _batch.numbers("r", r), BoundaryNumbers._fields
        rows = np.empty((2, *at.shape, len(names)))
        for place in np.ndindex(at.shape):
            pair = _library.Boundary(), _library.Boundary()
            point = self._handle, float(at[place]), self._static(mu)
            if proved:
                _library.call("dh_boundaries_proved", *point, *map(byref, pair))
            else:
                _library.call("dh_boundaries", *point, byref(pair[0]))
                _library.call("dh_boundary_errors", *point, byref(pair[1]))
            for part, each in zip(rows, pair):
                part[place] = [getattr(each, name) for name in names[:3]] + [each.sticking if each.sticking_exists else math.nan]
        values, bounds = ([like(part[..., n]) for n in range(len(names))] for part in rows)
        result = Boundary(*values)
        result.errors, result.proved = BoundaryNumbers(*bounds), bool(proved)
        return result

    def motion(self, r: float, beta: float, samples: int = 400, mu: Optional[float] = None) -> Motion:
        """The steady motion at a point over its period: tau (samples,), x and x_prime (samples, N). See `Solution.motion`."""
        return self.solve(r, beta, mu=mu).motion(samples)

    def quantity(self, name: str, r: float, beta: float = 0.0, mass: int = 1, tau: float = 0.0, samples: int = 400,
                 mu: Optional[float] = None) -> tuple[np.ndarray, np.ndarray]:
        """Any quantity of the conformance kit by its name, and the bounds of its errors.

        Each call solves for the motion anew if the quantity needs it; for many numbers of a point ask `solve` once.

        Parameters
        ----------
        name : str
            As on the page of the protocol, such as ``"first_damping_function"`` or ``"stop_durations"``.
        r, beta, mu
            As of `solve`.
        mass : int
            From 1; of no meaning for a quantity of no mass.
        tau : float
            Instant, for ``"displacement"`` alone.
        samples : int
            Instants in the period, for ``"motion_under_force"`` alone.

        Returns
        -------
        tuple of ndarrays
            The numbers in the units of the protocol, and as many bounds; regimes as numbers, 0 to 2 in their order.

        Raises
        ------
        DomainError
            There is no quantity of this name, or none at this point, such as the phase of a mass at rest.
        """
        for key, value, least in (("mass", mass, 0), ("samples", samples, 1)):
            if value < least:
                raise InputError.of(key, f"must be at least {least}", value)
        point = _batch.number("r", r), _batch.number("beta", beta)
        room = samples if name == "motion_under_force" else max(2 * self.N, 1000)
        count, parts = c_size_t(), np.empty((2, room))
        for function, part in zip(("dh_quantity", "dh_quantity_errors"), parts):
            _library.call(function, self._handle, name.encode(), *point, self._static(mu), mass, _batch.number("tau", tau), room,
                          part.ctypes, byref(count))
        values, errors = parts[:, :count.value].copy()
        return values, errors

    def functions(self, r: ArrayLike) -> Functions:
        """The sums over the modes V, U, G of each mass, H_j and S_j, to 10 digits: see `Functions`.

        Parameters
        ----------
        r : float or array_like
            Frequency ratios, positive.
        """
        at = _batch.numbers("r", r)

        def arrays(name: str) -> list[Real]:
            arrays = [np.empty((*at.shape, self.N), complex), *(np.empty((*at.shape, n)) for n in (self.N, self.N, 1, 1))]
            for place in np.ndindex(at.shape):
                _library.call(name, self._handle, float(at[place]), self.N, *(array[place].ctypes for array in arrays))
            return arrays[:3] + [like(array[..., 0]) for array in arrays[3:]]

        result = Functions(*arrays("dh_sums"))
        result.errors = FunctionNumbers(*arrays("dh_sum_errors"))
        return result

    @property
    def dimensional(self) -> bool:
        """Whether the system was given by `masses` and `stiffnesses` in units of its own."""
        return "masses" in self._scene

    @property
    def m_1(self) -> float:
        """The mass that masses are in units of. Of a dimensional system only."""
        return self._unit("masses")

    @property
    def k_1(self) -> float:
        """The stiffness that stiffnesses are in units of. Of a dimensional system only."""
        return self._unit("stiffnesses")

    def _unit(self, key: str) -> float:
        if not self.dimensional:
            raise InputError.of("the system", "must be given by masses and stiffnesses to have units", "given by ratios")
        value = self._scene[key]  # of a list, of a matrix, or the only one
        while isinstance(value, list):
            value = value[0]
        return float(value)

    @property
    def natural_frequencies(self) -> np.ndarray:
        """omega_i in radians per unit of time, ascending; shape (N,). Of a dimensional system only."""
        return self._r_n * math.sqrt(self.k_1 / self.m_1)

    def frequency_ratio(self, omega: Optional[ArrayLike] = None, *, hz: Optional[ArrayLike] = None) -> Real:
        """r = omega sqrt(m_1 / k_1), Eq. (10). Of a dimensional system only.

        Parameters
        ----------
        omega : array_like
            Circular frequency of the load in radians per unit of time; or
        hz : array_like
            its frequency in periods per unit of time.

        Returns
        -------
        float or ndarray
            Frequency ratios of the same shape.
        """
        return like(self._circular(omega, hz) * math.sqrt(self.m_1 / self.k_1))

    def _circular(self, omega: Optional[ArrayLike], hz: Optional[ArrayLike]) -> np.ndarray:
        if (omega is None) == (hz is None):
            raise InputError.of("omega", "must be given, or hz in its place", "" if omega is None else "given with hz")
        return _batch.numbers("omega", omega) if hz is None else 2 * np.pi * _batch.numbers("hz", hz)

    def friction_ratio(self, friction: ArrayLike, force: ArrayLike) -> Real:
        """beta = F / P, Eq. (11), of the kinetic friction force and the amplitude of the load in the same unit."""
        return like(_batch.numbers("friction", friction) / _batch.numbers("force", force))

    def displacement_unit(self, force: ArrayLike) -> Real:
        """P / k_1, by which displacements have to be multiplied, for an amplitude P of the load. Of a dimensional system only."""
        return like(_batch.numbers("force", force) / self.k_1)

    def base_force(self, displacement: Optional[ArrayLike] = None, omega: Optional[ArrayLike] = None, *,
                   hz: Optional[ArrayLike] = None, acceleration: Optional[ArrayLike] = None) -> Real:
        """The force P that a moving base or wall stands for: m_1 omega^2 X if they move together, k_1 X if one moves alone.

        Parameters
        ----------
        displacement : array_like
            Amplitude X of what moves; or
        acceleration : array_like
            that of its acceleration, omega^2 X.
        omega, hz : array_like
            Frequency as of `frequency_ratio`; needed for a displacement of both, and for an acceleration of one alone.
        """
        if (displacement is None) == (acceleration is None):
            raise InputError.of("displacement", "must be given, or acceleration in its place",
                                "" if displacement is None else "given with acceleration")
        base = self._scene.get("base_motion")
        if base is None:
            raise InputError.of("base_motion", "must be given for a base to have a force", "")
        unit = self.m_1 if base == "with_wall" else self.k_1
        if acceleration is not None and base == "with_wall":
            return like(unit * _batch.numbers("acceleration", acceleration))
        if acceleration is not None:
            circular = self._circular(omega, hz)
            return like(unit * (_batch.numbers("acceleration", acceleration) / (circular * circular)))
        X = _batch.numbers("displacement", displacement)
        if base != "with_wall":
            return like(unit * X)
        circular = self._circular(omega, hz)
        return like(unit * circular * circular * X)

    plot_response = _plots.response
    plot_regimes = _plots.regimes
    plot_motion = _plots.motion

    def __reduce__(self) -> tuple[Any, ...]:
        return System.from_scene, (self._scene,)

    def __repr__(self) -> str:
        contact, load = self.contact, self._scene.get("load")
        rubs = f"along {contact['direction']}" if isinstance(contact, dict) else \
            f"between masses {contact[0]} and {contact[1]}" if isinstance(contact, tuple) else f"on mass {contact}"
        loaded = f"load on mass {load}" if isinstance(load, (int, float)) else f"load {load}" if load is not None else \
            f"base motion {self._scene['base_motion']}"
        r_n = ", ".join(f"{x:.6g}" for x in self._r_n[:6]) + (", ..." if self.N > 6 else "")
        return (f"System({self.N} mass{'es' if self.N > 1 else ''}, contact {rubs}, {loaded}, mu = {self.mu:g}, r_n = [{r_n}]"
                f"{', dimensional' if self.dimensional else ''})")


def solve_many(systems: Union[System, Sequence[System], np.ndarray], r: ArrayLike, beta: ArrayLike,
               digits: Optional[int] = None, mu: Optional[ArrayLike] = None, masses: Union[int, Sequence[int], None] = None,
               threads: int = 0, progress: Report = None) -> Solutions:
    """The steady motions of many systems, each at a point of its own: what `System.solve` has for one.

    Parameters
    ----------
    systems : sequence of System, or ndarray of them
        Systems of any number of masses. One may be there more than once. It is broadcast with `r`, `beta` and `mu`.
    mu : float or array_like
        Static over kinetic friction in place of that of each system.
    masses : int or sequence of ints
        Masses that are wanted, from 1, which every system must have; default all.
    r, beta, digits, threads, progress
        As of `System.solve`.

    Returns
    -------
    Solutions
        With arrays of the broadcast shape, those over masses with the masses last: as many as the largest system has, with NaN
        for a mass that a system does not have.

    Raises
    ------
    InputError
        Where a value breaks a rule; the message names quantity, rule and value.
    Cancelled
        Where `progress` ended it.

    Examples
    --------
    >>> pair = [System(mass_ratios=[1, 1], stiffness_ratios=[1, 1], damping_ratios=zeta, contact=2, load=1) for zeta in (0.05, 0.1)]
    >>> solve_many(pair, r=0.8, beta=0.2).amplitude.shape
    (2, 2)
    """
    array = np.asarray(systems if isinstance(systems, (System, np.ndarray)) else list(systems), dtype=object)
    flat = list(array.flat)
    for each in flat:
        if not isinstance(each, System):
            raise InputError.of("systems", "must be a System or a list of them", repr(each))
    asked = _batch.digit_count(digits)
    points = {"systems": np.array([each._handle.value for each in flat], dtype=np.uintp).reshape(array.shape),
              "r": _batch.numbers("r", r), "beta": _batch.numbers("beta", beta),
              "mu": np.array([each.mu for each in flat]).reshape(array.shape) if mu is None else _batch.numbers("mu", mu)}
    counts = [each.N for each in flat]
    wanted = max(counts, default=0) if masses is None else _batch.mass_list(masses, min(counts, default=0))
    return _batch.solve(None, points, wanted, _batch.thread_count(threads), progress, digits=asked)
