"""What the library computes of a system at one point, as results of Python."""
from __future__ import annotations

import ctypes
import math
from ctypes import byref

import numpy as np

from . import _library
from ._results import REGIMES, Boundary, BoundaryNumbers, FunctionNumbers, Functions, Handle, Solution
from ._units import Real, like


def solution(system: ctypes.c_void_p, N: int, r: float, beta: float, mu: float, digits: int, masses: np.ndarray,
             proved: bool) -> Solution:
    """The steady motion at a point, of `masses`, counted from 1; 0 digits aim at 6."""
    address, summary, is_proved = ctypes.c_void_p(), _library.Summary(), ctypes.c_int()
    _library.call("dh_solve_proved" if proved else "dh_solve", system, r, beta, mu, digits, byref(address))
    handle = Handle(address, "dh_solution_destroy")
    _library.call("dh_solution_summary", address, byref(summary))
    _library.call("dh_solution_is_proved", address, byref(is_proved))
    listed = [_library.Mass() for _ in masses]
    for k, mass in zip(masses, listed):
        _library.call("dh_solution_mass", address, int(k), byref(mass))
    contact = _library.Mass()
    _library.call("dh_solution_contact", address, byref(contact))
    stops, stop_errors = np.empty((2, summary.stops)), np.empty((2, summary.stops))
    _library.call("dh_solution_stops", address, summary.stops, *map(_library.pointer, stops))
    _library.call("dh_solution_stop_errors", address, summary.stops, *map(_library.pointer, stop_errors))
    displacements = {name: np.array([getattr(m, name) for m in listed]) for name in ("amplitude", "error")}
    phases = {name: np.array([getattr(m, name) if m.moves else np.nan for m in listed]) for name in ("phase", "phase_error")}
    return Solution(
        r=r, beta=beta, mu=mu, regime=REGIMES[summary.regime], on_boundary=bool(summary.on_boundary), unique=bool(summary.unique),
        symmetric=bool(summary.symmetric), periods=summary.periods, stops=stops.T.copy(), stop_errors=stop_errors.T.copy(),
        rest_interval=(summary.rest_from, summary.rest_to) if summary.rest_interval_exists else None,
        rest_error=summary.rest_error, masses=masses.astype(int), amplitude=displacements["amplitude"],
        amplitude_error=displacements["error"], contact_amplitude=contact.amplitude,
        contact_phase=contact.phase if contact.moves else math.nan, contact_amplitude_error=contact.error,
        contact_phase_error=contact.phase_error if contact.moves else math.nan, relative_error=summary.relative_error,
        proved=bool(is_proved), _handle=handle, _N=N, **phases)


def boundary(system: ctypes.c_void_p, r: np.ndarray, mu: float, proved: bool) -> Boundary:
    """The friction ratios that part the regimes, of the shape of `r`, with the bounds of their errors."""
    rows = np.empty((2, 4) + r.shape)
    for at in np.ndindex(r.shape):
        found, errors = _library.Boundary(), _library.Boundary()
        point = system, float(r[at]), mu
        if proved:
            _library.call("dh_boundaries_proved", *point, byref(found), byref(errors))
        else:
            _library.call("dh_boundaries", *point, byref(found))
            _library.call("dh_boundary_errors", *point, byref(errors))
        for part, each in zip(rows, (found, errors)):
            part[(slice(None), *at)] = (each.exact, each.paper, each.approximate,
                                        each.sticking if each.sticking_exists else math.nan)
    values, bounds = ([like(row) for row in part] for part in rows)
    result = Boundary(*values)
    result.errors, result.proved = BoundaryNumbers(*bounds), proved
    return result


def functions(system: ctypes.c_void_p, N: int, r: np.ndarray) -> Functions:
    """The sums over the modes, with the bounds of their errors; the shape of `r` comes first."""
    def arrays(name: str) -> list[Real]:
        arrays = [np.empty(r.shape + (N,), complex), *(np.empty(r.shape + end) for end in ((N,), (N,), (1,), (1,)))]
        for at in np.ndindex(r.shape):
            _library.call(name, system, float(r[at]), N, *(_library.pointer(array[at]) for array in arrays))
        return arrays[:3] + [like(array[..., 0]) for array in arrays[3:]]

    result = Functions(*arrays("dh_sums"))
    result.errors = FunctionNumbers(*arrays("dh_sum_errors"))
    return result
